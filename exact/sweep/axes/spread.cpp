// Coordinates binades apart on one axis.
#include <algorithm>

#include "exact/cases/families/ladder.h"
#include "exact/cases/families/probe.h"
#include "exact/cases/families/shapes.h"
#include "exact/sweep/axes/placed.h"
#include "exact/sweep/axes/table.h"

namespace tribunal {
namespace {

constexpr int spreads_64[] = {0, 8, 20, 40, 60, 100, 200, 310, 400, 500, 600, 700, 800, 1000, 1200, 1400, 1600, 2096};
constexpr int spreads_32[] = {0, 4, 8, 12, 16, 24, 30, 45, 60, 75, 100, 125, 150, 200, 240, 274};
constexpr auto spreads = by_format<spreads_64, spreads_32>;

/// Significands whose products of three are exact, so that the spread alone makes sums round.
constexpr int most_bits(Format format) { return format == Format::binary32 ? 6 : 15; }

/// Magnitudes about 1, or as near to that as the range allows.
Ladder draw_centred_ladder(Draw& draw, Format format, int spread) {
  const int least = least_exponent(format), room = largest_exponent(format) - least - spread;
  const int bits = std::min(most_bits(format), room + 1);
  const std::int64_t m = draw.between(1, (std::int64_t{1} << bits) - 1);
  return {static_cast<double>(m), std::clamp(-spread / 2, least, least + room + 1 - bits), spread / 2};
}

Trial place(Draw& draw, Format format, int value, std::uint64_t k) {
  Point3 v[5];
  for (int axis = 0; axis < 3; ++axis) {
    const Ladder ladder = draw_centred_ladder(draw, format, value);
    for (Point3& p : v) p[axis] = ladder.draw_number(draw);
  }
  const bool is_ray = turn_of(k, 1).is_ray;
  const Probe probe = is_ray ? Probe(Ray{v[3], {v[4]}}) : Probe(Segment{v[3], v[4]});
  return unclassified(format, 0, probe, {v[0], v[1], v[2]}, draw);
}

}  // namespace

StressAxis spread_axis() {
  return {.name = "spread",
          .quantity = "largest over least magnitude on one axis (log2)",
          .population =
              "coordinates drawn from 0 and three short numbers an axis, with signs, the largest 2^value the least",
          .easiest = zero,
          .values = spreads,
          .stream = stream_of("sweep spread"),
          .place = place};
}

}  // namespace tribunal
