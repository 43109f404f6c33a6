// The tokenizer: which tokens, on which line, in which column.
#include "exact/mesh/text.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/tracer/support.h"

namespace tribunal {
namespace {

const std::string file = "t";

/// All tokens of a text, with bars between the lines; lines without tokens are left out.
std::string walked(std::string_view text, TextStyle style = {}) {
  Text in(file, text, style);
  std::string all;
  while (in.next_line()) {
    all += "|" + std::to_string(in.line()) + ":";
    while (in.has_token()) all += " " + std::string(in.token());
  }
  return all;
}

TEST(Text, SplitsLinesIntoTokens) {
  EXPECT_EQ(walked("a  b\tc\r\n\n \t\r\n  d\ve\f"), "|1: a b c|4: d e");
  EXPECT_EQ(walked("a # b\n#c\nd#e"), "|1: a|3: d");
  EXPECT_EQ(walked("a # b\n#c", {'\0'}), "|1: a # b|2: #c");
  EXPECT_EQ(walked(""), "");
  EXPECT_EQ(walked("\n\n"), "");
}

TEST(Text, JoinsLinesThatEndInABackslash) {
  const TextStyle joining{'#', true};
  EXPECT_EQ(walked("f 1 2 \\\n 3\ng", joining), "|1: f 1 2 3|3: g");
  EXPECT_EQ(walked("f 1 2\\\r\n3 \\\n\\\n4\ng", joining), "|1: f 1 2 3 4|5: g");
  EXPECT_EQ(walked("\\\nf 1", joining), "|2: f 1") << "the line of the first token";
  EXPECT_EQ(walked("f \\ 1", joining), "|1: f \\ 1");
  EXPECT_EQ(walked("f 1 \\", joining), "|1: f 1");
  EXPECT_EQ(walked("\\", joining), "");
  EXPECT_EQ(walked("# c:\\dir\\\nf 1", joining), "|2: f 1") << "a comment ends with its line";
  EXPECT_EQ(walked("f 1 \\\n2"), "|1: f 1 \\|2: 2") << "only where the format joins lines";
}

TEST(Text, SkipsWhatIsLeftOfAJoinedLine) {
  Text in(file, "a b \\\n c \\\n d\ne", {'#', true});
  ASSERT_TRUE(in.next_line());
  EXPECT_EQ(in.token(), "a");
  ASSERT_TRUE(in.next_line());
  EXPECT_EQ(in.token(), "e");
  EXPECT_EQ(in.line(), 4u);
}

TEST(Text, TellsThePlaceOfAToken) {
  Text in(file, "v 1 x\nv  2 \\\n  y\n", {'#', true});
  in.require_line("a line");
  in.token(), in.token();
  const std::string first = testing::refusal_of([&] { in.coordinate(); });
  EXPECT_EQ(first, "t:1: \"x\" is not a decimal number, expected a finite decimal coordinate, at column 5");
  const std::string end = testing::refusal_of([&] { in.coordinate(); });
  EXPECT_EQ(end, "t:1: the line ends, expected a finite decimal coordinate, at column 6");
  in.require_line("a line");
  in.token(), in.token();
  const std::string joined = testing::refusal_of([&] { in.integer("a count"); });
  EXPECT_EQ(joined, "t:3: \"y\", expected a count, at column 3");
  EXPECT_EQ(testing::refusal_of([&] { in.require_line("more"); }), "t:3: file ends early, expected more");
}

TEST(Text, TellsTheLineOfANulByte) {
  EXPECT_EQ(testing::refusal_of([] { require_text(file, std::string_view("a\nb\0c", 5)); }),
            "t:2: has a NUL byte, expected text");
}

TEST(Text, QuotesWhatIsShortAndPrintable) {
  EXPECT_EQ(in_quotes("a\x01\x7f"), "\"a\\u0001\\u007f\"");
  EXPECT_EQ(in_quotes(std::string(1 << 20, 'x')), "\"" + std::string(32, 'x') + "…\"");
}

}  // namespace
}  // namespace tribunal
