// Coordinates hundreds of binades apart on one axis.
#include <algorithm>
#include <cmath>

#include "exact/families/probe.h"
#include "exact/families/shapes.h"
#include "exact/families/table.h"
#include "exact/families/ulp.h"

namespace tribunal {
namespace {

constexpr int spreads_64[] = {8, 40, 100, 200, 310, 500, 800, 1200, 1600, 2096};
constexpr int spreads_32[] = {8, 30, 60, 100, 150, 200, 240, 274};

constexpr auto levels = by_format<spreads_64, spreads_32>;

/// The numbers of one axis: 0 and ±m·2^low times 1, 2^(spread/2) and 2^spread.
struct Ladder {
  double m;
  int low, half;

  double draw_number(Draw& draw) const {
    const auto rung = static_cast<int>(draw.between(-3, 3));
    if (rung == 0) return draw.below(2) == 0 ? 0.0 : -0.0;
    return std::ldexp(rung > 0 ? m : -m, low + half * (std::abs(rung) - 1));
  }
};

/// m has as many bits as the format's range leaves beside the spread.
Ladder draw_ladder(Draw& draw, Format format, int spread) {
  const int room = largest_exponent(format) - least_exponent(format) - spread;
  const int bits = std::min(digits_of(format), room + 1);
  const std::int64_t m = draw.between(1, (std::int64_t{1} << bits) - 1);
  const auto low = static_cast<int>(draw.between(least_exponent(format), least_exponent(format) + room + 1 - bits));
  return {static_cast<double>(m), low, spread / 2};
}

Trial make(Format format, std::uint64_t seed, std::uint64_t k) {
  Draw draw(16, seed, k);
  const auto [is_ray, level] = turn_of(k, levels(format).size());
  Point3 v[5];
  for (int axis = 0; axis < 3; ++axis) {
    const Ladder ladder = draw_ladder(draw, format, levels(format)[level]);
    for (Point3& p : v) p[axis] = ladder.draw_number(draw);
  }
  if (draw.below(2) == 0) {
    double& x = v[draw.below(5)][static_cast<int>(draw.below(3))];
    x = moved_by_ulps(x, draw.below(2) == 0 ? 1 : -1, format);
  }
  const Probe probe = is_ray ? Probe(Ray{v[3], {v[4]}}) : Probe(Segment{v[3], v[4]});
  return unclassified(format, level, probe, {v[0], v[1], v[2]}, draw);
}

}  // namespace

/// Five points whose coordinates are, on each axis, zero or one of three sizes, equal steps apart on all axes: products
/// of far smaller and far larger numbers tie exactly, and what is left decides. Half of the cases move one coordinate
/// by a unit in the last place.
Family spread_family() {
  return {.name = "spread",
          .stresses = "numbers up to 2096 binades apart on one axis, whose products tie",
          .population = "coordinates drawn from 0 and three sizes an axis, with signs, the largest 2^level the least",
          .axis = "log2 of largest over least",
          .constructs = false,
          .levels = levels,
          .make = make};
}

}  // namespace tribunal
