// Probes almost in the plane.
#include "exact/cases/families/placing.h"
#include "exact/cases/families/shapes.h"
#include "exact/sweep/axes/placed.h"
#include "exact/sweep/axes/table.h"

namespace tribunal {
namespace {

constexpr int slopes_64[] = {0, 4, 8, 12, 16, 20, 24, 28, 32, 36, 40, 44, 48, 50, 52, 54, 60, 80};
constexpr int slopes_32[] = {0, 2, 4, 6, 8, 10, 12, 14, 16, 18, 20, 22, 24, 26, 30, 40};
constexpr auto slopes = by_format<slopes_64, slopes_32>;

Trial place(Draw& draw, Format format, int value, std::uint64_t k) {
  const SegmentPair pair = place_grazing(draw, format, value);
  return placed_probe(k, pair, format, draw);
}

}  // namespace

StressAxis grazing_axis() {
  return {.name = "grazing",
          .quantity = "-log2 of the slope at which the probe leaves the plane",
          .population = "random triangles in [-1,1]^3 crossed at slopes of 2^-value",
          .easiest = zero,
          .values = slopes,
          .stream = stream_of("sweep grazing"),
          .place = place};
}

}  // namespace tribunal
