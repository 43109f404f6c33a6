// Probes almost in the plane.
#include <cmath>

#include "exact/cases/families/placing.h"
#include "exact/cases/families/probe.h"
#include "exact/cases/families/shapes.h"
#include "exact/cases/families/table.h"

namespace tribunal {
namespace {

constexpr int slopes_64[] = {1, 10, 20, 30, 40, 51};
constexpr int slopes_32[] = {1, 5, 10, 16, 22};

constexpr auto levels = by_format<slopes_64, slopes_32>;

Trial make(Format format, std::uint64_t seed, std::uint64_t k) {
  Draw draw(stream_of("family grazing"), seed, k);
  const auto [is_ray, level] = turn_of(k, levels(format).size());
  const auto [segment, t] = place_grazing(draw, format, levels(format)[level]);
  return unclassified(format, level, draw_probe(is_ray, segment, format, draw), t, draw);
}

}  // namespace

SegmentPair place_grazing(Draw& draw, Format format, int slope) {
  const Triangle t = draw_triangle(draw, format);
  const Point3 x = draw_in_plane(draw, format, t);
  const Point3 y = draw_in_plane(draw, format, t);
  const Point3 n = draw_point(draw, format);
  const Point3 v = 2.0 * (y - x) + std::ldexp(1.0, -slope) * n;
  return {through(x, v, v), t};
}

/// Probes that leave the triangle's plane by 2^−level of their length.
Family grazing_family() {
  return {.name = "grazing",
          .stresses = "probes almost in the plane",
          .population = "random triangles in [-1,1]^3 crossed at slopes of 2^-level",
          .axis = "-log2 of the slope",
          .constructs = false,
          .levels = levels,
          .make = make};
}

}  // namespace tribunal
