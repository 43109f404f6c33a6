// Files: exact numbers, round trips, and one clear line for every kind of bad input.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>

#include "exact/base/failure.h"
#include "exact/base/files.h"
#include "exact/base/foreign_json.h"
#include "exact/base/fp_environment.h"
#include "exact/base/output.h"
#include "exact/cases/case_io.h"
#include "exact/cases/families/draw.h"
#include "exact/classes/class_table.h"
#include "exact/methods/methods.h"
#include "tests/exact/comma_locale.h"

namespace tribunal {
namespace {

double read_number(const std::string& json, Format format = Format::binary64) {
  return to_number(parse_json(json, {"test"}), format, {"test"});
}

TEST(Numbers, HexFloatsAndDecimalsAreReadExactly) {
  EXPECT_EQ(read_number("\"0x1.8p+1\""), 3);
  EXPECT_EQ(read_number("\"-0x1p-1074\""), -0x1p-1074);
  EXPECT_EQ(read_number("\"0x0." + std::string(300, '0') + "1p+10\""), 0) << "too small, by its digits";
  EXPECT_EQ(read_number("\"0x0.0000000000001p-1022\""), 0x1p-1074) << "as printf writes it";
  EXPECT_EQ(read_number("\"0x1.fffffffffffffp+1023\""), std::numeric_limits<double>::max());
  EXPECT_TRUE(std::signbit(read_number("\"-0x0p+0\"")));
  EXPECT_EQ(read_number("0.1"), 0.1);
  EXPECT_EQ(read_number("5e-324"), 0x1p-1074);
  EXPECT_EQ(read_number("0." + std::string(399, '3')), 1.0 / 3);
  EXPECT_EQ(read_number("9007199254740993"), 9007199254740992.0) << "ties to even";
  EXPECT_EQ(read_number("0.5", Format::binary32), 0.5);
}

TEST(Numbers, WhatIsNotFiniteIsATokenOfCasesAlone) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  const auto read = [](const std::string& json, Format format) {
    return to_any_number(parse_json_beyond(json, {"test"}), format, {"test"});
  };
  const std::string many(400, '1');
  for (const Format format : {Format::binary64, Format::binary32}) {
    for (const std::string& token : std::vector<std::string>{
             "\"inf\"", "\"+inf\"", "\"Infinity\"", "\"INF\"", "1e999", "1e309", "1.8e308", "1E+400", "\"0x1p+1024\"",
             "\"0x1.fffffffffffff8p+1023\"", "\"0x1" + std::string(300, '0') + "p-1\"", "100000e99999999999999999999",
             "0.00001e999"}) {
      EXPECT_EQ(read(token, format), inf) << token;
      EXPECT_THROW(to_number(parse_json_beyond(token, {"test"}), format, {"test"}), Failure) << token;
      EXPECT_THROW(read_number(token, format), Failure) << token;
    }
    EXPECT_EQ(read(many, format), inf);
    EXPECT_EQ(read(many + ".5", format), inf);
    for (const std::string& token : std::vector<std::string>{"\"-inf\"", "\"-infinity\"", "-1e999", "\"-0x1p+2000\""}) {
      EXPECT_EQ(read(token, format), -inf) << token;
    }
    for (const std::string& token : std::vector<std::string>{"\"nan\"", "\"NaN\"", "\"-nan\"", "\"+NAN\""}) {
      EXPECT_TRUE(std::isnan(read(token, format))) << token;
    }
    for (const std::string& token :
         std::vector<std::string>{"0e999", "1e-999", "0.0e99999999999999999999", "1e-99999999999999999999",
                                  "0." + std::string(400, '0') + "1e10"}) {
      EXPECT_EQ(read(token, format), 0) << token;
    }
    for (const char* token :
         {"\"\"", "\"in\"", "\"--inf\"", "\"infinite\"", "\"inf \"", "\"nan(1)\"", "true", "null", "[]"}) {
      EXPECT_THROW(read(token, format), Failure) << token;
    }
  }
  EXPECT_EQ(read("1" + std::string(308, '0'), Format::binary64), 1e308);
  EXPECT_EQ(read(many + "e-300", Format::binary64), 1.1111111111111111e99) << "long, and within the range";
  EXPECT_EQ(read("1e39", Format::binary64), 1e39);
  EXPECT_THROW(read("1e39", Format::binary32), Failure) << "finite, and not exact in binary32";
}

TEST(Numbers, OfOneTextAreEachReadAsTheyStand) {
  const Json value = parse_json_beyond(
      R"({"1e999":[-0, 1e999, "1e999 \" -0", -1e999, 0, {"-0":-0, "x":1E999}],"y":1.5e308})", {"test"});
  constexpr double inf = std::numeric_limits<double>::infinity();
  const Json& list = value["1e999"];
  EXPECT_TRUE(std::signbit(list[0].get<double>()) && list[0] == 0);
  EXPECT_EQ(list[1].get<double>(), inf);
  EXPECT_EQ(list[2], "1e999 \" -0");
  EXPECT_EQ(list[3].get<double>(), -inf);
  EXPECT_EQ(list[4], 0);
  EXPECT_TRUE(std::signbit(list[5]["-0"].get<double>()));
  EXPECT_EQ(list[5]["x"].get<double>(), inf);
  EXPECT_EQ(value["y"], 1.5e308);
}

