// Time per test, of many methods on cases of the same population.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "core/method.h"

namespace tribunal {

/// A median with the interval that holds the median of the population with at least 95 % confidence: two order
/// statistics of the samples, whose ranks the binomial distribution with p = 1/2 gives, so nothing is assumed of how
/// samples scatter. Fewer than six samples give none: lower = 0, upper = ∞.
struct Median {
  double value = 0, lower = 0, upper = 0;

  bool has_interval() const;
};

/// There must be at least one sample.
Median median_of(std::vector<double> samples);

/// Nanoseconds per pair over the repetitions, nothing subtracted.
struct Timing {
  std::uint64_t batch = 0;  ///< pairs in one repetition
  std::uint64_t stretches =
      0;  ///< different ones that the repetitions took: as many as these, if there are cases enough
  int repetitions = 0;
  double min = 0, lower_quartile = 0, median = 0, upper_quartile = 0, max = 0;
  std::optional<Median> ratio{};  ///< of each repetition's time to the yardstick's in the same repetition, if one ran
};

/// A test laid out on some of the cases of a population, which no clock counts: from `first` on, `count` of them.
using TimedTest = std::function<NativeRun(std::size_t first, std::size_t count)>;

/// What is timed, and how.
struct TimedRun {
  std::size_t cases = 0;                   ///< of the population, at least 1; every stretch lies within
  std::size_t round = 1;                   ///< stretches are whole rounds, where there are as many cases
  int repetitions = 31;                    ///< at least 1
  std::optional<std::size_t> yardstick{};  ///< index of the test to whose time all others are divided
};

/// One Timing a test. Each repetition times a pass of every test in turn, so that a change of the machine's speed meets
/// all of them, and all over the same stretch of cases, of which a slow test is asked only the first rounds: the cases
/// of a ratio are of one population, but not as many on both sides. The stretch follows the one of the repetition
/// before and is laid out just now: its cases lie in the cache, and no branch predictor knows their answers by heart.
/// With fewer than repetitions + 1 rounds of cases, stretches come again. No two tests may run the same code: the first
/// would teach the branch predictor what the second is asked. Throws std::logic_error if one that comes again is
/// answered otherwise. Fails with 128 + signal if interrupted.
std::vector<Timing> time_stretches(std::span<const TimedTest> tests, const TimedRun& run);

/// The loop on stretches of these pairs, which must outlive it.
TimedTest timed_test(const NativeLoop& loop, std::span<const SegmentPair> pairs);

/// The method's loops of these probes.
const NativeLoops& loops_of(const Method& method, ProbeKind kind);

/// The method's own loop of single tests, or one that calls its `segment`, or its `ray`, for each pair.
NativeLoop single_loop(const Method& method, ProbeKind kind = ProbeKind::segment);

/// The part of `prepared` that prepares, and the part that asks. The method has both.
NativeLoop set_up_loop(const Method& method);
NativeLoop prepared_loop(const Method& method, ProbeKind kind = ProbeKind::segment);

/// What a clock shows of a test that does nothing: in a loop of its own, and as a C function, asked through a pointer
/// as a plugin's is.
NativeLoop empty_loop();
NativeLoop empty_call_loop();

/// The quartiles of the samples, of which there must be at least one.
Timing summarise(std::vector<double> nanoseconds);

}  // namespace tribunal
