// Time per test, of many methods on the same cases.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/method.h"

namespace tribunal {

struct SegmentCase {
  Segment segment;
  Triangle triangle;
};

/// Nanoseconds per test over the repetitions, nothing subtracted: the call through the method's interface counts.
struct Timing {
  std::uint64_t batch = 0;  ///< tests in one repetition: a prefix of the cases
  int repetitions = 0;
  double min = 0, lower_quartile = 0, median = 0, upper_quartile = 0, max = 0;
};

/// One Timing a method. Each repetition times a batch of every method in turn, so that a change of the machine's speed
/// meets all of them. A slow method gets a shorter batch, of whole rounds of `round` cases where there are as many.
std::vector<Timing> time_methods(std::span<const Method* const> methods, std::span<const SegmentCase> cases,
                                 std::size_t round, int repetitions);

/// The quartiles of the samples, of which there must be at least one.
Timing summarise(std::vector<double> nanoseconds);

}  // namespace tribunal
