// A report holds what the records hold, and nothing in it can leave the element that it stands in.
#include "exact/report/report.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <set>

#include "exact/base/failure.h"
#include "exact/base/json.h"
#include "exact/base/output.h"
#include "exact/base/shown.h"
#include "exact/report/base64.h"
#include "exact/report/case_book.h"
#include "exact/report/case_view.h"
#include "exact/report/classes.h"
#include "exact/report/drawing.h"
#include "exact/report/table.h"

namespace tribunal {
namespace {

TEST(ReportTable, StoresTextsOnceAndCutsZeros) {
  Table table({"method", "asked", "wrong"});
  table.add({"b", 3, 0});
  table.add({"a", 0, 0});
  table.add({"b", 1, 2});
  EXPECT_EQ(table.json(true).dump(),
            R"({"columns":["method","asked","wrong"],"words":{"method":["b","a"]},"rows":[[0,3],[1],[0,1,2]]})");
  EXPECT_EQ(table.json()["rows"].dump(), "[[0,3,0],[1,0,0],[0,1,2]]");
}

TEST(ReportTable, OfObjectsHasAColumnForEveryKeyOfAnyOfThem) {
  const Json objects = {{{"n", 1}, {"outcomes", {{"false hit", 2}}}}, {{"n", 3}, {"extra", true}, {"list", {1, 2}}}};
  const Json table = table_of(objects).json();
  EXPECT_EQ(table["columns"].dump(), R"(["n","outcomes.false hit","extra"])");
  EXPECT_EQ(table["rows"].dump(), "[[1,2,null],[3,null,true]]");
}

TEST(ReportBase64, IsThatOfTheStandard) {
  const std::pair<const char*, const char*> vectors[] = {{"", ""},
                                                         {"f", "Zg=="},
                                                         {"fo", "Zm8="},
                                                         {"foo", "Zm9v"},
                                                         {"foob", "Zm9vYg=="},
                                                         {"fooba", "Zm9vYmE="},
                                                         {"foobar", "Zm9vYmFy"}};
  for (const auto& [bytes, text] : vectors) EXPECT_EQ(base64(bytes), text);
}

// --- hostile texts -----------------------------------------------------------------------------------------------

constexpr const char* hostile =
    "</script><script>alert(1)</script><!-- \xe2\x80\xa8 \xe2\x80\xa9 @TRIBUNAL_DATA@ ' \" \\";

TEST(ReportPage, NoTextLeavesItsElement) {
  const Json report = {{hostile, hostile}};
  const std::string text = embeddable(report);
  EXPECT_EQ(text.find('<'), std::string::npos);
  EXPECT_EQ(text.find("\xe2\x80\xa8"), std::string::npos);
  EXPECT_EQ(text.find("\xe2\x80\xa9"), std::string::npos);
  EXPECT_EQ(Json::parse(text), report);
}

TEST(ReportPage, HoldsTheReportOnceAndWhole) {
  const Json report = {{"id", hostile}};
  const std::string page = report_page(report), text = embeddable(report);
  const std::size_t at = page.find(text);
  ASSERT_NE(at, std::string::npos);
  EXPECT_EQ(page.find(text, at + 1), std::string::npos);
  EXPECT_NE(page.substr(0, at).find("id=\"tribunal-data\""), std::string::npos);
  EXPECT_TRUE(page.substr(at + text.size()).starts_with("</script"));
}

TEST(ReportPage, BytesThatAreNoTextBecomeReplacementCharacters) {
  EXPECT_EQ(embeddable(Json("a\xff")), "\"a\xef\xbf\xbd\"");
}

TEST(ReportCase, AFileNameIsOneWordOfTheShell) {
  EXPECT_EQ(shell_word("findings/counterexamples.jsonl"), "findings/counterexamples.jsonl");
  EXPECT_EQ(shell_word("a b; rm $x"), "'a b; rm $x'");
  EXPECT_EQ(shell_word("it's"), "'it'\\''s'");
  EXPECT_EQ(shell_word("-e"), "'-e'");
  EXPECT_EQ(shell_word(""), "''");
}

// --- which cases -------------------------------------------------------------------------------------------------

FoundCase found(const std::string& severity, ClassId class_id, const std::string& outcome = "false hit") {
  FoundCase f;
  f.c.class_id = class_id;
  f.c.finding = {{"method", "m"}, {"outcome", outcome}, {"severity", severity}};
  f.rank.severity = severity == "plain"      ? Severity::plain
                    : severity == "boundary" ? Severity::boundary
                                             : Severity::extreme;
  return f;
}

TEST(ReportCases, ARareOneStaysBesideThousandsOfACommonOne) {
  std::vector<FoundCase> all(3000, found("boundary", 7));
  all.push_back(found("extreme", 8));
  all.push_back(found("boundary", 9, "false miss"));
  all.insert(all.begin() + 1500, found("plain", 7));
  const std::vector<std::size_t> chosen = worst_and_most_diverse(all, 6);
  ASSERT_EQ(chosen.size(), 6u);
  EXPECT_EQ(chosen.front(), 1500u) << "the worst is first";
  EXPECT_EQ(chosen.back(), 3001u) << "the mildest is there, and last";
  EXPECT_TRUE(std::ranges::find(chosen, 3002u) != chosen.end());
  EXPECT_TRUE(std::ranges::find(chosen, 0u) != chosen.end());
  EXPECT_EQ(worst_and_most_diverse(all, 10'000).size(), all.size());
}

// --- directories -------------------------------------------------------------------------------------------------

class ReportFiles : public ::testing::Test {
 protected:
  ReportFiles() : root_(std::filesystem::temp_directory_path() / ("tribunal-report-" + std::to_string(::getpid()))) {
    std::filesystem::create_directories(root_ / "a" / "b");
  }
  ~ReportFiles() override { std::filesystem::remove_all(root_); }

  void write(const std::string& name, const std::string& text) { write_file((root_ / name).string(), text); }
  Json report(std::size_t most = 2000) { return gather_report({{root_.string()}, most}); }
  std::string failure() {
    try {
      report();
    } catch (const Failure& f) {
      EXPECT_EQ(f.exit(), Exit::bad_input);
      return f.what();
    }
    return "";
  }

  std::filesystem::path root_;
};

Json fuzz_record(const std::string& method) {
  return {{"seed", 5},
          {"cases", 9},
          {"methods", {{{"name", method}, {"number", "binary64"}, {"fmt", "binary64"}, {"exact", false}}}},
          {"families", {"ulp"}},
          {"classes_judged", {{method, "binary64 1/163"}}},
          {"counts",
           {{{"method", method},
             {"family", "ulp"},
             {"fmt", "binary64"},
             {"class", "C007"},
             {"asked", 9},
             {"wrong", 2},
             {"unsupported", 1},
             {"outcomes", {{"false hit", 2}}},
             {"severity", {{"boundary", 2}}},
             {"cause", {{"asked", 2}, {"rounding", 2}}},
             {"refused", 1}}}},
          {"faults", Json::array()}};
}

TEST_F(ReportFiles, ADirectoryWithoutResultsIsOneLine) {
  EXPECT_EQ(failure(), root_.string() +
                           ": holds no result, expected a file that fuzz, certify, judge, sweep, chart, leak, "
                           "render --against or bench wrote");
  write("a/notes.json", "{}");
  write("a/summary.json", R"({"something":"else"})");
  EXPECT_NE(failure().find("holds no result"), std::string::npos);
}

TEST_F(ReportFiles, WhatIsNotAsItsCommandWritesItIsOneLineWithTheFile) {
  for (const char* counts :
       {"7", "[7]", R"([{"method":"m"}])", R"([{"method":7,"family":"f","fmt":"x","class":"C001"}])"}) {
    write("a/summary.json", std::string(R"({"classes_judged":{},"counts":)") + counts + "}");
    const std::string line = failure();
    EXPECT_TRUE(line.starts_with((root_ / "a/summary.json").string() + ": ")) << line;
    EXPECT_EQ(line.find('\n'), std::string::npos);
  }
  write("a/summary.json", "{");
  EXPECT_TRUE(failure().starts_with((root_ / "a/summary.json").string() + ":")) << failure();
}

/// A map of 2 × 2 pixels, one of them wrong.
Json map_record() {
  return {{"map", "edge"},
          {"size", 2},
          {"probe", "segment"},
          {"about", "an edge"},
          {"base", {{"binary64", {{"seg", {{0, 0, 1}, {0, 0, -1}}}, {"tri", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}}}}},
          {"unit", {{"binary64", "0x1p-53"}}},
          {"truth", {{"binary64", {"h.", "hh"}}}},
          {"panels",
           {{{"method", "m"},
             {"fmt", "binary64"},
             {"counts", {{"right", 3}, {"false hit", 1}}},
             {"pixels", {"H+", "HH"}}}}}};
}

TEST_F(ReportFiles, AMapIsAsManyPixelsAsItSays) {
  write("a/map-edge.json", map_record().dump());
  EXPECT_EQ(report()["verdicts"][0]["text"], "m: wrong on 1 of 4 (25 %) pixels of the map edge");
  const std::pair<const char*, Json> faults[] = {
      {"/size", 3},
      {"/panels/0/pixels", 7},
      {"/panels/0/pixels/1", "H"},
      {"/panels/0/pixels/1", "H!"},
      {"/panels/0/counts/false hit", 2},
      {"/panels/0/counts", {{"right", 3}}},
      {"/panels/0/counts/fault", 1},
      {"/base/binary64/tri/1", {1, 0}},
      {"/unit/binary64", 0},
      {"/truth/binary64", {"h."}},
  };
  for (const auto& [place, value] : faults) {
    Json record = map_record();
    record[Json::json_pointer(place)] = value;
    write("a/map-edge.json", record.dump());
    EXPECT_TRUE(failure().starts_with((root_ / "a/map-edge.json").string() + ": ")) << place;
  }
}

TEST_F(ReportFiles, AFindingSaysWhatFindingsSay) {
  write("a/summary.json", fuzz_record("mine").dump());
  for (const Json& finding : {Json{{"answers", 3}}, Json{{"answers", {{"m", 2}}}}, Json{{"expected", 5}},
                              Json{{"exact", "x"}}, Json{{"exact", {{"t", "1/"}}}}, Json{{"severity", "huge"}},
                              Json{{"origin", {{"seed", -1}}}}, Json{{"made_with", {1}}}}) {
    write("a/counterexamples.jsonl", Json({{"id", "c"},
                                           {"seg", {{0, 0, 1}, {0, 0, -1}}},
                                           {"tri", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}},
                                           {"finding", finding}})
                                             .dump() +
                                         "\n");
    EXPECT_TRUE(failure().starts_with((root_ / "a/counterexamples.jsonl").string() + ":1: finding")) << finding;
  }
}

TEST_F(ReportFiles, FindsResultsInDirectoriesBelowAndCountsThem) {
  write("a/b/summary.json", fuzz_record("mine").dump());
  const Json r = report();
  ASSERT_EQ(r["runs"].size(), 1u);
  const Json& run = r["runs"][0];
  EXPECT_EQ(run["kind"], "fuzz");
  EXPECT_EQ(run["counts"]["rows"].dump(), "[[0,0,0,0,9,2,1,1,2,0,0,0,0,2,0,2,0,2]]");
  const Json& totals = run["totals"];
  EXPECT_EQ(totals["rows"][0][4], 8) << "judged";
  EXPECT_LT(totals["rows"][0][7], 0.25);
  EXPECT_GT(totals["rows"][0][8], 0.25);
  ASSERT_EQ(r["verdicts"].size(), 1u);
  EXPECT_EQ(r["verdicts"][0]["level"], "boundary");
  EXPECT_EQ(r["verdicts"][0]["text"], "mine: wrong in 2 of 8 (25 %) binary64 cases");
  EXPECT_EQ(run["command"],
            "tribunal fuzz --method mine --family ulp --seed 5 --count 9 --out " + (root_ / "a/b").string());
}

TEST_F(ReportFiles, HostileNamesStayText) {
  write("a/summary.json", fuzz_record(hostile).dump());
  write("a/counterexamples.jsonl",
        Json({{"id", hostile},
              {"seg", {{0, 0, 1}, {0, 0, -1}}},
              {"tri", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}},
              {"finding", {{"method", hostile}, {"case", "mine"}, {"answers", {{hostile, 1}}}}}})
                .dump() +
            "\n");
  const Json r = report();
  EXPECT_EQ(r["runs"][0]["methods"][0], shown(hostile));
  ASSERT_EQ(r["cases"].size(), 1u);
  EXPECT_EQ(r["cases"][0]["case"]["id"], shown(hostile)) << "a finding's keys do not replace the case";
  EXPECT_EQ(r["cases"][0]["class"], "C017");
  EXPECT_EQ(report_page(r).find("<script>alert"), std::string::npos);
}

TEST_F(ReportFiles, NothingWrongIsSaidWithItsBound) {
  Json record = fuzz_record("mine");
  record["counts"][0]["wrong"] = 0;
  for (const char* key : {"outcomes", "severity", "cause"}) record["counts"][0].erase(key);
  write("a/summary.json", record.dump());
  const Json line = report()["verdicts"][0];
  EXPECT_EQ(line["text"], "mine: nothing wrong in 8 binary64 cases");
  EXPECT_EQ(line["detail"], "so at most 31.2 % wrong of such cases, with 95 % confidence");
}

TEST_F(ReportFiles, ANameThatLooksLikeAnOptionIsQuotedInACommand) {
  write("a/summary.json", fuzz_record("--a;b").dump());
  EXPECT_TRUE(report()["runs"][0]["command"].get<std::string>().starts_with("tribunal fuzz --method '--a;b' --family"));
}

TEST_F(ReportFiles, WhatIsLeftOutIsCounted) {
  write("a/summary.json", fuzz_record("mine").dump());
  std::string lines;
  for (int i = 0; i < 30; ++i) {
    lines += R"({"id":"c)" + std::to_string(i) +
             R"(","seg":[[0,0,1],[0,0,-1]],"tri":[[0,0,0],[1,0,0],[0,1,0]]})"
             "\n";
  }
  write("a/counterexamples.jsonl", lines);
  const Json r = report(12);
  EXPECT_EQ(r["cases"].size(), 12u);
  EXPECT_EQ(r["runs"][0]["cases_in_all"], 30);
  ASSERT_EQ(r["left_out"].size(), 1u);
  EXPECT_NE(r["left_out"][0].get<std::string>().find("18 of its 30 cases"), std::string::npos);
}

