// Triangulation of a polygon with holes by ear clipping: slow, and the reference of the sweep. Source: Meisters,
// "Polygons have ears", American Mathematical Monthly 82(6), 1975; Eberly, "Triangulation by ear clipping", 2002
// (bridges).
#pragma once

#include <optional>

#include "exact/mesh/mesh.h"

namespace tribunal {

/// Triangles of a face whose rings, seen along the axis in which the outer ring is widest, are simple and do not meet.
/// Nothing if no ear or no bridge is found. Cost: the cube of the number of vertices at worst.
std::optional<std::vector<std::array<std::uint32_t, 3>>> clip_ears(const Rings& face,
                                                                   const std::vector<Point3>& points);

}  // namespace tribunal