TEST(Numbers, WhatIsNotFiniteIsWrittenAsItIsRead) {
  for (const double x : {std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()}) {
    EXPECT_EQ(to_any_number(Json(hex_float(x)), Format::binary64, {"test"}), x);
  }
  EXPECT_EQ(hex_float(std::nan("")), "nan");
}

TEST(Numbers, EveryDoubleSurvivesTheRoundTrip) {
  Draw draw(8, 1, 0);
  for (int i = 0; i < 20'000; ++i) {
    const auto bits = draw.next();
    const double x = std::bit_cast<double>(bits);
    if (!std::isfinite(x)) continue;
    ASSERT_EQ(std::bit_cast<std::uint64_t>(read_number("\"" + hex_float(x) + "\"")), bits) << hex_float(x);
  }
}

TEST(Numbers, AreReadTheSameInEveryLocale) {
  const CommaLocale comma;
  ASSERT_TRUE(comma.speaks());
  EXPECT_EQ(read_number("0.25"), 0.25);
  EXPECT_EQ(read_number("\"0x1.8p-1\""), 0.75);
  EXPECT_EQ(hex_float(0.75), "0x1.8p-1");
}

std::string message_of(const std::function<void()>& act) {
  try {
    act();
  } catch (const Failure& f) {
    EXPECT_EQ(f.exit(), Exit::bad_input);
    return f.what();
  }
  return "(no failure)";
}

class CaseFile : public testing::Test {
 protected:
  void SetUp() override { path_ = testing::TempDir() + "cases-" + std::to_string(getpid()) + ".jsonl"; }
  void TearDown() override { std::filesystem::remove(path_); }

  std::string failure_of(const std::string& bytes) {
    std::ofstream(path_, std::ios::binary) << bytes;
    const std::string message = message_of([&] { read_cases(path_); });
    return message.starts_with(path_) ? message.substr(path_.size()) : message;
  }

  std::string path_;
};

const std::string good = R"({"id":"a","seg":[[0,0,1],[0,0,-1]],"tri":[[0,0,0],[1,0,0],[0,1,0]]})";

