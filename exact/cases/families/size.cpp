// General position at every size of the geometry.
#include <cmath>

#include "exact/cases/families/levels.h"
#include "exact/cases/families/probe.h"
#include "exact/cases/families/shapes.h"
#include "exact/cases/families/table.h"

namespace tribunal {
namespace {

/// From a few times smaller than the triangle to 2⁶ times larger.
double draw_length(Draw& draw) { return std::ldexp(1.0, static_cast<int>(draw.between(-3, 6))); }

Triangle operator*(double f, const Triangle& t) { return {f * t.a, f * t.b, f * t.c}; }
Segment operator*(double f, const Segment& s) { return {f * s.p, f * s.q}; }

Trial make(Format format, std::uint64_t seed, std::uint64_t k) {
  Draw draw(stream_of("family size"), seed, k);
  const auto [is_ray, level] = turn_of(k, geometry_sizes(format).size());
  const double size = std::ldexp(1.0, geometry_sizes(format)[level]);
  const Triangle t = draw_triangle(draw, format);
  const Point3 x = draw_in_plane(draw, format, t);
  const Point3 n = draw_point(draw, format);
  const double before = draw_length(draw);
  const double beyond = draw_length(draw);
  const Segment s = through(x, before * n, beyond * n);
  return unclassified(format, level, draw_probe(is_ray, size * s, format, draw), size * t, draw);
}

}  // namespace

/// Triangles of size 2^level, with a probe through a rounded point near or in them: nothing is degenerate, and volumes
/// underflow or overflow, a ray's through its direction alone.
Family size_family() {
  return {.name = "size",
          .stresses = "general position at every size of geometry and direction",
          .population = "random triangles in [-2^level,2^level]^3, a probe through a point near them",
          .axis = "log2 of the size",
          .constructs = false,
          .levels = geometry_sizes,
          .make = make};
}

}  // namespace tribunal
