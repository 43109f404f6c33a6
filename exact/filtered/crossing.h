// How often a ray crosses a closed surface, when it may run through vertices and along edges and faces.
#pragma once

#include "core/operands.h"

namespace tribunal {

/// How a ray crosses a triangle. `direction` is +1 where the ray comes from the side from which a, b, c appear
/// clockwise (the inside, of a mesh whose faces are counterclockwise from outside), −1 where it comes from the other, 0
/// where it does not cross.
struct Crossing {
  bool holds_source;  ///< the ray starts on the closed triangle
  int direction;
};

/// Exact, by consistent perturbation (simulation of simplicity): what the ray with the direction
///
///   d(ε) = d + ε·x + ε²·y + ε³·z,   x, y, z the unit vectors,
///
/// does for all small enough ε > 0. The source stays where it is. The edge ab, seen from the source o, is passed on the
/// side of det(a − o, b − o, d(ε)), a polynomial whose sign is that of its first nonzero coefficient: of the
/// determinants with d, x, y and z, in this order.
///
/// Claim. Let every edge, as a pair of points, belong to an even number of the triangles, and let o lie on none of
/// them. Then the number of crossings is even or odd for all rays from o alike. If every edge is run along as often one
/// way as the other, the sum of the directions is the same for all: the winding number of the triangles about o.
///
/// Proof. (1) If o is in the plane of a triangle, but not on it, d(ε) leaves that plane at o, and the triangle is not
/// crossed. A triangle without area is such a case. (2) Otherwise a − o, b − o, c − o are independent. The normal
/// (a − o) × (b − o) is not zero, so one of the four determinants is not, and d(ε) is on no edge's plane: it crosses
/// the inside or misses. It crosses iff it lies in the cone of the three, that is, iff the determinants of ab, bc and
/// ca all have the sign of det(a − o, b − o, c − o). (3) So d(ε) is generic for all triangles at once. Move one generic
/// direction to another on the unit sphere about o, by a path that avoids the directions of all vertices and passes the
/// arcs of edges one place at a time. Counts change only where an arc is passed. All triangles that change there have
/// an edge with this arc, and each edge e through it is passed alike by all triangles that have it, so its part of the
/// change is the number of triangles on e, which is even, or the difference of those that run along it one way and the
/// other, which is zero. (A triangle in whose plane o lies is crossed neither before nor after; two of its arcs are
/// passed there, in opposite senses, or none, so its part is as even, or zero, as it should be.) So the counts are
/// those of any direction. (4) For d ≠ 0 all that d(ε) crosses, for small ε, is met by the ray itself, since triangles
/// are closed and bounded: a walk that finds what the ray meets finds all of it.
///
/// Source of the method: Edelsbrunner, Mücke, "Simulation of simplicity", ACM TOG 9(1), 1990.
Crossing crossing(const Ray& r, const Triangle& t);

}  // namespace tribunal
