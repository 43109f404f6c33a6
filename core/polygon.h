// A polygon in space: an outer ring and holes, as they arrive.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "core/operands.h"

namespace tribunal {

/// A closed ring of edges p₀p₁, p₁p₂, …, pₙ₋₁p₀; the first vertex is not repeated at the end. One vertex is a ring too.
using Ring = std::span<const Point3>;

/// The outer ring and the holes, one after the other in one array; a view that owns nothing. Nothing is demanded of
/// the rings: they may be concave, touch, cross, repeat vertices or have no area, and run either way.
///
/// As a point set, if all vertices lie in one plane: the closed even–odd region of all rings (its points off the ring
/// edges are those from which a ray that meets no vertex crosses an odd number of edges), with all ring edges. Then
/// neither the direction nor the order of the rings nor their start matter, nor which of them is called outer.
/// Otherwise: the surface made of the triangles of its covering (`covering.h`).
struct Polygon {
  std::span<const Point3> vertices;   ///< ring after ring
  std::span<const std::size_t> ends;  ///< ends[i]: how many vertices rings 0..i have in all

  std::size_t rings() const { return ends.size(); }

  Ring ring(std::size_t i) const {
    const std::size_t begin = i == 0 ? 0 : ends[i - 1];
    return vertices.subspan(begin, ends[i] - begin);
  }
};

/// A polygon that owns its vertices.
struct PolygonData {
  std::vector<Point3> vertices{};
  std::vector<std::size_t> ends{};

  PolygonData& add(Ring ring) {
    vertices.insert(vertices.end(), ring.begin(), ring.end());
    ends.push_back(vertices.size());
    return *this;
  }

  operator Polygon() const { return {vertices, ends}; }
};

inline bool is_finite(const Polygon& polygon) {
  return std::all_of(polygon.vertices.begin(), polygon.vertices.end(), [](const Point3& v) { return is_finite(v); });
}

}  // namespace tribunal
