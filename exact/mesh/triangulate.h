// Makes triangles of polygonal faces.
#pragma once

#include <optional>
#include <string>

#include "exact/mesh/mesh.h"
#include "exact/mesh/soup.h"

namespace tribunal {

/// The mesh of a file's faces: a triangle as it is, a face whose fan from its first corner is exactly the polygon as
/// that fan, any other as a polygon. A fan is the polygon if the ring is convex: after dropping one axis, no two of its
/// triangles turn opposite ways, no corner turns against them, and it winds once; where it passes through its first
/// vertex again, it does not start a second time. Decided by exact signs.
/// Corners may leave the plane a little, as they do after rounding; the fan is then the surface.
Mesh mesh_of(PolygonSoup soup);

/// Triangles that tile the face, none of them turned against the outer ring: the fan if it does, else those of a sweep
/// line, which take the first of corners at one place. Nothing where two edges cross at an inner point of both, and
/// where the rings wind around a point otherwise than once or not at all (holes run against the outer ring, whatever
/// their order says). Decided by exact signs in one projection. Cost: n log n (exact/mesh/sweep_triangles.h).
std::optional<std::vector<std::array<std::uint32_t, 3>>> triangulate(const Rings& face,
                                                                     const std::vector<Point3>& points);

/// The mesh with all faces as triangles. Fails with Exit::bad_input if a face cannot be triangulated.
Mesh triangulated(Mesh mesh, const std::string& file);

}  // namespace tribunal
