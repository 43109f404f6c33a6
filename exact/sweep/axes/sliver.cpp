// Needle-thin triangles.
#include "exact/cases/families/placing.h"
#include "exact/cases/families/shapes.h"
#include "exact/sweep/axes/placed.h"
#include "exact/sweep/axes/table.h"

namespace tribunal {
namespace {

constexpr int aspects_64[] = {0, 4, 8, 12, 16, 20, 24, 28, 32, 36, 40, 44, 48, 50, 52, 54, 60, 80};
constexpr int aspects_32[] = {0, 2, 4, 6, 8, 10, 12, 14, 16, 18, 20, 22, 24, 26, 30, 40};
constexpr auto aspects = by_format<aspects_64, aspects_32>;

Trial place(Draw& draw, Format format, int value, std::uint64_t k) {
  const SegmentPair pair = place_sliver(draw, format, value);
  return placed_probe(k, pair, format, draw);
}

}  // namespace

StressAxis sliver_axis() {
  return {.name = "sliver",
          .quantity = "length over height of the triangle (log2)",
          .population = "random triangles in [-1,1]^3 flattened to a height of 2^-value, a probe near or through each",
          .easiest = zero,
          .values = aspects,
          .stream = stream_of("sweep sliver"),
          .place = place};
}

}  // namespace tribunal