TEST_F(ReportFiles, APictureComesFromTheResultsOwnDirectory) {
  write("secret.png", "\x89PNG\r\n\x1a\n and something that is not for the page");
  Json record = {{"scene", "s"},
                 {"width", 2},
                 {"height", 2},
                 {"fmt", "binary64"},
                 {"pixels", Json::array()},
                 {"difference", {{"method", "m"}, {"against", "n"}}},
                 {"files", {{"image", "../secret.png"}, {"cases", "../../x.jsonl"}}}};
  write("a/x.diff.json", record.dump());
  const Json r = report();
  ASSERT_TRUE(r["images"].empty());
  ASSERT_EQ(r["left_out"].size(), 1u);
  EXPECT_NE(r["left_out"][0].get<std::string>().find("secret.png is missing"), std::string::npos);
}

/// A comparison of two pictures of 10 × 10 pixels, with these pixels.
Json pictures(const Json& pixels) {
  return {{"scene", "s"},           {"width", 10},      {"height", 10},
          {"fmt", "binary64"},      {"pixels", pixels}, {"difference", {{"method", "m"}, {"against", "n"}}},
          {"files", Json::object()}};
}

/// The verdict on this method of the one run that is in the directory.
Json verdict_on(const Json& report, const std::string& method) {
  for (const Json& line : report["verdicts"]) {
    if (line["method"] == method) return line;
  }
  return Json();
}

