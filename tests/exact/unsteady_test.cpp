// Methods that are no function of their query: what is written of them never says that they were wrong where they
// answered what was due.
#include <gtest/gtest.h>

#include <atomic>
#include <memory>

#include "exact/methods/methods.h"
#include "exact/record/counterexample.h"

namespace tribunal {
namespace {

/// The reference, with hit and miss exchanged if `turn` says so for the query.
template <class Turn>
Method unsteady(const Turn& turn) {
  Method m = reference_method();
  m.name = "unsteady";
  m.segment = [turn](const Segment& s, const Triangle& t) {
    Answer answer = reference_method().segment(s, t);
    answer.hit ^= turn(s);
    return answer;
  };
  return m;
}

FuzzReport report_of(const FuzzPlan& plan) { return fuzz(plan); }

/// Expects that all counterexamples of a short run are faults, at least `fewest` of them.
void expect_faults(const Method& m, int fewest) {
  const FuzzPlan plan{
      .methods = {m}, .streams = streams_of(Operands::triangles), .seed = 3, .cases = 3000, .threads = 2};
  int faults = 0, written = 0;
  for (const Finding& f : report_of(plan).findings) {
    if (++written > 40) break;
    const Case c = to_counterexample(plan, f);
    faults += c.finding.value("fault", "") == "answers differently when asked twice";
    EXPECT_NE(c.finding.contains("answered"), c.finding.contains("fault"));
    EXPECT_NE(c.finding.value("answered", -1), c.finding["expected"].get<int>()) << c.finding.dump();
  }
  EXPECT_GE(faults, fewest);
}

TEST(Unsteady, AnswersByCallCount) {
  const auto calls = std::make_shared<std::atomic<unsigned>>(0);
  expect_faults(unsteady([calls](const Segment&) { return (*calls)++ % 3 == 0; }), 40);
}

TEST(Unsteady, AnswersAtRandom) {
  const auto state = std::make_shared<std::atomic<std::uint64_t>>(1);
  const auto turn = [state](const Segment&) {
    return ((*state = *state * 6364136223846793005U + 1442695040888963407U) >> 63) != 0;
  };
  expect_faults(unsteady(turn), 30);
}

TEST(Unsteady, DependsOnTheQueryBefore) {
  const auto before = std::make_shared<std::atomic<double>>(0.0);
  expect_faults(unsteady([before](const Segment& s) { return before->exchange(s.p.x) > s.p.x; }), 30);
}

}  // namespace
}  // namespace tribunal
