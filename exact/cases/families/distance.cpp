// Probes far longer or shorter than the triangle.
#include <cmath>

#include "exact/cases/families/placing.h"
#include "exact/cases/families/probe.h"
#include "exact/cases/families/shapes.h"
#include "exact/cases/families/table.h"

namespace tribunal {
namespace {

constexpr int distances_64[] = {-1000, -200, -50, -25, 0, 14, 25, 50, 200, 1000};
constexpr int distances_32[] = {-100, -40, -20, -10, 0, 10, 14, 20, 40, 100};

constexpr auto levels = by_format<distances_64, distances_32>;

/// The vector times 2^level; half of the long ones run along one axis, so that the other coordinates keep their bits.
Point3 stretched(Draw& draw, Point3 n, int level) {
  const int axis = static_cast<int>(draw.below(3));
  const bool along_axis = draw.below(2) == 0;
  if (level <= 0 || !along_axis) return std::ldexp(1.0, level) * n;
  n[axis] = std::ldexp(n[axis], level);
  return n;
}

/// A point with coordinates that are multiples of 2^−bits of at most 1.
Point3 draw_coarse_point(Draw& draw, int bits) { return std::ldexp(1.0, -bits) * draw_lattice_point(draw, bits, 1); }

/// A triangle of which the origin is a vertex, or a point of an edge, or an inner point, exactly.
Triangle draw_about_origin(Draw& draw, int bits) {
  const Point3 a = draw_coarse_point(draw, bits), b = draw_coarse_point(draw, bits);
  const std::uint64_t place = draw.below(3);
  if (place == 0) return {Point3(0), a, b};
  if (place == 1) return {a, -0.5 * a, b};
  return {a, b, -(a + b)};
}

Trial make(Format format, std::uint64_t seed, std::uint64_t k) {
  Draw draw(stream_of("family distance"), seed, k);
  const auto [is_ray, level] = turn_of(k, levels(format).size());
  const bool about_origin = draw.below(2) == 0;
  const int bits = digits_of(format) - 2;  // sums of two are exact
  const Triangle t = about_origin ? draw_about_origin(draw, bits) : draw_triangle(draw, format);
  const Point3 x = about_origin ? Point3(0) : draw_in_plane(draw, format, t);
  const Point3 n = stretched(draw, draw_point(draw, format), levels(format)[level]);
  return unclassified(format, level, draw_probe(is_ray, through(x, n, n), format, draw), t, draw);
}

}  // namespace

SegmentPair place_distant(Draw& draw, int bits, int distance) {
  const Triangle t = draw_about_origin(draw, bits);
  const bool at_origin = draw.below(2) == 0;
  const Point3 x = at_origin ? Point3(0) : draw_coarse_point(draw, bits);
  const Point3 n = stretched(draw, draw_coarse_point(draw, bits), distance);
  return {through(x, n, n), t};
}

/// Probes whose ends are 2^level triangle sizes away. Half of them aim at the origin, which is then a point of the
/// triangle: such a probe meets it there, exactly, however long or short it is.
Family distance_family() {
  return {.name = "distance",
          .stresses = "probes far longer or far shorter than the triangle",
          .population = "random triangles in [-1,1]^3, probe ends 2^level away",
          .axis = "log2 of distance over size",
          .constructs = false,
          .levels = levels,
          .make = make};
}

}  // namespace tribunal