TEST_F(ReportFiles, UnexaminedPixelsAreNotRight) {
  const Json unexamined = {{"x", 1}, {"y", 1}, {"why", "unexamined"}};
  const Json face = {{"x", 2}, {"y", 1}, {"why", "face"}, {"case", "c"}, {"wrong", {"m"}}};
  write("a/x.diff.json", pictures({face, unexamined, unexamined}).dump());
  const Json r = report();
  const Json m = verdict_on(r, "m"), n = verdict_on(r, "n");
  EXPECT_EQ(m["text"], "m: 1 of 98 (1.02 %) pixels show a wrong answer");
  EXPECT_EQ(m["level"], "boundary");
  EXPECT_EQ(n["text"], "n: no pixel of 98 shows a wrong answer");
  EXPECT_EQ(n["level"], "incomplete");
  EXPECT_EQ(n["judged"], 98);
  EXPECT_EQ(n["detail"], "2 that differ were not examined");
}

TEST_F(ReportFiles, AWrongOrderOfHitsIsWrong) {
  const Json order = {{"x", 1}, {"y", 1}, {"why", "order"}};
  Json wrong = order;
  wrong["wrong"] = {"m"};
  write("a/x.diff.json", pictures({order, wrong, wrong}).dump());
  const Json r = report();
  EXPECT_EQ(verdict_on(r, "m")["wrong"], 2);
  EXPECT_EQ(verdict_on(r, "n")["level"], "pictures");
  EXPECT_EQ(r["runs"][0]["verdict_pixels"]["order"], 1);
}

