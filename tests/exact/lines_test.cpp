// Texts in blocks, in spools, and worked on in order: whatever their length and the number of threads.
#include "exact/base/lines.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "exact/base/failure.h"
#include "exact/base/in_order.h"
#include "exact/base/shown.h"
#include "exact/base/spool.h"
#include "exact/cases/families/draw.h"
#include "exact/record/id_index.h"

namespace tribunal {
namespace {

using Numbered = std::vector<std::pair<std::string, std::size_t>>;

/// The lines that are not blank, by splitting the text.
Numbered split(const std::string& text) {
  Numbered lines;
  std::size_t number = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string line = text.substr(begin, end - begin);
    begin = end + 1;
    ++number;
    if (line.find_first_not_of(" \t\r") != std::string::npos) lines.emplace_back(line, number);
  }
  return lines;
}

/// The same by a reader that is given few bytes at a time.
Numbered read(const std::string& text, std::size_t bytes_at_once, std::size_t most_lines, std::size_t enough_bytes) {
  const LineReader::Source all = bytes_in(text);
  LineReader reader([&](char* buffer, std::size_t size) { return all(buffer, std::min(size, bytes_at_once)); });
  Numbered lines;
  for (LineBlock block; reader.next(block, most_lines, enough_bytes);) {
    EXPECT_LE(block.lines, most_lines);
    std::size_t counted = 0;
    block.for_each("f", [&](std::string_view line, std::size_t number) {
      lines.emplace_back(line, number);
      ++counted;
    });
    EXPECT_EQ(counted, block.lines);
  }
  return lines;
}

TEST(Lines, AreThoseOfTheTextInBlocksOfAnySize) {
  Draw draw(21, 1, 0);
  for (int i = 0; i < 300; ++i) {
    std::string text;
    for (std::size_t n = draw.next() % 200; n > 0; --n) text += "ab\n\n\n \t\r"[draw.next() % 8];
    const Numbered due = split(text);
    for (const std::size_t bytes : {1, 7, 1000}) {
      EXPECT_EQ(read(text, bytes, 1, 1 << 20), due) << text;
      EXPECT_EQ(read(text, bytes, 3, 5), due) << text;
      EXPECT_EQ(read(text, bytes, 1000, 1 << 20), due) << text;
    }
  }
}

std::string failure_in(const std::string& text) {
  try {
    read(text, 1 << 16, 1000, 1 << 18);
  } catch (const Failure& f) {
    return f.what();
  }
  return "(none)";
}

TEST(Lines, OfMoreThanAMebibyteAreRefusedUnlessBlank) {
  const std::string longest(max_line, 'x'), blanks(3 * max_line, ' ');
  EXPECT_EQ(read("a\n" + longest + "\nb", 1 << 16, 1000, 1 << 18).size(), 3U);
  EXPECT_EQ(failure_in("a\n" + longest + "x\nb"), "f:2: line longer than 1 MiB, expected one JSON object");
  EXPECT_EQ(failure_in("a\n\n" + longest + "x"), "f:3: line longer than 1 MiB, expected one JSON object");
  EXPECT_EQ(failure_in("a\n" + blanks + "x\nb"), "f:2: line longer than 1 MiB, expected one JSON object");
  EXPECT_EQ(read("a\n" + blanks + "\nb", 1 << 16, 1000, 1 << 18), (Numbered{{"a", 1}, {"b", 3}}));
}

TEST(Spool, HoldsWhatWasWrittenInMemoryAndOnDisk) {
  Draw draw(22, 1, 0);
  for (const std::size_t memory : {0, 10, 1000, 1 << 20}) {
    Spool spool(memory);
    std::string due;
    for (int i = 0; i < 500; ++i) {
      const std::string piece(draw.next() % 2000, static_cast<char>('a' + i % 26));
      spool.write(piece + "\n");
      due += piece + "\n";
    }
    EXPECT_EQ(spool.size(), due.size());
    std::string all;
    spool.for_each_piece([&](std::string_view piece) {
      EXPECT_EQ(piece.back(), '\n');
      all += piece;
    });
    EXPECT_EQ(all, due);
    for (int i = 0; i < 200; ++i) {
      const std::size_t offset = draw.next() % (due.size() + 10), size = draw.next() % 5000;
      EXPECT_EQ(spool.at(offset, size), offset < due.size() ? due.substr(offset, size) : "");
    }
    const Spool moved = std::move(spool);
    EXPECT_EQ(moved.at(0, 100), due.substr(0, 100));
  }
}

/// A line without an end within a piece is cut between characters, so that each piece shows as the whole does.
TEST(Spool, NoPieceCutsACharacter) {
  for (const std::string_view character : {"\xc3\xa9", "\xe2\x82\xac", "\xf0\x9f\x98\x80"}) {
    for (const std::size_t before : {0, 1, 2, 3}) {
      Spool spool(1000);
      std::string due(before, 'x');
      while (due.size() < 800'000) due += character;
      spool.write(due);
      std::string all;
      int pieces = 0;
      spool.for_each_piece([&](std::string_view piece) {
        EXPECT_TRUE(shows_as_it_is(piece));
        all += piece;
        ++pieces;
      });
      EXPECT_TRUE(all == due);
      EXPECT_GT(pieces, 1);
    }
  }
  Spool bytes(1000);
  bytes.write(std::string(800'000, '\x80'));  // no characters at all
  std::size_t size = 0;
  bytes.for_each_piece([&](std::string_view piece) { size += piece.size(); });
  EXPECT_EQ(size, 800'000U);
}

TEST(Lines, OfAnyLengthStandAsTheyAre) {
  const std::string longest(3 * max_line, 'x');
  const auto lines_of = [](const std::string& text) {
    Spool spool(100);
    spool.write(text);
    std::vector<std::string> in_text, in_spool;
    for_each_line_of(bytes_in(text), [&](std::string_view line) { in_text.emplace_back(line); });
    for_each_line_of(bytes_in(spool), [&](std::string_view line) { in_spool.emplace_back(line); });
    EXPECT_TRUE(in_text == in_spool);
    return in_text;
  };
  EXPECT_TRUE(lines_of("").empty());
  EXPECT_TRUE(lines_of("a\n\n" + longest + "\nb") == (std::vector<std::string>{"a", "", longest, "b"}));
  EXPECT_TRUE(lines_of("\n" + longest + "\n") == (std::vector<std::string>{"", longest}));
}

TEST(InOrder, ResultsComeInTheOrderOfTheItems) {
  for (const unsigned threads : {1U, 2U, 7U}) {
    int next = 0;
    std::vector<int> taken;
    run_in_order<int, int>(
        threads, "", [&](int& item) { return (item = next++) < 1000; },
        [](int item, int& result) { result = 3 * item; }, [&](int result) { taken.push_back(result); });
    ASSERT_EQ(taken.size(), 1000U);
    for (int i = 0; i < 1000; ++i) EXPECT_EQ(taken[static_cast<std::size_t>(i)], 3 * i);
  }
}

/// Items 500 and 600 fail in working, 700 in reading; 400 in taking if asked for.
int first_failure(unsigned threads, bool in_taking, std::size_t& taken) {
  int next = 0;
  taken = 0;
  try {
    run_in_order<int, int>(
        threads, "",
        [&](int& item) {
          if (next == 700) throw 700;
          item = next++;
          return true;
        },
        [](int item, int& result) {
          if (item == 500 || item == 600) throw item;
          result = item;
        },
        [&](int result) {
          if (in_taking && result == 400) throw result;
          ++taken;
        });
  } catch (int failure) {
    return failure;
  }
  return 0;
}

TEST(InOrder, TheFirstFailureInTheirOrderIsTheOneThatCounts) {
  for (const unsigned threads : {1U, 2U, 7U}) {
    for (int i = 0; i < 50; ++i) {
      std::size_t taken = 0;
      EXPECT_EQ(first_failure(threads, false, taken), 500);
      EXPECT_EQ(taken, 500U);
      EXPECT_EQ(first_failure(threads, true, taken), 400);
      EXPECT_EQ(taken, 400U);
    }
  }
}

TEST(IdIndex, FindsEveryIdAndTheFirstThatComesAgain) {
  IdIndex index;
  IdSpools spools;
  std::set<Fingerprint> all;
  const auto add = [&](const std::string& id) {
    all.insert(fingerprint_of(id));
    index.add(fingerprint_of(id));
    spools.add(fingerprint_of(id));
  };
  for (int i = 0; i < 200'000; ++i) add("case-" + std::to_string(i));
  for (int i = 0; i < 300; ++i) add(std::string(static_cast<std::size_t>(i), '\0'));
  EXPECT_EQ(all.size(), 200'300U) << "short ids that differ in length or one digit have different fingerprints";
  IdIndex sorted = index;
  EXPECT_FALSE(sorted.sort().has_value());
  EXPECT_FALSE(spools.first_repeated().has_value());
  EXPECT_EQ(sorted.find(fingerprint_of("case-123456")), std::optional<std::uint32_t>(123'456));
  EXPECT_FALSE(sorted.find(fingerprint_of("case-200000")).has_value());
  for (const int again : {77'777, 5, 77'777, 199'999}) add("case-" + std::to_string(again));
  for (const auto& same : {index.sort(), spools.first_repeated()}) {
    ASSERT_TRUE(same.has_value());
    EXPECT_EQ(same->first, 77'777U);
    EXPECT_EQ(same->second, 200'300U);
  }
}

}  // namespace
}  // namespace tribunal
