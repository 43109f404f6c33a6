#include "exact/chart/chart.h"

#include <algorithm>
#include <chrono>
#include <set>
#include <tuple>

#include "exact/base/files.h"
#include "exact/base/json.h"
#include "exact/certificate/bounds.h"
#include "exact/certificate/rate.h"
#include "tests/tracer/support.h"

namespace tribunal {
namespace {

using testing::method;

ChartPlan small_plan(unsigned threads = 1) {
  return {.methods = {method("sf-float"), method("sf-double"), method("sf-epick"), method("cgal-epick"),
                      method("haines-double")},
          .seed = 7,
          .cases = 1000,
          .repetitions = 9,
          .threads = threads};
}

const Json& small_chart() {
  static const Json chart = to_json(small_plan(), measure(small_plan()));
  return chart;
}

TEST(Chart, AsksEveryMethodOnceInEveryPanelThatItTakes) {
  std::multiset<std::tuple<std::string, std::string, std::string>> asked;
  for (const Json& row : small_chart()["rows"]) asked.emplace(row["method"], row["population"], row["fmt"]);
  EXPECT_EQ(small_chart()["panels"].size(), 2 * all_populations().size());
  for (const Population& p : all_populations()) {
    for (const Method& m : small_plan().methods) {
      for (const Format f : {Format::binary32, Format::binary64}) {
        const std::size_t times = takes(m, p) && takes(m, f) ? 1 : 0;
        EXPECT_EQ(asked.count({m.name, std::string(p.key), std::string(name_of(f))}), times) << m.name << " " << p.key;
      }
    }
  }
}

/// What a drawing needs to know of a method stands in the record, a plugin's too: nobody looks at names.
TEST(Chart, TellsWhatADrawingNeedsOfAMethod) {
  Method mine = method("mt-float");
  mine.name = "quick";
  const ChartPlan plan{.methods = {mine, method("sf-filtered"), method("mt-double"), method("cgal-epeck")}};
  const Json methods = to_json(plan, Chart{})["methods"];
  const auto has = [&](std::size_t i, const Json& part) {
    for (const auto& [key, value] : part.items()) EXPECT_EQ(methods[i][key], value) << methods[i] << " " << key;
  };
  has(0, {{"fmt", "binary32"}, {"exact", false}, {"certified", false}, {"maker", "plugin"}, {"origin", "plugin"}});
  has(1, {{"exact", true}, {"certified", true}, {"maker", "segura-feito"}, {"origin", "built-in"}});
  has(2, {{"fmt", "binary64"}, {"exact", false}, {"maker", "published"}, {"yardstick", true}});
  has(3, {{"exact", true}, {"certified", false}, {"maker", "library"}, {"yardstick", false}});
}

/// Of any 100 cases in a row the share hits that the panel is named after, and no population is added to another.
TEST(Chart, DealsTheSharesOfHits) {
  int dealt = 0;
  for (const Json& panel : small_chart()["panels"]) {
    EXPECT_EQ(panel["cases"], 1000);
    if (panel["percent_hits"].is_null()) continue;
    EXPECT_EQ(panel["hits"], 10 * panel["percent_hits"].get<int>()) << panel;
    EXPECT_EQ(panel["subnormal"], 0);
    ++dealt;
  }
  EXPECT_EQ(dealt, 8);
}

TEST(Chart, SaysWhatNearlyDegenerateIsMadeOf) {
  for (const Json& panel : small_chart()["panels"]) {
    if (panel["population"] != "near") continue;
    EXPECT_GT(panel["subnormal"], 50) << panel;
    EXPECT_GT(panel["by_stage"]["exact"], 50) << panel;
  }
}

TEST(Chart, JudgesBinary32MethodsOnBinary32CasesOnly) {
  for (const Json& row : small_chart()["rows"]) {
    if (row["method"] != "sf-float") continue;
    EXPECT_EQ(row["fmt"], "binary32");
  }
}

TEST(Chart, TimesEveryRow) {
  for (const Json& row : small_chart()["rows"]) {
    const Json& t = row["nanoseconds"];
    EXPECT_GE(t["repetitions"], 9);
    EXPECT_GT(t["batch"], 0);
    EXPECT_GT(t["min"], 0.0);
    EXPECT_LE(t["min"], t["median"]);
    EXPECT_LE(t["median"], t["max"]);
    EXPECT_GT(t["ratio"]["lower"], 0.0);
    EXPECT_LE(t["ratio"]["lower"], t["ratio"]["median"]);
    EXPECT_LE(t["ratio"]["median"], t["ratio"]["upper"]);
  }
}

/// Timed a second time on the same cases it would take less than half as long: the branch predictor learns thousands of
/// answers in one pass.
TEST(Chart, TheYardstickIsOne) {
  const ChartPlan plan{
      .methods = {method("sf-double"), yardstick_method()}, .seed = 1, .cases = 1630, .repetitions = 9, .threads = 1};
  const Chart chart = measure(plan);
  int rows = 0;
  for (const ChartRow& row : chart.rows) {
    if (row.method != 1) continue;
    ++rows;
    EXPECT_EQ(row.time.ratio->value, 1);
    EXPECT_EQ(row.time.ratio->upper, 1);
  }
  EXPECT_EQ(rows, 12) << "six populations of triangles in two formats";
  for (const SpeedRow& row : chart.speed) {
    if (row.method != yardstick_method().name || std::string(row.call) != "single") continue;
    for (const Timing& time : row.times) EXPECT_EQ(time.ratio->value, 1);
  }
}

TEST(Chart, HoldsTheMethodsToWhatIsKnownOfThem) {
  for (const Json& row : small_chart()["rows"]) {
    const Json& a = row["answers"];
    EXPECT_EQ(a["asked"], 1000);
    if (find_method(row["method"].get<std::string>())->contract.exact) {
      EXPECT_EQ(a["wrong"], 0) << row;
    }
    if (row["population"] != "degenerate") continue;
    if (row["method"] == "sf-float") {
      EXPECT_GT(a["wrong"], 0) << row;
    }
    EXPECT_EQ(a["unsupported"] > 0, row["method"] == "cgal-epick") << row;
    EXPECT_TRUE(row["own_format"] == (row["fmt"] == "binary64") || row["method"] == "sf-float") << row;
  }
}

TEST(Chart, CountsAreTheSameForAnyNumberOfThreads) {
  const Chart one = measure(small_plan(1)), three = measure(small_plan(3));
  ASSERT_EQ(one.rows.size(), three.rows.size());
  for (std::size_t i = 0; i < one.rows.size(); ++i) EXPECT_EQ(one.rows[i].count, three.rows[i].count);
  for (std::size_t i = 0; i < one.panels.size(); ++i) EXPECT_EQ(one.panels[i].makeup, three.panels[i].makeup);
}

TEST(Rate, ZeroIsDrawnAtItsUpperBound) {
  const Json none = to_json(Count{.asked = 1100, .wrong = 0, .unsupported = 100});
  EXPECT_EQ(none["bound"], true);
  EXPECT_EQ(none["share"], 0.0);
  EXPECT_EQ(none["judged"], 1000);
  EXPECT_DOUBLE_EQ(none["drawn"], upper_bound(0, 1000, 0.05));
  EXPECT_NEAR(none["drawn"], 0.00299, 1e-5);  // 1 − 0.05^(1/1000)
}

TEST(Rate, SomeIsDrawnWhereItIsInsideItsInterval) {
  const Json some = to_json(Count{.asked = 1000, .wrong = 10, .unsupported = 0});
  EXPECT_EQ(some["bound"], false);
  EXPECT_DOUBLE_EQ(some["drawn"], 0.01);
  EXPECT_LT(some["lower"], 0.01);
  EXPECT_GT(some["upper"], 0.01);
}

TEST(Rate, NothingJudgedIsNotZero) {
  EXPECT_EQ(to_text(Count{.asked = 5, .wrong = 0, .unsupported = 5}), "nothing judged");
  EXPECT_EQ(to_json(Count{})["drawn"], 1.0);
}

TEST(Populations, GeneralPositionIsExactInBinary32) {
  const Population& general = all_populations().front();
  for (std::uint64_t k = 0; k < 200; ++k) {
    const Query query = general.family.make(Format::binary32, 1, k).query;
    for (const Point3& v : {query.triangle().a, query.triangle().b, query.triangle().c}) {
      for (int axis = 0; axis < 3; ++axis) EXPECT_TRUE(is_exact_in(v[axis], Format::binary32));
    }
  }
}

TEST(Populations, DegenerateOnesVisitEveryClassAtTheLastLevel) {
  const Population& degenerate = all_populations()[1];
  for (const Format format : {Format::binary32, Format::binary64}) {
    std::set<int> classes;
    for (std::uint64_t k = 0; k < 163; ++k) {
      const Trial trial = degenerate.family.make(format, 1, k);
      classes.insert(trial.class_id);
      EXPECT_EQ(trial.level + 1u, degenerate.family.levels(format).size());
    }
    EXPECT_EQ(classes.size(), 163u);
  }
}

TEST(Timing, SummaryInterpolatesBetweenSamples) {
  const Timing t = summarise({4, 1, 3, 2});
  EXPECT_EQ(t.repetitions, 4);
  EXPECT_DOUBLE_EQ(t.min, 1);
  EXPECT_DOUBLE_EQ(t.lower_quartile, 1.75);
  EXPECT_DOUBLE_EQ(t.median, 2.5);
  EXPECT_DOUBLE_EQ(t.upper_quartile, 3.25);
  EXPECT_DOUBLE_EQ(t.max, 4);
}

TEST(Timing, MedianLiesBetweenTwoOrderStatistics) {
  EXPECT_FALSE(median_of({1, 2, 3, 4, 5}).has_interval());  // 1 − 2 · 2⁻⁵ is below 95 %
  const Median six = median_of({6, 1, 5, 2, 4, 3});
  EXPECT_DOUBLE_EQ(six.value, 3.5);
  EXPECT_DOUBLE_EQ(six.lower, 1);
  EXPECT_DOUBLE_EQ(six.upper, 6);
  std::vector<double> samples(31);
  for (std::size_t i = 0; i < samples.size(); ++i) samples[i] = static_cast<double>(i + 1);
  const Median many = median_of(samples);  // P(B(31, 1/2) < 10) = 0.0147, P(B(31, 1/2) < 11) = 0.0354
  EXPECT_DOUBLE_EQ(many.lower, 10);
  EXPECT_DOUBLE_EQ(many.upper, 22);
}

/// Ranks by sums of whole binomial coefficients; 2⁻¹⁰⁷⁵ is no binary64 number.
TEST(Timing, RanksOfTheIntervalForAnyNumberOfSamples) {
  const std::vector<std::pair<std::size_t, std::size_t>> known = {{1, 0},   {5, 0},      {6, 1},      {9, 2},
                                                                  {31, 10}, {1074, 505}, {1075, 505}, {10'000, 4902}};
  for (const auto& [n, rank] : known) {
    EXPECT_EQ(median_rank(n, confidence_alpha), rank) << n;
    std::vector<double> samples(n);
    for (std::size_t i = 0; i < n; ++i) samples[i] = static_cast<double>(i + 1);
    const Median median = median_of(samples);
    EXPECT_EQ(median.has_interval(), rank > 0) << n;
    EXPECT_DOUBLE_EQ(median.lower, static_cast<double>(rank)) << n;
    if (rank > 0) {
      EXPECT_DOUBLE_EQ(median.upper, static_cast<double>(n + 1 - rank)) << n;
    }
  }
}

/// The cases that a test was laid out on, by the first and their number.
using LaidOut = std::vector<std::pair<std::size_t, std::size_t>>;

/// A test that takes so long a case, and notes what it is laid out on.
TimedTest idle_test(std::chrono::nanoseconds a_case, LaidOut& laid_out) {
  return [a_case, &laid_out](std::size_t first, std::size_t count) -> NativeRun {
    laid_out.emplace_back(first, count);
    return [a_case](std::span<std::uint8_t> hits, std::size_t) {
      const auto until = std::chrono::steady_clock::now() + a_case * hits.size();
      while (std::chrono::steady_clock::now() < until) continue;
    };
  };
}

/// No case is asked before the repetition that times it: not in another one, nor while warming up.
TEST(Timing, AsksNoCaseBeforeItsTimeIsTaken) {
  LaidOut quick, slow;
  const std::vector<TimedTest> tests = {idle_test(std::chrono::nanoseconds(1), quick),
                                        idle_test(std::chrono::microseconds(10), slow)};
  const std::vector<Timing> times =
      time_stretches(tests, {.cases = 1000, .round = 25, .repetitions = 9, .yardstick = 0});
  for (const LaidOut* laid_out : {&quick, &slow}) {
    ASSERT_EQ(laid_out->size(),
              1u + 2 * 9);  // a trial; in each repetition a pass before the clock runs, and the timed one
    std::set<std::size_t> asked;
    for (std::size_t i = 0; i < laid_out->size(); ++i) {
      const auto [first, count] = (*laid_out)[i];
      EXPECT_LE(first + count, 1000u);
      for (std::size_t k = first; k < first + count; ++k) {
        EXPECT_TRUE(asked.insert(k).second || i % 2 == 1 || i == 0) << "case " << k << " in pass " << i;
      }
    }
  }
  for (std::size_t i = 2; i < quick.size(); i += 2) {
    EXPECT_EQ(quick[i].first, 100 * (i / 2 - 1));
    EXPECT_EQ(slow[i].first, quick[i].first) << "the same stretch";
    EXPECT_LE(slow[i].second, 50u) << "a slow test is asked a part of it";
  }
  EXPECT_EQ(times[0].stretches, 9u);
  ASSERT_TRUE(times[0].ratio);
  EXPECT_DOUBLE_EQ(times[0].ratio->value, 1);
}

/// By default every repetition has its own stretch, with --quick too; where there are too few rounds, they come again.
TEST(Timing, SaysHowManyStretchesThereWere) {
  const auto stretches = [](std::size_t cases, int repetitions) {
    LaidOut laid_out;
    const std::vector<TimedTest> tests = {idle_test(std::chrono::nanoseconds(0), laid_out)};
    return time_stretches(tests, {.cases = cases, .round = 163, .repetitions = repetitions, .yardstick = {}})[0]
        .stretches;
  };
  EXPECT_EQ(stretches(65'200, 31), 31u);
  EXPECT_EQ(stretches(3'260, 9), 9u);
  EXPECT_EQ(stretches(3'260, 50), 20u);
  EXPECT_EQ(stretches(326, 9), 2u);
  EXPECT_EQ(stretches(100, 9), 1u);
}

std::string drawn_from(const testing::TemporaryDirectory& directory, const Json& record) {
  directory.file("chart.json", record.dump());
  plot(directory.path("."));
  return read_file(directory.path("speed-accuracy.svg"));
}

TEST(Plot, DrawsAllFiguresAndTheSameBytesAgain) {
  const testing::TemporaryDirectory directory;
  const std::string first = drawn_from(directory, small_chart());
  EXPECT_NE(first.find("<svg"), std::string::npos);
  const std::vector<std::string> figures = {"speed-accuracy", "speed-accuracy-shares", "speed-accuracy-polygons",
                                            "speed"};
  std::vector<std::string> bytes;
  for (const std::string& figure : figures) {
    for (const char* ending : {".svg", ".pdf", ".png"}) {
      bytes.push_back(read_file(directory.path(figure + ending)));
      EXPECT_GT(bytes.back().size(), 1000u) << figure << ending;
    }
  }
  EXPECT_EQ(plot(directory.path(".")), figures);
  for (const std::string& figure : figures) {
    for (const char* ending : {".svg", ".pdf", ".png"}) {
      EXPECT_EQ(read_file(directory.path(figure + ending)), bytes[0]) << figure << ending;
      bytes.erase(bytes.begin());
    }
  }
}

/// A chart of polygons' methods alone, or of triangles' alone, has fewer figures, and none of an older record stays.
TEST(Plot, NamesWhatItDrewAndRemovesTheOthers) {
  const testing::TemporaryDirectory directory;
  directory.file("pictures.svg", "of an older record");
  directory.file("speed-accuracy-polygons.png", "of an older record");
  directory.file("mine.svg", "nobody's");
  Json record = small_chart();
  Json& rows = record["rows"];
  rows.erase(std::remove_if(rows.begin(), rows.end(),
                            [](const Json& row) { return row["population"].get<std::string>().starts_with("poly"); }),
             rows.end());
  directory.file("chart.json", record.dump());
  EXPECT_EQ(plot(directory.path(".")), (std::vector<std::string>{"speed-accuracy", "speed-accuracy-shares", "speed"}));
  EXPECT_FALSE(std::filesystem::exists(directory.path("pictures.svg")));
  EXPECT_FALSE(std::filesystem::exists(directory.path("speed-accuracy-polygons.png")));
  EXPECT_TRUE(std::filesystem::exists(directory.path("mine.svg")));
  EXPECT_TRUE(std::filesystem::exists(directory.path("speed.svg")));
}

/// As of an older version: the record is to blame, not Python, and the script's own words are kept.
TEST(Plot, ARecordThatCannotBeDrawnIsBadInput) {
  const testing::TemporaryDirectory directory;
  Json record = small_chart();
  record.erase("yardstick");
  directory.file("chart.json", record.dump());
  const std::string refusal = testing::refusal_of([&] { plot(directory.path(".")); });
  EXPECT_NE(refusal.find("chart.json: not as this version writes it"), std::string::npos) << refusal;
  EXPECT_NE(read_file(directory.path("plot.log")).find("KeyError: 'yardstick'"), std::string::npos);
}

}  // namespace
}  // namespace tribunal
