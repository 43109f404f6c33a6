// Tests of the tests: each planted bug must be found by fuzz well within a minute, from a seed that nobody chose for
// it, and no other method may be blamed. TRIBUNAL_PLANTED_SEED tries another seed.
#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <set>

#include "exact/base/failure.h"
#include "exact/base/fp_environment.h"
#include "exact/methods/methods.h"
#include "exact/trial/fuzz.h"
#include "tests/planted/bugs.h"

namespace tribunal {
namespace {

std::uint64_t seed() {
  const char* given = std::getenv("TRIBUNAL_PLANTED_SEED");
  return given != nullptr ? std::strtoull(given, nullptr, 10) : 20240229;
}

/// A plan that tries the bug first, and methods without a bug beside it.
FuzzPlan plan_for(const Method& bug, std::uint64_t cases, const std::vector<Method>& sound,
                  std::vector<Stream> streams) {
  FuzzPlan plan;
  plan.methods = {bug, *find_method("sf-epick"), *find_method("sf-rational")};
  for (const Method& m : sound) plan.methods.push_back(m);
  plan.streams = std::move(streams);
  plan.seed = seed();
  plan.cases = cases;
  plan.seconds = 60;
  plan.threads = 1;
  return plan;
}

FuzzPlan plan_for(const Method& bug, std::uint64_t cases) {
  return plan_for(bug, cases, planted::sound_twins(), streams_of(Operands::triangles));
}

FuzzPlan polygon_plan_for(const Method& bug, std::uint64_t cases) {
  return plan_for(bug, cases, planted::sound_polygons(), streams_of(Operands::polygons));
}

struct Hunt {
  std::uint64_t cases = 0;  ///< cases up to the first wrong answer, which is included; 0 if there was none
  double seconds = 0;
  std::set<std::string> blamed;
};

Hunt result_of(const FuzzPlan& plan, const FuzzReport& report) {
  Hunt hunt;
  for (const auto& f : report.findings) {
    const std::uint64_t g = f.k * plan.streams.size() + f.stream + 1;
    hunt.cases = hunt.cases == 0 ? g : std::min(hunt.cases, g);
    hunt.blamed.insert(plan.methods[f.method].name);
  }
  return hunt;
}

/// Runs the plan with ever more cases until something is found or a minute is over; the time of all runs counts.
template <class PlanFor>
Hunt hunt_for(const Method& bug, const PlanFor& plan_of) {
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  const auto elapsed = [&] { return std::chrono::duration<double>(Clock::now() - start).count(); };
  Hunt hunt;
  for (std::uint64_t cases = 500; hunt.blamed.empty() && elapsed() < 60; cases *= 4) {
    const auto plan = plan_of(bug, cases);
    hunt = result_of(plan, fuzz(plan));
  }
  hunt.seconds = elapsed();
  return hunt;
}

template <class PlanFor>
void expect_all_found(const std::vector<Method>& bugs, const PlanFor& plan_of) {
  std::printf("  %-24s %8s %8s  %-24s %s\n", "bug", "cases", "seconds", "blamed", "what is wrong");
  for (const Method& bug : bugs) {
    const Hunt hunt = hunt_for(bug, plan_of);
    EXPECT_EQ(hunt.blamed, std::set<std::string>{bug.name}) << bug.name << ": " << bug.card.summary;
    EXPECT_LT(hunt.seconds, 60) << bug.name;
    std::printf("  %-24s %8llu %8.2f  %-24s %s\n", bug.name.c_str(), static_cast<unsigned long long>(hunt.cases),
                hunt.seconds, hunt.blamed.empty() ? "" : hunt.blamed.begin()->c_str(), bug.card.summary.c_str());
  }
}

TEST(PlantedBugs, AreEachFoundAndNobodyElseIsBlamed) {
  const std::vector<Method> bugs = planted::bugs();
  EXPECT_GE(bugs.size(), 30U);
  expect_all_found(bugs, [](const Method& bug, std::uint64_t cases) { return plan_for(bug, cases); });
}

TEST(PlantedBugs, OfPolygonsAreEachFoundAndNobodyElseIsBlamed) {
  const std::vector<Method> bugs = planted::polygon_bugs();
  EXPECT_GE(bugs.size(), 30U);
  expect_all_found(bugs, polygon_plan_for);
}

/// A longer run for those who must never be blamed.
TEST(PlantedBugs, SoundTwinsAreRight) {
  FuzzPlan plan = plan_for(*find_method("sf-epick"), 52'000);
  plan.threads = 2;
  const FuzzReport report = fuzz(plan);
  for (const Finding& f : report.findings) ADD_FAILURE() << plan.methods[f.method].name;
}

/// A method that changes the floating-point environment would spoil later answers, so the run stops and names it.
TEST(PlantedBugs, AChangedEnvironmentIsNoticedAndNamed) {
  const FuzzPlan plan = plan_for(planted::environment_bug(), 500);
  try {
    fuzz(plan);
    FAIL() << "not noticed";
  } catch (const Failure& failure) {
    EXPECT_EQ(failure.exit(), Exit::fp_environment);
    EXPECT_NE(std::string(failure.what()).find(plan.methods[0].name), std::string::npos) << failure.what();
  }
  EXPECT_TRUE(has_exact_rounding()) << "and the thread is repaired";
}

}  // namespace
}  // namespace tribunal