TEST_F(CaseFile, BadInputIsOneLineWithFileAndLine) {
  const struct {
    std::string bytes, message;
  } table[] = {
      {"", ": holds no cases"},
      {"\n \r\n", ": holds no cases"},
      {good + "\n{", ":2: not valid JSON"},
      {good + " x", ":1: not valid JSON"},
      {"[1]", ":1: expected an object"},
      {R"({"seg":[[0,0,1],[0,0,-1]],"tri":[[0,0,0],[1,0,0],[0,1,0]]})", ":1: missing \"id\""},
      {R"({"id":"a","sag":[[0,0,1],[0,0,-1]]})", ":1: unknown key \"sag\", did you mean \"seg\"?"},
      {R"({"id":"a","zzz":1})",
       ":1: unknown key \"zzz\", expected one of id, fmt, seg, ray, tri, rings, expect, class"},
      {R"({"id":"a","tri":[[0,0,0],[1,0,0],[0,1,0]]})", ":1: expected exactly one of \"seg\" and \"ray\""},
      {R"({"id":7,"seg":[[0,0,1],[0,0,-1]],"tri":[[0,0,0],[1,0,0],[0,1,0]]})", ":1: id: expected a string"},
      {R"({"id":"a","seg":[[0,0,1]],"tri":[[0,0,0],[1,0,0],[0,1,0]]})", ":1: seg: expected 2 points"},
      {R"({"id":"a","seg":[[0,0,1],[0,-1]],"tri":[[0,0,0],[1,0,0],[0,1,0]]})", ":1: seg[1]: expected three numbers"},
      {R"({"id":"a","seg":[[0,0,1],[0,0,"1.5"]],"tri":[[0,0,0],[1,0,0],[0,1,0]]})", ":1: seg[1][2]: expected a number"},
      {R"({"id":"a","seg":[[0,0,1],[0,0,"nano"]],"tri":[[0,0,0],[1,0,0],[0,1,0]]})",
       ":1: seg[1][2]: expected a number or a hex-float string"},
      {R"({"id":"a","seg":[[0,0,1],[0,0,"1e999"]],"tri":[[0,0,0],[1,0,0],[0,1,0]]})",
       ":1: seg[1][2]: expected a number or a hex-float string"},
      {R"({"id":"a","expect":0,"seg":[[0,0,1],[0,0,"nan"]],"tri":[[0,0,0],[1,0,0],[0,1,0]]})",
       ":1: expect: given of a case with a number that is not finite, expected none"},
      {R"({"id":"a","class":"C017","seg":[[0,0,1],[0,0,-1e999]],"tri":[[0,0,0],[1,0,0],[0,1,0]]})",
       ":1: class: given of a case with a number that is not finite, expected none"},
      {R"({"id":1e999,"seg":[[0,0,1],[0,0,1]],"tri":[[0,0,0],[1,0,0],[0,1,0]]})", ":1: id: expected a string"},
      {good + "\n\xEF\xBB\xBF" + good, ":2: a byte-order mark, expected none but at the start of the file"},
      {R"({"id":"a","seg":[[0,0,1],[0,0,NaN]],"tri":[[0,0,0],[1,0,0],[0,1,0]]})", ":1: not valid JSON"},
      {R"({"id":"a","fmt":"binary16","seg":[[0,0,1],[0,0,1]],"tri":[[0,0,0],[1,0,0],[0,1,0]]})",
       ":1: fmt: expected \"binary64\" or \"binary32\""},
      {R"({"id":"a","fmt":"binary32","seg":[[0,0,1],[0,0,0.1]],"tri":[[0,0,0],[1,0,0],[0,1,0]]})",
       ":1: seg[1][2]: expected a number that is exact in binary32"},
      {R"({"id":"a","fmt":"binary32","seg":[[0,0,1],[0,0,1e39]],"tri":[[0,0,0],[1,0,0],[0,1,0]]})",
       ":1: seg[1][2]: expected a number that is exact in binary32"},
      {R"({"id":"a","class":"C164","seg":[[0,0,1],[0,0,1]],"tri":[[0,0,0],[1,0,0],[0,1,0]]})",
       ":1: class: expected a class C001 to C163"},
      {R"({"id":"a","expect":2,"seg":[[0,0,1],[0,0,1]],"tri":[[0,0,0],[1,0,0],[0,1,0]]})",
       ":1: expect: expected 0 or 1"},
      {std::string(100, '['), ":1: nested deeper than 64 levels"},
      {std::string(3, '\0'), ":1: not valid JSON"},
      {good + '\0' + ",\"expect\":0} anything", ":1: not valid JSON: a byte 0"},
      {"\xEF\xBB\xBF\xEF\xBB\xBF" + good, ":1: not valid JSON: a second byte-order mark"},
      {R"({"id":"a","seg":[[0,0,1],[0,0,"0x1p+-1"]],"tri":[[0,0,0],[1,0,0],[0,1,0]]})",
       ":1: seg[1][2]: expected a number or a hex-float string"},
      {"{\"id\":\"" + std::string(2 << 20, 'x') + "\"}", ":1: line longer than 1 MiB"},
  };
  for (const auto& row : table) {
    EXPECT_TRUE(failure_of(row.bytes).starts_with(row.message))
        << row.bytes.substr(0, 80) << "\n  gave " << failure_of(row.bytes) << "\n  expected " << row.message;
  }
}

