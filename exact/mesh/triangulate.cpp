#include "exact/mesh/triangulate.h"

#include <algorithm>

#include "exact/base/failure.h"
#include "exact/filtered/filtered_kernel.h"
#include "exact/mesh/sweep_triangles.h"

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

/// A ring as seen from its first vertex, the apex of its fan, after dropping one axis.
class FromApex {
 public:
  FromApex(const IndexRing& ring, const std::vector<Point3>& points, Axis dropped)
      : ring_(ring), points_(points), dropped_(dropped) {}

  /// The turns of all corners; and, of the vertices that are not at the apex, the turns from the first of them to each,
  /// and from each to the next. Both ways, if the ring starts again.
  ///
  /// If all go one way, no vertex is seen outside of the half turn that begins at the first, and none turns back. So
  /// the fan's triangles tile what the ring winds around once, unless it comes back from the end of the half turn to
  /// its beginning, through the apex, which is no turn: then it starts again. Zeros are collinear corners and do no
  /// harm.
  Turns turns() const {
    Turns turns;
    for (std::size_t i = 0; i < ring_.size() && !turns.both(); ++i) turns.add(turn(i, i + 1, i + 2));
    std::size_t first = 0, last = 0;
    for (std::size_t i = 1; i < ring_.size() && !turns.both(); ++i) {
      if (is_at_apex(i)) continue;
      if (first == 0) first = last = i;
      turns.add(turn(0, first, i));
      turns.add(turn(0, last, i));
      if (is_beyond_apex(first, last) && !is_beyond_apex(first, i)) turns.left = turns.right = true;
      last = i;
    }
    return turns;
  }

 private:
  const Point3& at(std::size_t i) const { return points_[ring_[i % ring_.size()]]; }

  Sign turn(std::size_t i, std::size_t j, std::size_t k) const {
    return kernel_.orient2d(dropped_, at(i), at(j), at(k));
  }

  bool is_at_apex(std::size_t i) const {
    return std::ranges::all_of(
        all_axes, [&](Axis axis) { return axis == dropped_ || kernel_.compare(axis, at(0), at(i)) == Sign::zero; });
  }

  /// On one line with the apex and vertex j, on the other side of the apex.
  bool is_beyond_apex(std::size_t j, std::size_t i) const {
    const auto opposed = [&](Axis axis) {
      return axis != dropped_ &&
             kernel_.compare(axis, at(0), at(j)) * kernel_.compare(axis, at(0), at(i)) == Sign::negative;
    };
    return std::ranges::any_of(all_axes, opposed) && turn(0, j, i) == Sign::zero;
  }

  const IndexRing& ring_;
  const std::vector<Point3>& points_;
  Axis dropped_;
  FilteredKernel kernel_;
};

/// Whether the fan is the polygon: in some projection the ring has area and turns one way only, or it has no area in
/// any.
bool fan_is_polygon(const IndexRing& ring, const std::vector<Point3>& points) {
  bool has_area = false;
  for (const Axis dropped : all_axes) {
    const Turns turns = FromApex(ring, points, dropped).turns();
    if (turns.any() && !turns.both()) return true;
    has_area |= turns.any();
  }
  return !has_area;
}

void add_fan(const IndexRing& ring, std::vector<std::array<std::uint32_t, 3>>& triangles) {
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) triangles.push_back({ring[0], ring[i], ring[i + 1]});
}

std::optional<std::vector<std::array<std::uint32_t, 3>>> swept(const Rings& face, const std::vector<Point3>& points) {
  const FlatFace flat = flattened(face, points);
  auto triangles = sweep_triangles(flat);
  if (!triangles) return std::nullopt;
  for (auto& t : *triangles) t = {flat.corners[t[0]], flat.corners[t[1]], flat.corners[t[2]]};
  return triangles;
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
  if (face.size() > 1 || !fan_is_polygon(face[0], points)) return swept(face, points);
  std::vector<std::array<std::uint32_t, 3>> triangles;
  add_fan(face[0], triangles);
  return triangles;
}

Mesh triangulated(Mesh mesh, const std::string& file) {
  for (std::size_t f = 0; f < mesh.polygons.size(); ++f) {
    const auto triangles = triangulate(mesh.polygons[f], mesh.vertices);
    if (!triangles) {
      throw bad_input(
          file, 0,
          "concave face " + std::to_string(f) +
              ": its edges cross, or it winds around a point twice or backwards; expected a simple polygon");
    }
    mesh.triangles.insert(mesh.triangles.end(), triangles->begin(), triangles->end());
  }
  mesh.polygons.clear();
  return mesh;
}

}  // namespace tribunal
