// The compiler as a stress axis: strict builds of both compilers answer as the program does, others do not, and what
// is said of them can be asked again.
#include <gtest/gtest.h>

#include <algorithm>

#include "exact/base/json.h"
#include "exact/cases/family_table.h"
#include "exact/compilers/compare.h"
#include "exact/methods/methods.h"
#include "exact/trial/judge.h"
#include "exact/trial/truth.h"

namespace tribunal {
namespace {

const std::vector<Build>& builds() {
  static const std::vector<Build> all = all_builds();
  return all;
}

std::vector<std::string> names() {
  std::vector<std::string> all;
  for (const Method& m : builds().front().methods) all.push_back(m.name);
  return all;
}

bool ends_with(const BuildRow& row, const char* text) { return builds()[row.build].name.ends_with(text); }

TEST(Compilers, BuildEveryNaiveMethodAgain) {
  ASSERT_GE(builds().size(), 6U) << "g++, at least";
  std::size_t shelf = 0;
  for (const Method& m : all_methods()) shelf += m.exact_twin != nullptr;
  for (const Build& build : builds()) {
    EXPECT_EQ(build.methods.size(), shelf) << build.name;
    EXPECT_FALSE(build.compiler.empty() || build.flags.empty());
  }
}

TEST(Compilers, StrictBuildsAnswerAsTheProgramAndContractedOnesDoNot) {
  const ComparePlan plan{.builds = builds(), .methods = names(), .seed = 3, .cases = 20'000, .threads = 2};
  const std::vector<BuildRow> rows = compare_builds(plan);
  ASSERT_EQ(rows.size(), plan.builds.size() * plan.methods.size());
  std::uint64_t contracted = 0, extended = 0, witnesses = 0;
  for (const BuildRow& row : rows) {
    const std::string what = plan.methods[row.method] + " by " + builds()[row.build].name;
    EXPECT_EQ(row.count.asked, plan.cases) << what;
    EXPECT_LE(row.spoiled + row.mended, row.changed) << what;
    EXPECT_EQ(row.witness.has_value(), row.changed > 0) << what;
    if (ends_with(row, "O2") || ends_with(row, "O0")) {
      EXPECT_EQ(row.changed, 0U) << what;
    }
    contracted += ends_with(row, "contracted") ? row.changed : 0;
    extended += ends_with(row, "x87") ? row.changed : 0;
    if (!row.witness) continue;
    ++witnesses;
    const Method& there = builds()[row.build].methods[row.method];
    ASSERT_EQ(there.name, plan.methods[row.method]);
    EXPECT_NE(there.ask(row.witness->query).hit, find_method(there.name)->ask(row.witness->query).hit) << what;
  }
  EXPECT_GT(contracted, 1'000U);
  EXPECT_GT(extended, 1'000U);
  EXPECT_GT(witnesses, 50U);

  ComparePlan alone = plan;
  alone.threads = 1;
  EXPECT_EQ(to_json(alone, compare_builds(alone))["rows"].dump(), to_json(plan, rows)["rows"].dump());
}

/// What is counted of one method is what its answers come to, case by case, judged by the oracles.
TEST(Compilers, CountsAreThoseOfTheJudge) {
  const auto contracted = std::ranges::find_if(builds(), [](const Build& b) { return b.name == "g++-contracted"; });
  ASSERT_NE(contracted, builds().end());
  const Method &own = *find_method("mt-double"),
               &there =
                   *std::ranges::find_if(contracted->methods, [](const Method&m) { return m.name == "mt-double"; });
  BuildRow expected{};
  const std::span<const Family> families = families_of(Operands::triangles);
  constexpr std::uint64_t cases = 2'000;
  for (std::uint64_t k = 0; k < cases; ++k) {
    Query query = families[k % families.size()].make(Format::binary64, 5, k / families.size()).query;
    query.bounds.reset();
    const Truth truth = exact_truth(query);
    const Answer by_own = own.ask(query), by_there = there.ask(query);
    const bool here_wrong = is_wrong(judge(own, truth, by_own)), there_wrong = is_wrong(judge(there, truth, by_there));
    expected.count.wrong += there_wrong;
    expected.changed += by_own.hit != by_there.hit;
    expected.spoiled += by_own.hit != by_there.hit && there_wrong && !here_wrong;
    expected.mended += by_own.hit != by_there.hit && here_wrong && !there_wrong;
  }
  const auto rows = compare_builds({.builds = {*contracted}, .methods = {own.name}, .seed = 5, .cases = cases});
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_EQ(rows[0].count.wrong, expected.count.wrong);
  EXPECT_EQ(rows[0].changed, expected.changed);
  EXPECT_EQ(rows[0].spoiled, expected.spoiled);
  EXPECT_EQ(rows[0].mended, expected.mended);
  EXPECT_TRUE(rows[0].spoiled > 10 && rows[0].mended > 10 && rows[0].changed >= rows[0].spoiled + rows[0].mended);
}

}  // namespace
}  // namespace tribunal