TEST_F(CaseFile, MissingFilesAndDirectories) {
  EXPECT_NE(message_of([] { read_cases("no/such/file"); }).find("cannot read"), std::string::npos);
  EXPECT_NE(message_of([] { read_cases("/"); }).find("is a directory"), std::string::npos);
}

TEST_F(CaseFile, CarriageReturnsAndBlankLinesAreFine) {
  std::ofstream(path_, std::ios::binary) << good << "\r\n\n" << good << "\r\n";
  EXPECT_EQ(read_cases(path_).size(), 2U);
}

TEST_F(CaseFile, AByteOrderMarkAtItsStartIsSkipped) {
  std::ofstream(path_, std::ios::binary) << "\xEF\xBB\xBF" << good << "\n" << good << "\n";
  EXPECT_EQ(read_cases(path_).size(), 2U);
}

TEST_F(CaseFile, BoundsMayBeInfiniteAboveAndElseAreNotFinite) {
  const auto bounds = [&](const std::string& t) {
    return cases_in(R"({"id":"a","ray":{"o":[0,0,1],"d":[0,0,-1],"t":)" + t + R"(},"tri":[[0,0,0],[1,0,0],[0,1,0]]})",
                    "test")[0]
        .query;
  };
  EXPECT_TRUE(is_finite(bounds("[0,\"inf\"]")) && is_finite(bounds("[0,\"Infinity\"]")));
  for (const char* t : {"[0,\"-inf\"]", "[0,\"nan\"]", "[\"nan\",1]", "[\"inf\",\"inf\"]", "[\"-inf\",1]", "[1e999,1]",
                        "[0,1e999]", "[0,\"0x1p+1024\"]", "[0,-1e999]"}) {
    EXPECT_FALSE(is_finite(bounds(t))) << t;
  }
}

TEST_F(CaseFile, RoundTrip) {
  std::string lines;
  for (const ClassRow& row : class_table()) {
    Case c;
    c.id = "class \"" + class_name(row.id) + "\"";
    c.format = row.id % 2 == 0 ? Format::binary32 : Format::binary64;
    c.query = {row.representative_segment(), row.representative_triangle()};
    if (row.id % 3 == 0) c.query.probe = Ray{{0.1, -0.0, 1e300}, {{5e-324, 1, 2}}};
    if (row.id % 3 == 0) c.format = Format::binary64;
    c.expect = row.hit();
    c.class_id = row.id;
    c.source = "umlaut ä";
    lines += from_case(c).dump() + "\n";
  }
  write_file(path_, lines);
  std::string again;
  for (const Case& c : read_cases(path_)) again += from_case(c).dump() + "\n";
  EXPECT_EQ(again, lines);
}

TEST(Files, AFailedWriteLeavesNothing) {
  const std::string directory = testing::TempDir() + "no-such-directory-" + std::to_string(getpid());
  try {
    write_file(directory + "/file", "text");
    FAIL();
  } catch (const Failure& f) {
    EXPECT_EQ(f.exit(), Exit::output_failed);
  }
  EXPECT_FALSE(std::filesystem::exists(directory));
  EXPECT_THROW(write_file("/dev/full", "text"), Failure);
}

TEST(Methods, TheTableIsConsistent) {
  std::set<std::string> names;
  for (const Method& m : all_methods()) {
    EXPECT_TRUE(names.insert(m.name).second) << m.name;
    EXPECT_TRUE(m.segment && m.ray) << m.name;
    EXPECT_FALSE(m.card.number.empty() || m.card.summary.empty() || m.card.reference.empty()) << m.name;
    EXPECT_EQ(find_method(m.name), &m);
  }
  EXPECT_EQ(find_method("sf-duoble"), nullptr);
}

}  // namespace
}  // namespace tribunal
