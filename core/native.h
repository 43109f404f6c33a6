// A test as its own users would call it: a loop that is compiled around it, on data laid out as it takes them. A clock
// runs these; everything else asks a method through its functions, where the call itself has a price.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <numeric>
#include <span>
#include <vector>

#include "core/operands.h"

namespace tribunal {

/// A segment and the triangle that it is asked about.
struct SegmentPair {
  Segment segment;
  Triangle triangle;
};

/// The pair read as one of a ray: from the segment's first point in direction `q`, taken as a vector.
inline Ray ray_of(const SegmentPair& p) { return {p.segment.p, {p.segment.q}}; }

/// One pass over n pairs that are already in place, n being the size of `hits`: 1 for a hit and 0 for none. Tests one
/// by one are asked in the order 0, step, 2·step … modulo n. Passes with one step after the other find the data in the
/// cache, as a loop over the same pairs does, but no branch predictor can learn their answers by heart.
using NativeRun = std::function<void(std::span<std::uint8_t> hits, std::size_t step)>;

/// Calls visit(i) for all i < n, in the order 0, step, 2·step … modulo n. step < n has no divisor in common with n.
template <class Visit>
void visit_by_steps(std::size_t n, std::size_t step, const Visit& visit) {
  std::size_t i = 0;
  for (std::size_t k = 0; k < n; ++k) {
    visit(i);
    i += step;
    i -= i >= n ? n : 0;
  }
}

/// A step for the next pass: each of those that have no divisor in common with n comes once before any comes again.
inline std::size_t next_step(std::size_t step, std::size_t n) {
  do {
    step = step + 1 < n ? step + 1 : 1;
  } while (std::gcd(step, n) != 1);
  return step;
}

/// Takes pairs and lays them out as the test takes them, which no clock counts.
using NativeLoop = std::function<NativeRun(std::span<const SegmentPair>)>;

/// A test that prepares triangles. `ask` answers from what the last `set_up` prepared.
struct PreparedRun {
  std::function<void()> set_up{};  ///< prepares every triangle once
  NativeRun ask{};
};

/// The loops of one test; those that it does not have are empty.
struct NativeLoops {
  NativeLoop single{};  ///< one test a pair
  NativeLoop batch{};   ///< all pairs in one call
  std::function<PreparedRun(std::span<const SegmentPair>)> prepared{};
  std::size_t bytes = 0;  ///< kept of each triangle by `prepared`, or else by `single`
};

/// The loop of test(segment, triangle) → bool, on the pairs as they are.
template <class Test>
NativeLoops native_loops(const Test& test) {
  const auto loop = [test](std::span<const SegmentPair> given) -> NativeRun {
    const std::vector<SegmentPair> pairs(given.begin(), given.end());
    return [test, pairs](std::span<std::uint8_t> hits, std::size_t step) {
      visit_by_steps(hits.size(), step, [&](std::size_t i) { hits[i] = test(pairs[i].segment, pairs[i].triangle); });
    };
  };
  return {.single = loop, .bytes = sizeof(Triangle)};
}

/// The loop of test(ray, triangle) → bool, on the same pairs read as pairs of rays.
template <class Test>
NativeLoops native_ray_loops(const Test& test) {
  return native_loops([test](const Segment& s, const Triangle& t) { return test(Ray{s.p, {s.q}}, t); });
}

}  // namespace tribunal
