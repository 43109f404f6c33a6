// Text from elsewhere: what a terminal, a line, Markdown and HTML are given of it.
#include "exact/base/shown.h"

#include <gtest/gtest.h>

#include <string>

#include "exact/base/failure.h"
#include "exact/base/json.h"

namespace tribunal {
namespace {

using namespace std::string_literals;

/// One byte below 32 and not a line feed, DEL, or what U+0080 to U+009F, directions and the byte-order mark begin with.
bool steers(const std::string& text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    if (byte < 0x20 || byte == 0x7f) return true;
    if (byte == 0xc2 && i + 1 < text.size() && static_cast<unsigned char>(text[i + 1]) < 0xa0) return true;
  }
  for (const char* hidden :
       {"\u061c", "\u200e", "\u200f", "\u2028", "\u2029", "\u202a", "\u202e", "\u2066", "\u2069", "\ufeff"}) {
    if (text.find(hidden) != std::string::npos) return true;
  }
  return false;
}

TEST(Shown, WhatShowsStays) {
  for (const char* text :
       {"", "plain", "a\\b \"c\" 'd'", "naïve — 163 ≤ 165", "日本語", "😀", "\u00a0", "\u2027\u202f"}) {
    EXPECT_EQ(shown(text), text);
    EXPECT_TRUE(shows_as_it_is(text)) << text;
  }
}

TEST(Shown, WhatSteersBecomesAnEscape) {
  EXPECT_EQ(shown("a\x1b[31mb"), "a\\u001b[31mb");
  EXPECT_EQ(shown("one\ntwo\r\tthree"), "one\\u000atwo\\u000d\\u0009three");
  EXPECT_EQ(shown("nul\0byte"s), "nul\\u0000byte");
  EXPECT_EQ(shown("\x7f"), "\\u007f");
  EXPECT_EQ(shown("\u0080\u009b\u009f"), "\\u0080\\u009b\\u009f");
  EXPECT_EQ(shown("\u202egnp.exe\u2066\u2069"), "\\u202egnp.exe\\u2066\\u2069");
  EXPECT_EQ(shown("\ufeffx"), "\\ufeffx");
}

TEST(Shown, WhatShowsAsNothingBecomesAnEscape) {
  EXPECT_EQ(shown("a\u200bb\u200dc\u00ad\u180e\u2060"), "a\\u200bb\\u200dc\\u00ad\\u180e\\u2060");
  EXPECT_EQ(shown("\ufff9\ufffb\uffff\ufdd0\ufe0f\ue000"), "\\ufff9\\ufffb\\uffff\\ufdd0\\ufe0f\\ue000");
  EXPECT_EQ(shown("\U000e0041\U0001fffe\U00100000"), "\\U000e0041\\U0001fffe\\U00100000");
  EXPECT_EQ(shown("\ufffd\U0001fffd"), "\ufffd\U0001fffd") << "U+FFFD shows";
}

TEST(Shown, EachByteThatIsNoUtf8BecomesAnEscape) {
  EXPECT_EQ(shown("\xff"), "\\xff");
  EXPECT_EQ(shown("\xc3("), "\\xc3(") << "cut before its end";
  EXPECT_EQ(shown("\xe2\x80"), "\\xe2\\x80");
  EXPECT_EQ(shown("\xc0\x8a"), "\\xc0\\x8a") << "a line feed, longer than needed";
  EXPECT_EQ(shown("\xe0\x80\x8a\xf0\x80\x80\x8a"), "\\xe0\\x80\\x8a\\xf0\\x80\\x80\\x8a");
  EXPECT_EQ(shown("\xed\xa0\x80"), "\\xed\\xa0\\x80") << "half a surrogate";
  EXPECT_EQ(shown("\xf4\x90\x80\x80\xf5"), "\\xf4\\x90\\x80\\x80\\xf5") << "beyond U+10FFFF";
  EXPECT_EQ(shown("\x9b"), "\\x9b") << "a control character of Latin-1";
}

TEST(Shown, IsUtf8WithNothingThatSteersAndItsOwnImage) {
  std::string text;
  for (int repeat = 0; repeat < 2; ++repeat) {
    for (int byte = 0; byte < 256; ++byte) {
      for (int next : {0x0a, 0x41, 0x80, 0x9b, 0xa8, 0xae, 0xbf, byte}) {
        text += static_cast<char>(byte);
        if (repeat == 1) text += '\x80';
        text += static_cast<char>(next);
      }
    }
  }
  const std::string image = shown(text);
  EXPECT_FALSE(steers(image));
  EXPECT_EQ(image.find('\n'), std::string::npos);
  EXPECT_EQ(shown(image), image);
  EXPECT_NO_THROW(Json(image).dump()) << "UTF-8";
  EXPECT_FALSE(steers(in_markdown(text)));
}

TEST(Shown, AJsonTextKeepsItsValue) {
  const Json value = {{"id", "\u202e\u009b\x7f\x1b\n\ufeff"}, {"\u2028", 1}};
  const std::string line = shown_lines(value.dump() + "\n");
  EXPECT_EQ(line.back(), '\n');
  EXPECT_FALSE(steers(line.substr(0, line.size() - 1)));
  EXPECT_EQ(parse_json(line, {"test"}), value);
}

TEST(Shown, LinesAndTabsStandInTextsOfSeveralLines) {
  EXPECT_EQ(shown_lines("a\n\tb\x1b\r\n"), "a\n\tb\\u001b\\u000d\n");
}

TEST(Shown, ATextThatGoesOnIsCutBetweenCharacters) {
  const std::string text = "a€😀é\xff\xc3";
  for (const auto& [size, whole] :
       {std::pair{1, 1}, {2, 1}, {3, 1}, {4, 4}, {5, 4}, {7, 4}, {8, 8}, {9, 8}, {10, 10}, {11, 11}, {12, 11}}) {
    EXPECT_EQ(whole_characters(std::string_view(text).substr(0, static_cast<std::size_t>(size))),
              static_cast<std::size_t>(whole))
        << size;
  }
  EXPECT_EQ(whole_characters(""), 0U);
  EXPECT_EQ(whole_characters("\x80\x80\x80\x80"), 4U) << "no character begins";
}

TEST(Shown, LongTextsLoseTheirMiddle) {
  const std::string text = "file.jsonl:3: " + std::string(10'000, 'x') + ", expected less";
  const std::string line = shown_shortly(text, 1000);
  EXPECT_LE(line.size(), 1010U);
  EXPECT_TRUE(line.starts_with("file.jsonl:3: xxx") && line.ends_with("xxx, expected less")) << line;
  EXPECT_EQ(shown_shortly("short", 1000), "short");
  std::string wide;
  for (int i = 0; i < 1000; ++i) wide += "€";
  for (std::size_t most = 40; most < 44; ++most) {
    EXPECT_EQ(shown(shown_shortly(wide, most)), shown_shortly(wide, most)) << "cut between characters";
  }
}

TEST(Shown, MarkdownIsGivenNoMarkup) {
  EXPECT_EQ(in_markdown("<script>alert(1)</script>"), "&lt;script&gt;alert(1)&lt;/script&gt;");
  EXPECT_EQ(in_markdown("a|b `c` [d](e) *f* ~~g~~ &amp; \\"),
            "a\\|b \\`c\\` \\[d\\](e) \\*f\\* \\~\\~g\\~\\~ &amp;amp; \\\\");
  EXPECT_EQ(in_markdown("_a_ b_c"), "\\_a\\_ b_c");
  EXPECT_EQ(in_markdown("x\n# y"), "x\\\\u000a# y");
  EXPECT_EQ(in_markdown("plain, 95 % of C017"), "plain, 95 % of C017");
}

TEST(Shown, NamesObeyOneRule) {
  for (const char* name : {"a", "mt-double", "My_test.2", "abcdefghijklmnopqrstuvwxyz012345"}) {
    EXPECT_TRUE(is_name(name)) << name;
  }
  for (const char* other :
       {"", "2fast", "-x", "a b", "a\nb", "<b>", "a/b", "naïve", "a|b", "abcdefghijklmnopqrstuvwxyz0123456"}) {
    EXPECT_FALSE(is_name(other)) << other;
  }
}

TEST(Shown, AnErrorOfAFileIsOneLineThatIsWhole) {
  try {
    Where{"f", 3, "id"}.fail("a\0b\nc\x1b, expected less"s);
    FAIL();
  } catch (const Failure& failure) {
    EXPECT_STREQ(failure.what(), "f:3: id: a\\u0000b\\u000ac\\u001b, expected less");
  }
}

}  // namespace
}  // namespace tribunal