/// A row of a certificate: of 100 cases k are wrong, all of one severity.
Json stratum(std::uint64_t k, const char* severity) {
  return {{"family", "f"}, {"fmt", "binary64"}, {"n", 100}, {"k", k}, {"severity", {{severity, k}}}};
}

TEST_F(ReportFiles, OwnCasesCountBesideASampleAndAreNotAddedToIt) {
  Json record = {{"method", "m"},
                 {"verdict", "refuted"},
                 {"budget", "quick"},
                 {"sampled", {stratum(3, "extreme")}},
                 {"own_cases", {stratum(50, "plain")}}};
  write("a/certificate.json", record.dump());
  Json r = report();
  EXPECT_EQ(r["verdicts"][0]["level"], "plain");
  EXPECT_EQ(r["verdicts"][0]["wrong"], 50);
  EXPECT_EQ(r["verdicts"][0]["judged"], 100);
  EXPECT_EQ(r["verdicts"][0]["detail"], "on your own binary64 cases wrong in 50 of 100 (50 %)");
  ASSERT_EQ(r["runs"][0]["sums"].size(), 1u);
  EXPECT_EQ(r["runs"][0]["sums"][0]["wrong"], 3) << "of the sample alone";
  record["own_cases"] = {stratum(0, "plain")};
  write("a/certificate.json", record.dump());
  r = report();
  EXPECT_EQ(r["verdicts"][0]["level"], "extreme");
  EXPECT_EQ(r["verdicts"][0]["wrong"], 3);
}

