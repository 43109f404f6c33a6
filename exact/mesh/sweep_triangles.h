// Triangulation of a polygon with holes by a sweep line.
#pragma once

#include <optional>

#include "exact/mesh/flat_face.h"

namespace tribunal {

/// Triangles of places, counter-clockwise, that tile the points around which the rings wind once. Nothing if two edges
/// cross at an inner point of both, or if the rings wind around some point in another way than once or not at all.
/// Otherwise rings may touch themselves and each other, run along each other, and turn back on themselves.
///
/// No triangle has a place of the face inside it or on an edge. Each edge of the face with the region on one side
/// belongs to one triangle, with the region on both sides to two, in parts where places lie on it.
/// Cost: n log n exact signs, n log² n steps where many edges lie on one line; a function of the face alone.
std::optional<std::vector<std::array<std::uint32_t, 3>>> sweep_triangles(const FlatFace& face);

}  // namespace tribunal
