#include "exact/methods/methods.h"
#include "exact/report/html.h"
#include "exact/report/page.h"
#include "exact/report/page_parts.h"
#include "tests/tracer/support.h"

namespace tribunal {
namespace {

Case counterexample(const char* id, const Point3& p) {
  Case c;
  c.id = id;
  c.class_id = 10;
  c.query = {Segment{p, {2, 1.5, 0}}, Triangle{{1, 1, 0}, {0, 0, 1}, {-1, 0, 0}}};
  c.finding = {{"method", "sf-double"},
               {"answered", 1},
               {"expected", 0},
               {"exact", {{"abcp", 1}, {"abcq", 0}, {"pqab", 1}, {"pqbc", -1}, {"pqca", 0}}}};
  return c;
}

const Point3 below_half{0, 0x1.fffffffffffffp-2, 0};

Tour small_tour() {
  Tour tour;
  tour.directory = "a<b";
  tour.commands = {"tribunal fuzz --out a<b&c"};
  const std::vector<WholeSet> whole = {{"all of {0..2}^3", 14348907, 0}};
  tour.floating = {"sf-double", "refuted", "wrong on boundaries only", whole, {{"binary64", 1000, 60}}, 2};
  tour.exact = {"sf-rational", "not refuted", "nothing wrong", whole, {{"binary64", 1000, 0}}, 0};
  tour.fuzz = {
      {"sf-double", "binary64", 1000, 60}, {"sf-double", "binary32", 500, 7}, {"sf-epick", "binary64", 1000, 0}};
  tour.counterexample = counterexample("one", below_half);
  tour.replay = "<script>alert(1)</script>";
  tour.pictures = {{"mt-float", "binary32", 320, 240, 162, 141, {{100, 50}, {101, 52}}},
                   {"sf-double", "binary64", 320, 240}};
  tour.chart = {{"rows", Json::array()}, {"environment", {{"compiler", "g++ <12>"}}}};
  return tour;
}

bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

TEST(Html, EscapesWhatHtmlReads) { EXPECT_EQ(escape("<a href=\"x\">&'"), "&lt;a href=&quot;x&quot;&gt;&amp;&#39;"); }

TEST(Html, GroupsDigits) {
  EXPECT_EQ(grouped(0), "0");
  EXPECT_EQ(grouped(999), "999");
  EXPECT_EQ(grouped(1000), "1,000");
  EXPECT_EQ(grouped(14348907), "14,348,907");
}

TEST(Html, PercentKeepsSmallShares) {
  EXPECT_EQ(percent(0), "0 %");
  EXPECT_EQ(percent(0.0606), "6.06 %");
  EXPECT_EQ(percent(4.1e-6), "0.00041 %");
}

TEST(Page, EscapesEverythingThatComesFromFiles) {
  const std::string html = page(small_tour());
  EXPECT_FALSE(holds(html, "<script>"));
  EXPECT_TRUE(holds(html, "&lt;script&gt;alert(1)"));
  EXPECT_TRUE(holds(html, "tribunal fuzz --out a&lt;b&amp;c"));
  EXPECT_TRUE(holds(html, "g++ &lt;12&gt;"));
}

TEST(Page, StandsAlone) {
  const std::string html = page(small_tour());
  for (const char* foreign : {"http:", "https:", "<link", "<script", "src=\"/", "@import"})
    EXPECT_FALSE(holds(html, foreign));
}

TEST(Page, ClosesWhatItOpens) {
  const std::string html = page(small_tour());
  for (const std::string tag :
       {"div", "section", "table", "tr",   "td",     "figure", "figcaption", "ul", "li", "pre",
        "p",   "h2",      "h3",    "main", "header", "footer", "dl",         "dt", "dd", "svg"}) {
    EXPECT_EQ(count(html, "<" + tag + ">") + count(html, "<" + tag + " "), count(html, "</" + tag + ">")) << tag;
  }
}

TEST(Page, ShowsTheVerdictsAsTheyAre) {
  Tour tour = small_tour();
  EXPECT_TRUE(holds(page(tour), "card bad") && holds(page(tour), "card good"));
  tour.exact.verdict = "refuted";
  tour.exact.samples[0].wrong = 3;
  EXPECT_EQ(count(page(tour), "\"card bad\""), 2u);
}

TEST(Page, SaysPlainlyWhereNoPixelDiffers) {
  const std::string html = page(small_tour());
  EXPECT_TRUE(holds(html, "141 of 76,800 pixels have another colour"));
  EXPECT_TRUE(holds(html, "no pixel differs"));
}

TEST(Page, BusiestWindowStaysInsideThePicture) {
  PictureFigures f{"m", "binary32", 320, 240, 3, 3, {{0, 0}, {319, 239}, {318, 238}}};
  const Place corner = busiest_window(f, 40, 30);
  EXPECT_EQ(corner.column, 280);
  EXPECT_EQ(corner.row, 210);
}

TEST(Page, NamesTheSignThatDoublePrecisionGetsWrong) {
  const Case c = counterexample("one", below_half);
  EXPECT_TRUE(holds(answers_in_words(c), "no hit"));
  EXPECT_TRUE(holds(rule_in_words(c), "of the five wrong here"));
  EXPECT_TRUE(holds(signs_table(c), "answer bad")) << signs_table(c);
}

/// The page states the cost of being exact for the flagship, not for another exact method of the chart.
TEST(Page, TellsTheCostOfTheFlagship) {
  Json chart = {{"rows", Json::array()}};
  for (const char* population : {"general", "degenerate"}) {
    const auto add = [&](const std::string& method, double median) {
      chart["rows"].push_back({{"method", method},
                               {"population", population},
                               {"own_format", true},
                               {"nanoseconds", {{"median", median}}}});
    };
    for (const Method& m : all_methods()) add(m.name, 230);
    for (Json& row : chart["rows"]) {
      if (row["method"] == "sf-double") row["nanoseconds"]["median"] = 10;
      if (row["method"] == flagship_method().name) row["nanoseconds"]["median"] = 27;
    }
  }
  EXPECT_EQ(
      cost_in_words(chart),
      "In this run the exact test with a filter, <code>sf-filtered</code>, took 2.7 times as long on random points "
      "as <code>sf-double</code>, 2.7 times as long on exactly degenerate ones.");
  EXPECT_EQ(cost_in_words({{"rows", Json::array()}}), "");
}

TEST(Page, NamesTheMethodsThatReadThePlaneOtherwise) {
  Tour tour = small_tour();
  EXPECT_FALSE(holds(page(tour), "To some of them"));
  tour.fuzz.push_back({"mt-float", "binary32", 1000, 3});
  EXPECT_TRUE(holds(page(tour), "<code>mt-float</code> (Möller &amp; Trumbore 1997)."));
}

TEST(Tour, PicksTheShortestCounterexampleInGeneralPlace) {
  Case flat = counterexample("flat", {0, 0, 0});
  flat.class_id = 100;  // all in one plane
  Case ray = counterexample("ray", below_half);
  ray.query.probe = Ray{{0, 0, 0}, {{1, 1, 1}}};
  const std::vector<Case> cases{ray, flat, counterexample("long", {0.1, 0x1.fffffffffffffp-2, 1e-45}),
                                counterexample("short", below_half)};
  EXPECT_EQ(plainest(cases).id, "short");
}

TEST(Tour, SumsACertificate) {
  const Json certificate = {{"method", "m"},
                            {"verdict", "refuted"},
                            {"worst", "wrong"},
                            {"counterexamples", 2},
                            {"proved", {{{"set", "s"}, {"size", 10}, {"count", {{"wrong", 1}}}}}},
                            {"sampled",
                             {{{"fmt", "binary64"}, {"n", 5}, {"k", 1}},
                              {{"fmt", "binary32"}, {"n", 4}, {"k", 4}},
                              {{"fmt", "binary64"}, {"n", 7}, {"k", 2}}}},
                            {"not_covered", {{{"what", "a"}, {"reason", "r"}}, {{"what", "b"}, {"reason", "r"}}}}};
  const CertificateFigures f = certificate_figures(certificate);
  ASSERT_EQ(f.samples.size(), 2u);
  EXPECT_EQ(f.samples[0].sampled, 12u);
  EXPECT_EQ(f.samples[0].wrong, 3u);
  EXPECT_EQ(f.samples[1].wrong, 4u) << "formats are not added up";
  EXPECT_TRUE(f.refuted());
  EXPECT_EQ(f.whole.at(0).wrong, 1u);
  EXPECT_EQ(f.gaps.at(0).second, 2u);
}

TEST(Tour, SumsAFuzzRunByMethod) {
  const Json summary = {{"counts",
                         {{{"method", "a"}, {"fmt", "binary64"}, {"asked", 10}, {"unsupported", 1}, {"wrong", 2}},
                          {{"method", "a"}, {"fmt", "binary32"}, {"asked", 5}, {"unsupported", 0}, {"wrong", 5}},
                          {{"method", "a"}, {"fmt", "binary64"}, {"asked", 10}, {"unsupported", 0}, {"wrong", 3}},
                          {{"method", "b"}, {"fmt", "binary64"}, {"asked", 4}, {"unsupported", 0}, {"wrong", 0}}}}};
  const std::vector<FuzzFigures> rows = fuzz_figures(summary);
  ASSERT_EQ(rows.size(), 3u) << "formats are not added up";
  EXPECT_EQ(rows[0].judged, 19u);
  EXPECT_EQ(rows[0].wrong, 5u);
}

TEST(Tour, ReadsThePlacesOfDifferingPixels) {
  const Json stats = {{"fmt", "binary32"},
                      {"width", 320},
                      {"height", 240},
                      {"difference", {{"against", "mt-float"}, {"pixels", 2}, {"pixels_of_other_colour", 1}}}};
  const PictureFigures f = picture_figures(stats, {counterexample("px-181-26-primary-tri4760", below_half)});
  ASSERT_EQ(f.places.size(), 1u);
  EXPECT_EQ(f.places[0].column, 181);
  EXPECT_EQ(f.places[0].row, 26);
}

}  // namespace
}  // namespace tribunal
