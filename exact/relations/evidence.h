// Evidence for an answer, found and checked in exact arithmetic: a point that lies on both operands for a hit, a plane
// that separates them for a miss. Neither looks at an orientation sign, so neither shares a formula with the tests.
#pragma once

#include <optional>

#include "core/due.h"
#include "core/query.h"

namespace tribunal {

/// A point of both operands, described as an answer would: `coplanar` where the probe is parallel to the triangle's
/// plane or the triangle has no area; `at` is then unsaid.
struct CommonPoint {
  Contact contact;
  At at;
  Facing facing = Facing::unsaid;  ///< by the slope of the probe against the normal
  bool degenerate = false;         ///< the triangle has no area, or the probe is a point
};

/// A common point of probe and target, if they have one. Tries finitely many points, of which one is common if any is:
/// where the probe crosses the plane; or, in one plane, the ends, the vertices and the crossings of lines. Returns one
/// only after checking, by dot and cross products, that it lies on the probe and on the triangle. Finite operands.
std::optional<CommonPoint> common_point(const Query& query);

/// Whether the triangle has no area, or the probe is a point. Finite operands.
bool is_degenerate(const Query& query);

/// Whether some plane has the triangle strictly on one side and the probe strictly on the other. Two disjoint
/// polyhedra with n generators have one whose normal is a facet normal of their difference, so a short list of normals
/// suffices: products of edges, and in flatter cases products of those with edges. Each is checked at every vertex.
/// Source: Gottschalk, Lin & Manocha, "OBBTree", SIGGRAPH 1996 (the separating axis theorem); Ziegler, "Lectures on
/// Polytopes", 1995. Finite operands.
bool has_separating_plane(const Query& query);

}  // namespace tribunal
