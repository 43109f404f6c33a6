// Coordinates hundreds of binades apart on one axis.
#include "exact/cases/families/ladder.h"
#include "exact/cases/families/levels.h"
#include "exact/cases/families/probe.h"
#include "exact/cases/families/shapes.h"
#include "exact/cases/families/table.h"
#include "exact/cases/families/ulp.h"

namespace tribunal {
namespace {

Trial make(Format format, std::uint64_t seed, std::uint64_t k) {
  Draw draw(stream_of("family spread"), seed, k);
  const auto [is_ray, level] = turn_of(k, coordinate_spreads(format).size());
  Point3 v[5];
  for (int axis = 0; axis < 3; ++axis) {
    const Ladder ladder = draw_ladder(draw, format, coordinate_spreads(format)[level]);
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

/// Five points whose coordinates are, on each axis, zero or of one of three magnitudes in geometric sequence, with one
/// ratio on all axes: products of far smaller and far larger numbers are exactly equal, and small terms decide. Half of
/// the cases move one coordinate by a unit in the last place.
Family spread_family() {
  return {.name = "spread",
          .stresses = "numbers up to 2096 binades apart on one axis, whose products tie",
          .population = "coordinates drawn from 0 and three sizes an axis, with signs, the largest 2^level the least",
          .axis = "log2 of largest over least",
          .constructs = false,
          .levels = coordinate_spreads,
          .make = make};
}

}  // namespace tribunal
