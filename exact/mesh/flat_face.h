// A polygonal face seen along one axis: places in the plane, and directed edges between them.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "exact/mesh/mesh.h"

namespace tribunal {

/// The corners and edges of a face after dropping one axis, the one in which the outer ring has the most area.
///
/// Corners at the same place are one place. The places are numbered from left to right, and from below on one
/// vertical. The outer ring runs counter-clockwise, the holes clockwise: the face lies to the left of its edges.
/// The two coordinates that are left may have been exchanged.
struct FlatFace {
  std::vector<Point3> places;                       ///< (u, v, 0)
  std::vector<std::uint32_t> corners;               ///< by place, the first corner there, as the rings name it
  std::vector<std::array<std::uint32_t, 2>> edges;  ///< from place to place; none from a place to itself
};

/// If the outer ring has no area along any axis, one is dropped that does not make a line of it. Cost: n log n.
FlatFace flattened(const Rings& face, const std::vector<Point3>& points);

}  // namespace tribunal
