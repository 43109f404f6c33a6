#include "exact/mesh/triangulate.h"

#include "exact/base/failure.h"
#include "exact/filtered/filtered_kernel.h"
#include "exact/mesh/ear_clipping.h"

namespace tribunal {
namespace {

using IndexRing = std::span<const std::uint32_t>;

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

/// The turns of all corners, of all vertices as seen from the first edge, and of the fan's triangles. If all go one
/// way, the ring is locally convex; all of it lies on one side of its first edge, so it winds once (a ring that winds
/// twice comes back across every edge's line); and the triangles tile it without overlap. Zeros are collinear corners
/// and do no harm.
Turns turns_of(const IndexRing& ring, const std::vector<Point3>& points, Axis dropped) {
  const FilteredKernel k;
  const auto at = [&](std::size_t i) -> const Point3& { return points[ring[i % ring.size()]]; };
  Turns turns;
  for (std::size_t i = 0; i < ring.size() && !turns.both(); ++i) {
    turns.add(k.orient2d(dropped, at(i), at(i + 1), at(i + 2)));
    turns.add(k.orient2d(dropped, at(0), at(1), at(i)));
    turns.add(k.orient2d(dropped, at(0), at(i), at(i + 1)));
  }
  return turns;
}

/// Whether the fan is the polygon: in some projection the ring has area and turns one way only, or it has no area in
/// any.
bool fan_is_polygon(const IndexRing& ring, const std::vector<Point3>& points) {
  bool has_area = false;
  for (const Axis dropped : all_axes) {
    const Turns turns = turns_of(ring, points, dropped);
    if (turns.any() && !turns.both()) return true;
    has_area |= turns.any();
  }
  return !has_area;
}

void add_fan(const IndexRing& ring, std::vector<std::array<std::uint32_t, 3>>& triangles) {
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) triangles.push_back({ring[0], ring[i], ring[i + 1]});
}

}  // namespace

Mesh mesh_of(PolygonSoup soup) {
  Mesh mesh{std::move(soup.points), {}};
  mesh.triangles.reserve(soup.corners.size() - 2 * soup.size());
  for (std::size_t f = 0; f < soup.size(); ++f) {
    const IndexRing ring = soup.face(f);
    if (ring.size() <= 3 || fan_is_polygon(ring, mesh.vertices)) {
      add_fan(ring, mesh.triangles);
    } else {
      mesh.polygons.push_back({{ring.begin(), ring.end()}});
    }
  }
  return mesh;
}

std::optional<std::vector<std::array<std::uint32_t, 3>>> triangulate(const Rings& face,
                                                                     const std::vector<Point3>& points) {
  if (face.size() > 1 || !fan_is_polygon(face[0], points)) return clip_ears(face, points);
  std::vector<std::array<std::uint32_t, 3>> triangles;
  add_fan(face[0], triangles);
  return triangles;
}

Mesh triangulated(Mesh mesh, const std::string& file) {
  for (std::size_t f = 0; f < mesh.polygons.size(); ++f) {
    const auto triangles = triangulate(mesh.polygons[f], mesh.vertices);
    if (!triangles) {
      throw bad_input(file, 0, "concave face " + std::to_string(f) + ": its edges cross, expected a simple polygon");
    }
    mesh.triangles.insert(mesh.triangles.end(), triangles->begin(), triangles->end());
  }
  mesh.polygons.clear();
  return mesh;
}

}  // namespace tribunal
