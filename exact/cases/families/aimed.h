// Probes aimed at the triangles of a mesh of the user's own.
#pragma once

#include <vector>

#include "exact/cases/families/family.h"

namespace tribunal {

/// The name of the family below.
inline constexpr const char* mesh_family = "your mesh";

/// A family over these triangles, of which there must be at least one; it keeps them. Each case asks about one of them:
/// by level, a probe from or to a vertex; one through a vertex, one through an edge's midpoint, one through a point of
/// the face, each as it rounds; one along an edge; one between two vertices of the mesh. In binary32 the mesh is
/// rounded first.
Family aimed_at(std::vector<Triangle> triangles);

}  // namespace tribunal
