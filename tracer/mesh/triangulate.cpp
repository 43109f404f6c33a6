#include "tracer/mesh/triangulate.h"

#include <algorithm>

#include "exact/io/failure.h"
#include "exact/kernels/rational_kernel.h"

namespace tribunal {
namespace {

using Ring = std::vector<std::size_t>;

/// The turns that a ring makes after dropping one axis.
struct Turns {
  bool left = false, right = false;

  void add(Sign s) {
    left |= s == Sign::positive;
    right |= s == Sign::negative;
  }
  bool any() const { return left || right; }
  bool both() const { return left && right; }
};

/// All corners turn one way, so the ring is locally convex; all of it lies on one side of its first edge, so it winds
/// once (a ring that winds twice comes back across every edge's line); the fan's triangles turn that way too, so
/// they tile the ring without overlap. Zeros are collinear corners and do no harm.
Turns turns_of(const Ring& ring, const std::vector<Point3>& points, Axis dropped) {
  const RationalKernel k;
  const auto at = [&](std::size_t i) -> const Point3& { return points[ring[i % ring.size()]]; };
  Turns turns;
  for (std::size_t i = 0; i < ring.size() && !turns.both(); ++i) {
    turns.add(k.orient2d(dropped, at(i), at(i + 1), at(i + 2)));
    turns.add(k.orient2d(dropped, at(0), at(1), at(i)));
    turns.add(k.orient2d(dropped, at(0), at(i), at(i + 1)));
  }
  return turns;
}

/// In some projection the ring has area and turns one way only; or it has no area in any.
bool fan_is_polygon(const Ring& ring, const std::vector<Point3>& points) {
  bool has_area = false;
  for (const Axis dropped : all_axes) {
    const Turns turns = turns_of(ring, points, dropped);
    if (turns.any() && !turns.both()) return true;
    has_area |= turns.any();
  }
  return !has_area;
}

}  // namespace

Mesh triangulate(const PolygonSoup& soup, const std::string& file) {
  Mesh mesh{soup.points, {}};
  for (std::size_t f = 0; f < soup.polygons.size(); ++f) {
    const Ring& ring = soup.polygons[f];
    if (ring.size() > 3 && !fan_is_polygon(ring, soup.points)) {
      throw bad_input(file, 0,
                      "face " + std::to_string(f) + " with " + std::to_string(ring.size()) +
                          " corners is not convex; nonconvex faces come with the polygon test, " +
                          "triangulate the mesh first");
    }
    for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
      mesh.triangles.push_back({static_cast<std::uint32_t>(ring[0]), static_cast<std::uint32_t>(ring[i]),
                                static_cast<std::uint32_t>(ring[i + 1])});
    }
  }
  return mesh;
}

}  // namespace tribunal