/// Counts at one value of an axis.
Json swept(const char* axis, int value, std::uint64_t judged, std::uint64_t wrong, const Json& outcomes) {
  return {{"method", "m"},       {"axis", axis},      {"fmt", "binary64"},
          {"value", value},      {"probe", "ray"},    {"asked", judged + 3},
          {"judged", judged},    {"refused", 3},      {"wrong", {{"k", wrong}, {"n", judged}}},
          {"plain", 0},          {"boundary", wrong}, {"extreme", 0},
          {"outcomes", outcomes}};
}

Json swept_axis(const char* name, const char* operands) {
  return {{"name", name},         {"quantity", "how far"},        {"population", ""},
          {"operands", operands}, {"easiest", {{"binary64", 0}}}, {"values", {{"binary64", {-10, 0, 10, 20, 30, 40}}}}};
}

Json threshold(const char* axis, const char* side, int value) {
  return {{"method", "m"},
          {"axis", axis},
          {"fmt", "binary64"},
          {"side", side},
          {"probe", "ray"},
          {"outcome", "false hit"},
          {"first", {{"value", value}, {"n", 50}, {"k", 2}}},
          {"witness", "w"}};
}

TEST_F(ReportFiles, ASweepSaysWhereItFailsFirstAndBoundsNothing) {
  Json record = {
      {"seed", 1},
      {"cases", 103},
      {"methods", {{{"name", "m"}}}},
      {"axes", {swept_axis("sliver", "triangles"), swept_axis("fill", "polygons"), swept_axis("afar", "mesh")}},
      {"rows",
       {swept("sliver", 40, 100, 5, {{"refused", {{"k", 3}, {"n", 103}}}}), swept("fill", 20, 100, 2, Json::object()),
        swept("afar", 0, 70, 9, {{"leak", {{"k", 4}, {"n", 70}}}})}},
      {"thresholds",
       {threshold("sliver", "up", 40), threshold("fill", "up", 20), threshold("sliver", "down", -10),
        threshold("afar", "up", 0)}}};
  write("a/sweep.json", record.dump());
  Json r = report();
  ASSERT_EQ(r["verdicts"].size(), 2u);
  EXPECT_EQ(r["verdicts"][0]["text"], "m: 9 wrong of 70 binary64 rays at a mesh along the axis afar");
  EXPECT_EQ(r["verdicts"][0]["level"], "leaks");
  EXPECT_EQ(r["verdicts"][1]["text"], "m: 7 wrong of 200 binary64 cases along 2 axes");
  EXPECT_EQ(r["verdicts"][1]["level"], "boundary");
  EXPECT_EQ(r["verdicts"][1]["detail"], "fails first on the axis fill: at 20, 2 of 50 false hit");
  const Json columns = r["runs"][0]["record"]["rows"]["columns"];
  EXPECT_EQ(std::ranges::count(columns, Json("refused.k")), 1);
  EXPECT_EQ(std::ranges::count(columns, Json("refused")), 0) << "it is the number of the outcome";
  record["rows"] = {swept("sliver", 40, 100, 0, Json::object())};
  write("a/sweep.json", record.dump());
  r = report();
  EXPECT_EQ(r["verdicts"][0]["text"], "m: nothing wrong of 100 binary64 cases along 2 axes");
  EXPECT_EQ(r["verdicts"][0]["detail"], "") << "no bound";
}

