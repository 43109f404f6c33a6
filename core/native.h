// A test as its own users would call it: a loop that is compiled around it, on data laid out as it takes them. A clock
// runs these; everything else asks a method through its functions, where the call itself has a price.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "core/operands.h"

namespace tribunal {

/// A segment and the triangle that it is asked about.
struct SegmentPair {
  Segment segment;
  Triangle triangle;
};

/// One pass over pairs that are already in place. Writes 1 for a hit and 0 for none, one byte a pair.
using NativeRun = std::function<void(std::span<std::uint8_t> hits)>;

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
    return [test, pairs](std::span<std::uint8_t> hits) {
      for (std::size_t i = 0; i < pairs.size(); ++i) hits[i] = test(pairs[i].segment, pairs[i].triangle);
    };
  };
  return {.single = loop, .bytes = sizeof(Triangle)};
}

}  // namespace tribunal
