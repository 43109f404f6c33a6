#include "exact/cases/polygon_families/star.h"

#include <cmath>
#include <numbers>

#include "exact/cases/families/shapes.h"

namespace tribunal {
namespace {

std::vector<Point3> draw_ring(Draw& draw, Format format, const Triangle& frame, int n) {
  std::vector<Point3> ring;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * i / n;
    const double radius = 0.75 + 0.25 * draw_real(draw, format);
    const double u = radius * std::cos(angle), v = radius * std::sin(angle);
    ring.push_back(in_format(frame.a + u * (frame.b - frame.a) + v * (frame.c - frame.a), format));
  }
  return ring;
}

Point3 draw_target(Draw& draw, Format format, const Triangle& frame, const std::vector<Point3>& ring) {
  const Point3& a = ring[draw.below(ring.size())];
  const Point3& b = ring[draw.below(ring.size())];
  const double along = 0.5 + 0.75 * draw_real(draw, format);
  const std::uint64_t aim = draw.below(3);
  if (aim == 0) return a;
  return aim == 1 ? a + along * (b - a) : draw_in_plane(draw, format, frame);
}

}  // namespace

Star draw_star(Draw& draw, Format format, int n) {
  const Triangle frame = draw_triangle(draw, format);
  const std::vector<Point3> ring = draw_ring(draw, format, frame, n);
  const Point3 x = draw_target(draw, format, frame, ring);
  const Point3 v = draw_point(draw, format);
  return {PolygonData{}.add(ring), through(x, v, v)};
}

}  // namespace tribunal
