// Probes far longer or shorter than the triangle.
#include <cmath>

#include "exact/families/probe.h"
#include "exact/families/shapes.h"
#include "exact/families/table.h"

namespace tribunal {
namespace {

constexpr int distances_64[] = {-1000, -200, -50, -25, 0, 14, 25, 50, 200, 1000};
constexpr int distances_32[] = {-100, -40, -20, -10, 0, 10, 14, 20, 40, 100};

constexpr auto levels = by_format<distances_64, distances_32>;

/// 2^level long; half of the long ones along one axis alone, so that the other coordinates keep their bits.
Point3 draw_reach(Draw& draw, Format format, int level) {
  Point3 n = draw_point(draw, format);
  const int axis = static_cast<int>(draw.below(3));
  const bool along_axis = draw.below(2) == 0;
  if (level <= 0 || !along_axis) return std::ldexp(1.0, level) * n;
  n[axis] = std::ldexp(n[axis], level);
  return n;
}

Trial make(Format format, std::uint64_t seed, std::uint64_t k) {
  Draw draw(9, seed, k);
  const auto [is_ray, level] = turn_of(k, levels(format).size());
  Triangle t = draw_triangle(draw, format);
  Point3 x = draw_in_plane(draw, format, t);
  if (draw.below(2) == 0) {
    t = {t.a - x, t.b - x, t.c - x};
    x = Point3(0);
  }
  const Point3 n = draw_reach(draw, format, levels(format)[level]);
  return unclassified(format, level, draw_probe(is_ray, through(x, n, n), format, draw), t, draw);
}

}  // namespace

/// Probes whose ends are 2^level triangle sizes away. Half of the triangles are moved so that the point aimed at is
/// the origin: then the probe runs through it exactly, however long or short it is.
Family distance_family() {
  return {.name = "distance",
          .stresses = "probes far longer or far shorter than the triangle",
          .population = "random triangles in [-1,1]^3, probe ends 2^level away",
          .axis = "log2 of distance over size",
          .proves_class = false,
          .levels = levels,
          .make = make};
}

}  // namespace tribunal
