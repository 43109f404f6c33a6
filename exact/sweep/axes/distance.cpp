// Probes far longer or shorter than the triangle.
#include "exact/cases/families/placing.h"
#include "exact/cases/families/shapes.h"
#include "exact/sweep/axes/placed.h"
#include "exact/sweep/axes/table.h"

namespace tribunal {
namespace {

constexpr int distances_64[] = {-1070, -1022, -900, -700, -500, -350, -200, -100, -60, -50, -40,
                                -30,   -20,   -15,  -10,  -5,   0,    5,    10,   15,  20,  30,
                                40,    50,    60,   100,  200,  350,  500,  700,  900, 1020};
constexpr int distances_32[] = {-148, -126, -100, -75, -50, -40, -30, -25, -20, -15, -10, -5, 0,
                                5,    10,   15,   20,  25,  30,  40,  50,  62,  75,  100, 125};
constexpr auto distances = by_format<distances_64, distances_32>;

/// Short enough that volumes are exact where nothing is far, and long enough for many cases.
constexpr int bits_of(Format format) { return format == Format::binary32 ? 5 : 14; }

Trial place(Draw& draw, Format format, int value, std::uint64_t k) {
  const SegmentPair pair = place_distant(draw, bits_of(format), value);
  return placed_probe(k, pair, format, draw);
}

}  // namespace

StressAxis distance_axis() {
  return {.name = "distance",
          .quantity = "distance of the probe's ends over the triangle's size (log2)",
          .population =
              "triangles with short coordinates, probe ends 2^value away, half of the probes exactly through a point "
              "of the triangle",
          .easiest = zero,
          .values = distances,
          .stream = stream_of("sweep distance"),
          .place = place};
}

}  // namespace tribunal
