// The tests that the paper compares, as loops to be timed: one source, compiled for each set of flags by contenders.cpp
// into a library of its own.
#pragma once

#include <cstddef>
#include <functional>
#include <span>

#include "core/native.h"

namespace tribunal::bench {

/// What a pass over pairs found: how many hit, and the sum of their parameters, which is added up so that no compiler
/// can leave the point out.
struct Pass {
  std::size_t hits = 0;
  double parameters = 0;
};

/// One pass over pairs that are in place, in the order of `visit_by_steps`.
using Run = std::function<Pass(std::size_t step)>;

/// One test. `asks` wants to know whether a pair meets; `point` wants the parameter of each hit as well. Both lay out
/// the pairs as the test takes them, which is not timed.
struct Contender {
  const char* name;
  Run (*asks)(std::span<const SegmentPair> pairs);
  Run (*point)(std::span<const SegmentPair> pairs);
};

}  // namespace tribunal::bench

extern "C" {
std::span<const tribunal::bench::Contender> contenders_sse2();
std::span<const tribunal::bench::Contender> contenders_x87();
std::span<const tribunal::bench::Contender> contenders_native();
}