// --- the atlas ---------------------------------------------------------------------------------------------------

double distance(const Spot& a, const Spot& b) { return std::hypot(a.x - b.x, a.y - b.y); }

TEST(Atlas, DrawsOfEveryClassWhatItsTableSays) {
  for (const auto& table : {class_table(), ray_class_table()}) {
    for (const ClassRow& row : table) {
      const Drawing d = drawing_of(row);
      ASSERT_EQ(d.meet.has_value(), row.hit()) << class_name(row.id);
      if (!row.hit()) continue;
      EXPECT_EQ(distance(d.meet->from, d.meet->to) > 0.5, row.intersection == "segment") << class_name(row.id);
    }
  }
}

TEST(Atlas, PointsCanBeToldApart) {
  for (const auto& table : {class_table(), ray_class_table()}) {
    for (const ClassRow& row : table) {
      const Drawing d = drawing_of(row);
      for (std::size_t i = 0; i < d.dots.size(); ++i) {
        const Dot& one = d.dots[i];
        EXPECT_TRUE(one.at.x >= 0 && one.at.x <= 120 && one.at.y >= 0 && one.at.y <= 90) << class_name(row.id);
        for (std::size_t j = 0; j < i; ++j) {
          EXPECT_GT(distance(one.at, d.dots[j].at), 5) << class_name(row.id) << one.names << d.dots[j].names;
        }
      }
      std::size_t names = 0;
      std::set<std::array<int, 3>> places;
      for (const Dot& dot : d.dots) names += dot.names.size();
      const std::size_t points = is_ray_class(row.id) ? 4 : 5;
      EXPECT_EQ(names, points) << class_name(row.id);
      for (std::size_t i = 0; i < points; ++i) places.insert(row.points[i]);
      EXPECT_TRUE(d.apart || d.dots.size() == places.size()) << class_name(row.id);
    }
  }
}

TEST(Atlas, SaysInWordsWhereTheyMeet) {
  EXPECT_EQ(in_words(class_row(class_named("C001"))), "A segment and a triangle, not in one plane, do not meet.");
  EXPECT_EQ(in_words(class_row(class_named("C012"))),
            "A segment and a triangle, not in one plane, meet in one point: an end of the segment lies on an edge.");
  for (const auto& table : {class_table(), ray_class_table()}) {
    for (const ClassRow& row : table) {
      const std::string words = in_words(row);
      EXPECT_EQ(words.find("do not meet") == std::string::npos, row.hit()) << words;
      EXPECT_EQ(words.find("meet in one point") != std::string::npos, row.intersection == "point") << words;
      EXPECT_EQ(words.find("meet in a segment") != std::string::npos, row.intersection == "segment") << words;
    }
  }
  const Json classes = classes_json();
  ASSERT_EQ(classes.size(), static_cast<std::size_t>(all_class_count));
  EXPECT_EQ(classes[0]["id"], "C001");
  EXPECT_EQ(classes[class_count]["id"], "R001");
}

}  // namespace
}  // namespace tribunal
