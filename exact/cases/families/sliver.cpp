// Needle-thin triangles.
#include <cmath>

#include "exact/cases/families/placing.h"
#include "exact/cases/families/probe.h"
#include "exact/cases/families/shapes.h"
#include "exact/cases/families/table.h"

namespace tribunal {
namespace {

constexpr int aspects_64[] = {0, 10, 20, 30, 40, 50};
constexpr int aspects_32[] = {0, 5, 10, 15, 20};

constexpr auto levels = by_format<aspects_64, aspects_32>;

Trial make(Format format, std::uint64_t seed, std::uint64_t k) {
  Draw draw(stream_of("family sliver"), seed, k);
  const auto [is_ray, level] = turn_of(k, levels(format).size());
  const auto [segment, t] = place_sliver(draw, format, levels(format)[level]);
  return unclassified(format, level, draw_probe(is_ray, segment, format, draw), t, draw);
}

}  // namespace

SegmentPair place_sliver(Draw& draw, Format format, int aspect) {
  Triangle t = draw_triangle(draw, format);
  const double along = 0.5 + 0.5 * draw_real(draw, format);
  t.c = in_format(t.a + along * (t.b - t.a) + std::ldexp(1.0, -aspect) * t.c, format);
  const Point3 x = draw_in_plane(draw, format, t);
  const Point3 n = draw_point(draw, format);
  return {through(x, n, n), t};
}

/// Triangles whose height is 2^−level of their length, with a probe through a rounded point of them.
Family sliver_family() {
  return {.name = "sliver",
          .stresses = "needle-thin triangles",
          .population = "random triangles in [-1,1]^3 flattened to a height of 2^-level",
          .axis = "log2 of length over height",
          .constructs = false,
          .levels = levels,
          .make = make};
}

}  // namespace tribunal
