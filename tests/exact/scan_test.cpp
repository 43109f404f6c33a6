// The quick readers of lines against those that read by the JSON library: what the quick one takes, both read alike.
#include "exact/base/scan.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <filesystem>
#include <optional>
#include <string>

#include "exact/base/failure.h"
#include "exact/base/files.h"
#include "exact/base/foreign_json.h"
#include "exact/base/json.h"
#include "exact/cases/case_io.h"
#include "exact/cases/case_scan.h"
#include "exact/cases/families/draw.h"
#include "exact/trial/fuzz.h"

namespace tribunal {
namespace {

/// The case, or the message, by the JSON library alone.
struct Reading {
  std::optional<Case> read{};
  std::string message{};
};

Reading by_library(std::string_view line) {
  try {
    return {to_case(parse_json_beyond(line, {"f", 7}), {"f", 7}), ""};
  } catch (const Failure& f) {
    return {std::nullopt, f.what()};
  }
}

Reading by_reader(std::string_view line) {
  Case c;
  try {
    read_case(line, "f", 7, c);
    return {c, ""};
  } catch (const Failure& f) {
    return {std::nullopt, f.what()};
  }
}

/// All that a case says, numbers by their bits (as hex floats, which have a sign of zero).
std::string text_of(const Case& c) { return from_case(c).dump(-1, ' ', false, Json::error_handler_t::replace); }

/// Whether the quick reader took the line; both readers must say the same of it.
bool agree(const std::string& line) {
  Case quick;
  const bool taken = scan_case(line, quick);
  const Reading due = by_library(line), given = by_reader(line);
  EXPECT_EQ(given.message, due.message) << line;
  EXPECT_EQ(given.read.has_value(), due.read.has_value()) << line;
  if (given.read && due.read) {
    EXPECT_EQ(text_of(*given.read), text_of(*due.read)) << line;
  }
  if (taken) {
    EXPECT_TRUE(due.read.has_value()) << "the quick reader took what the library refuses: " << line << due.message;
    if (due.read) {
      EXPECT_EQ(text_of(quick), text_of(*due.read)) << line;
    }
  }
  return taken;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    if (end > begin) lines.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return lines;
}

std::vector<std::string> lines_of_corpora() {
  std::vector<std::string> lines;
  for (const auto& entry : std::filesystem::directory_iterator("data/cases")) {
    if (entry.path().extension() != ".jsonl") continue;
    for (const std::string& line : lines_of(read_file(entry.path().string()))) lines.push_back(line);
  }
  return lines;
}

/// Lines as the program writes them: of every family, with and without claims.
std::vector<std::string> lines_of_families() {
  std::vector<std::string> lines;
  for (const Operands operands : {Operands::triangles, Operands::polygons}) {
    for (const Stream& s : streams_of(operands)) {
      for (std::uint64_t k = 0; k < 24; ++k) {
        Case c{.id = std::string(s.family->name) + "-" + std::to_string(k), .format = s.format};
        c.query = s.family->make(s.format, 3, k).query;
        if (k % 2 == 0) c.expect = k % 4 == 0;
        if (k % 3 == 0) c.source = "family " + std::string(s.family->name) + ", case " + std::to_string(k);
        lines.push_back(from_case(c).dump());
      }
    }
  }
  return lines;
}

TEST(CaseScan, ReadsTheCorporaAsTheLibraryDoes) {
  const std::vector<std::string> corpora = lines_of_corpora(), families = lines_of_families();
  ASSERT_GE(corpora.size(), 700U);
  ASSERT_GE(families.size(), 1000U);
  std::size_t of_corpora = 0, of_families = 0;
  for (const std::string& line : corpora) of_corpora += agree(line);
  for (const std::string& line : families) of_families += agree(line);
  EXPECT_GE(of_corpora * 10, corpora.size() * 9) << "most lines are of the usual kind";
  EXPECT_EQ(of_families, families.size()) << "whatever the program writes is read quickly";
}

/// Lines by hand, each with something that one of the two readers might read otherwise.
TEST(CaseScan, ReadsUnusualLinesAsTheLibraryDoes) {
  const std::string tri = R"("tri":[[0,0,0],[1,0,0],[0,1,0]])", seg = R"("seg":[[0,0,1],[0,0,-1]])";
  const auto with = [&](const std::string& number) {
    return R"({"id":"a","seg":[[0,0,)" + number + "],[0,0,-1]]," + tri + "}";
  };
  for (const char* number : {"-0",
                             "-0.0",
                             "0.0",
                             "-0e5",
                             "0e999",
                             "00",
                             "01",
                             "-",
                             "+1",
                             ".5",
                             "1.",
                             "1.e5",
                             "1e",
                             "1e+",
                             "1e5",
                             "1E-5",
                             "1e22",
                             "1e23",
                             "9007199254740993",
                             "9007199254740992e22",
                             "9007199254740993e1",
                             "123456789012345678901234567890",
                             "0.1",
                             "0.30000000000000004",
                             "5e-324",
                             "2e-324",
                             "1e-400",
                             "1e308",
                             "1.7976931348623157e308",
                             "1.7976931348623159e308",
                             "1e309",
                             "-1e309",
                             "1e999",
                             "1e99999999999",
                             "18446744073709551615",
                             "18446744073709551616",
                             "-9223372036854775809",
                             "2.2250738585072011e-308",
                             "2.2250738585072014e-308",
                             "0.000000000000000000000000000000000000000000001",
                             "1 ",
                             " 1",
                             "1\t",
                             "\r-0",
                             "1x",
                             "NaN",
                             "nan",
                             "Infinity",
                             "true",
                             "null",
                             "[1]",
                             "\"\"",
                             "\"1.5\"",
                             "\"0x1\"",
                             "\"0x1p\"",
                             "\"0x1p0\"",
                             "\"0x1p+0\"",
                             "\"-0x0p+0\"",
                             "\"+0x1p+0\"",
                             "\"0X1P+0\"",
                             "\"0x1.p+0\"",
                             "\"0x.8p+1\"",
                             "\"0x1.8p+1\"",
                             "\"0x1.8P+1\"",
                             "\"0x1.Ap1\"",
                             "\"0x1.fffffffffffffp+1023\"",
                             "\"0x1p+1024\"",
                             "\"0x1p-1022\"",
                             "\"0x1p-1023\"",
                             "\"0x1p-1074\"",
                             "\"0x1p-1075\"",
                             "\"0x0.0000000000001p-1022\"",
                             "\"0x1.00000000000008p+0\"",
                             "\"0x1.00000000000018p+0\"",
                             "\"0x2p+0\"",
                             "\"0x1ep+0\"",
                             "\"0x0p-9999\"",
                             "\"0x0p+99999\"",
                             "\"0x1p+00001\"",
                             "\"0x1p+99999\"",
                             "\"0xinf\"",
                             "\"0xnan\"",
                             "\"inf\"",
                             "\"nan\"",
                             "\"-inf\"",
                             "\"0x1p+0 \"",
                             "\" 0x1p+0\"",
                             "\"0x1p+0",
                             "\"0x1.8p+1\\u0000\""}) {
    agree(with(number));
    agree(R"({"id":"a","fmt":"binary32",)" + with(number).substr(10));
  }
  for (const std::string& line : std::vector<std::string>{
           "{\"id\":\"a\"," + seg + "," + tri + "}",
           "{" + tri + "," + seg + ",\"id\":\"a\"}",
           " { \"id\" : \"a\" , " + seg + "\t,\r" + tri + " } ",
           "{\"id\":\"a\"," + seg + "," + tri + "} x",
           "{\"id\":\"a\"," + seg + "," + tri + ",}",
           "{\"id\":\"a\"," + seg + "," + tri,
           "{}",
           "",
           "{",
           "[]",
           "1",
           "{\"id\":\"a\",\"id\":\"b\"," + seg + "," + tri + "}",
           "{\"id\":\"\"," + seg + "," + tri + "}",
           "{\"id\":\"\\u0061\"," + seg + "," + tri + "}",
           "{\"id\":\"ä\"," + seg + "," + tri + "}",
           "{\"id\":\"\xff\"," + seg + "," + tri + "}",
           std::string("{\"id\":\"a\x7f\x01\",") + seg + "," + tri + "}",
           "{\"i\\u0064\":\"a\"," + seg + "," + tri + "}",
           "{\"id\":7," + seg + "," + tri + "}",
           "{\"id\":\"a\",\"expect\":1," + seg + "," + tri + "}",
           "{\"id\":\"a\",\"expect\":1.0," + seg + "," + tri + "}",
           "{\"id\":\"a\",\"expect\":01," + seg + "," + tri + "}",
           "{\"id\":\"a\",\"expect\":10," + seg + "," + tri + "}",
           "{\"id\":\"a\",\"expect\":true," + seg + "," + tri + "}",
           "{\"id\":\"a\",\"expect\":1 ," + seg + "," + tri + "}",
           "{\"id\":\"a\",\"class\":\"C017\"," + seg + "," + tri + "}",
           "{\"id\":\"a\",\"class\":\"C000\"," + seg + "," + tri + "}",
           "{\"id\":\"a\",\"fmt\":\"binary16\"," + seg + "," + tri + "}",
           "{\"id\":\"a\",\"source\":\"\"," + seg + "," + tri + "}",
           "{\"id\":\"a\",\"source\":1," + seg + "," + tri + "}",
           "{\"id\":\"a\",\"finding\":{\"x\":[1]}," + seg + "," + tri + "}",
           "{\"id\":\"a\",\"finding\":null," + seg + "," + tri + "}",
           "{\"id\":\"a\",\"seg\":[[0,0,1],[0,0,-1],[0,0,0]]," + tri + "}",
           "{\"id\":\"a\",\"ray\":{\"o\":[0,0,1],\"d\":[0,0,-1]}," + seg + "," + tri + "}",
           "{\"id\":\"a\",\"ray\":{\"o\":[0,0,1],\"d\":[0,0,-1]}," + tri + "}",
           "{\"id\":\"a\",\"ray\":{\"d\":[0,0,-1],\"o\":[0,0,1],\"t\":[0,\"inf\"]}," + tri + "}",
           "{\"id\":\"a\",\"ray\":{\"o\":[0,0,1],\"d\":[0,0,-1],\"t\":[\"0x1p+0\",2]}," + tri + "}",
           "{\"id\":\"a\",\"ray\":{\"o\":[0,0,1],\"d\":[0,0,-1],\"t\":[2,1]}," + tri + "}",
           "{\"id\":\"a\",\"ray\":{\"o\":[0,0,1],\"d\":[0,0,-1],\"t\":[-1,1]}," + tri + "}",
           "{\"id\":\"a\",\"ray\":{\"o\":[0,0,1],\"d\":[0,0,-1],\"t\":[-0,1]}," + tri + "}",
           "{\"id\":\"a\",\"ray\":{\"o\":[0,0,1],\"d\":[0,0,-1],\"t\":[0,\"Inf\"]}," + tri + "}",
           "{\"id\":\"a\",\"ray\":{\"o\":[0,0,1],\"d\":[0,0,-1],\"o\":[0,0,1]}," + tri + "}",
           "{\"id\":\"a\",\"ray\":{\"o\":[0,0,1]}," + tri + "}",
           "{\"id\":\"a\",\"ray\":{\"o\":[0,0,1],\"d\":[0,0,-1],\"x\":1}," + tri + "}",
           "{\"id\":\"a\"," + seg + ",\"rings\":[[[0,0,0],[1,0,0],[0,1,0]],[[0,0,0]]]}",
           "{\"id\":\"a\"," + seg + ",\"rings\":[[[0,0,0],[1,0,0],[0,1,0]]],\"class\":\"C017\"}",
           "{\"id\":\"a\"," + seg + ",\"rings\":[]}",
           "{\"id\":\"a\"," + seg + ",\"rings\":[[]]}",
           "{\"id\":\"a\"," + seg + "," + tri + ",\"rings\":[[[0,0,0]]]}",
           "{\"id\":\"a\",\"ray\":{\"o\":[0,0,1],\"d\":[0,0,-1],\"t\":[0,1]},\"rings\":[[[0,0,0]]]}"}) {
    agree(line);
  }
}

/// Bytes changed, removed, put in twice, put in from elsewhere: four of each line and more of the shorter ones.
TEST(CaseScan, ReadsMutatedLinesAsTheLibraryDoes) {
  std::vector<std::string> lines = lines_of_corpora();
  for (const std::string& line : lines_of_families()) {
    if (line.size() < 1500) lines.push_back(line);
  }
  const std::string tokens = "0123456789abcdefxpPE+-.,:[]{}\"\\ \t\r\n\x01\x7f\x80\xff";
  Draw draw(17, 1, 0);
  std::size_t taken = 0, mutants = 0;
  for (const std::string& line : lines) {
    for (int i = 0; i < 12; ++i) {
      std::string mutant = line;
      for (int changes = 0; changes <= i % 3; ++changes) {
        const std::size_t at = draw.next() % mutant.size(), kind = draw.next() % 5;
        const char token = tokens[draw.next() % tokens.size()];
        if (kind == 0) mutant[at] = token;
        if (kind == 1) mutant[at] = static_cast<char>(mutant[at] ^ (1 << draw.next() % 8));
        if (kind == 2) mutant.erase(at, 1 + draw.next() % 3);
        if (kind == 3) mutant.insert(at, 1, token);
        if (kind == 4) mutant.insert(at, mutant.substr(draw.next() % mutant.size(), draw.next() % 30));
        if (mutant.empty()) mutant = "{";
      }
      if (mutant.find('\n') != std::string::npos) continue;
      ++mutants;
      taken += agree(mutant);
      ASSERT_FALSE(HasFailure());
    }
  }
  EXPECT_GE(mutants, 15'000U);
  EXPECT_GE(taken * 20, mutants) << "mutants that are still cases are seen too";
  EXPECT_GE((mutants - taken) * 3, mutants);
}

double scanned(const std::string& number) {
  Scanner s(number);
  double x = 0.5;
  EXPECT_TRUE(s.number(x) && s.at_end()) << number;
  return x;
}

std::uint64_t bits_of(double x) { return std::bit_cast<std::uint64_t>(x); }

TEST(Scanner, NumbersAreThoseOfTheLibrary) {
  Draw draw(18, 1, 0);
  for (int i = 0; i < 100'000; ++i) {
    const double x = std::bit_cast<double>(draw.next());
    if (!std::isfinite(x)) continue;
    ASSERT_EQ(bits_of(scanned("\"" + hex_float(x) + "\"")), bits_of(x)) << hex_float(x);
    char text[64];
    std::snprintf(text, sizeof text, "%.*g", static_cast<int>(1 + draw.next() % 19), x);
    const double due = std::strtod(text, nullptr);
    if (std::isfinite(due)) {
      ASSERT_EQ(bits_of(scanned(text)), bits_of(due)) << text;
    }
    // About the limits of the product of two exact doubles: 2^53 and 10^22.
    const std::string near = std::to_string((std::uint64_t{1} << 53) - 8 + draw.next() % 16) + "e" +
                             std::to_string(static_cast<int>(draw.next() % 60) - 30);
    ASSERT_EQ(bits_of(scanned(near)), bits_of(std::strtod(near.c_str(), nullptr))) << near;
  }
}

TEST(Scanner, RefusesWhatIsNoNumber) {
  for (const char* text :
       {"", "-", "a", "1e", "1.", ".1", "\"0x\"", "\"x\"", "\"0x1", "1e999", "\"0x1p+1024\"", "\"inf\""}) {
    Scanner s(text);
    double x = 0;
    EXPECT_FALSE(s.number(x) && s.at_end()) << text;
  }
}

}  // namespace
}  // namespace tribunal
