#include "exact/chart/chart.h"

#include <algorithm>
#include <set>

#include "exact/base/files.h"
#include "exact/base/json.h"
#include "exact/certificate/bounds.h"
#include "exact/certificate/rate.h"
#include "tests/tracer/support.h"

namespace tribunal {
namespace {

using testing::method;

ChartPlan small_plan(unsigned threads = 1) {
  return {.methods = {method("sf-float"), method("sf-double"), method("sf-epick"), method("cgal-epick")},
          .seed = 7,
          .cases = 1000,
          .repetitions = 9,
          .threads = threads};
}

const Json& small_chart() {
  static const Json chart = to_json(small_plan(), measure(small_plan()));
  return chart;
}

TEST(Chart, DrawsEveryMethodOnceInEveryPopulation) {
  std::multiset<std::pair<std::string, std::string>> drawn;
  for (const Json& row : small_chart()["rows"]) {
    if (row["drawn"] == true) drawn.emplace(row["method"], row["population"]);
  }
  EXPECT_EQ(drawn.size(), 4 * all_populations().size());
  for (const Population& p : all_populations()) {
    for (const Method& m : small_plan().methods) EXPECT_EQ(drawn.count({m.name, std::string(p.key)}), 1u) << m.name;
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
  }
}

TEST(Chart, OnsetShowsShortNumbersRightAndLongOnesWrong) {
  int never_wrong = 0, wrong = 0;
  for (const Json& row : small_chart()["onset"]) {
    if (row["method"] != "sf-double" || row["drawn"] != true) continue;
    if (row["bits"] == 0) never_wrong += row["answers"]["wrong"] == 0;
    if (row["bits"] == 50) wrong += row["answers"]["share"] > 0.1;
  }
  EXPECT_EQ(never_wrong, 1);
  EXPECT_EQ(wrong, 1);
}

TEST(Chart, CountsAreTheSameForAnyNumberOfThreads) {
  const Chart one = measure(small_plan(1)), three = measure(small_plan(3));
  ASSERT_EQ(one.rows.size(), three.rows.size());
  for (std::size_t i = 0; i < one.rows.size(); ++i) EXPECT_EQ(one.rows[i].count, three.rows[i].count);
  ASSERT_EQ(one.onset.size(), three.onset.size());
  for (std::size_t i = 0; i < one.onset.size(); ++i) EXPECT_EQ(one.onset[i].count, three.onset[i].count);
  for (std::size_t i = 0; i < one.panels.size(); ++i) EXPECT_EQ(one.panels[i].hits, three.panels[i].hits);
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
  for (const Format format : degenerate.formats) {
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

TEST(Plot, DrawsAllFiguresAndTheSameBytesAgain) {
  const testing::TemporaryDirectory directory;
  directory.file("chart.json", small_chart().dump());
  plot(directory.path("."));
  const std::string first = read_file(directory.path("speed-accuracy.svg"));
  EXPECT_NE(first.find("<svg"), std::string::npos);
  for (const char* name : {"speed-accuracy.png", "onset.svg", "onset.png", "speed.svg", "speed.png"}) {
    EXPECT_GT(read_file(directory.path(name)).size(), 1000u) << name;
  }
  plot(directory.path("."));
  EXPECT_EQ(read_file(directory.path("speed-accuracy.svg")), first);
}

TEST(Plot, WithoutNumbersIsOneLineAndExitCode7) {
  const testing::TemporaryDirectory directory;
  try {
    plot(directory.path("."));
    FAIL() << "drew nothing";
  } catch (const Failure& failure) {
    EXPECT_EQ(failure.exit(), Exit::resources);
    EXPECT_EQ(std::string(failure.what()).find('\n'), std::string::npos);
  }
}

}  // namespace
}  // namespace tribunal
