// Polygonal faces to triangles, where a fan does it.
#pragma once

#include <string>

#include "tracer/mesh/mesh.h"

namespace tribunal {

/// Every face as a fan from its first corner: a triangle as it is, a polygon if the fan is exactly the polygon, which
/// is so if it is convex: after dropping one axis, no two of its fan triangles turn opposite ways and no corner
/// turns against them, and the ring winds once. Decided by exact signs. Otherwise throws bad_input(file, 0, …).
/// Corners may leave the plane a little, as they do after rounding; the fan is then the surface.
Mesh triangulate(const PolygonSoup& soup, const std::string& file);

}  // namespace tribunal
