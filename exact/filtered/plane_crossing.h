// Where a probe crosses a plane, and on which sides of it the polygon's vertices and edges lie, without a division: the
// point is kept in homogeneous coordinates. A sign is certain beyond the bounds below, which docs/error-bounds.md
// derives. The formulas are templates: doubles and the error-tracking type run the same lines.
#pragma once

#include <type_traits>

#include "core/operands.h"
#include "core/products.h"
#include "exact/filtered/twin.h"

namespace tribunal::detail {

/// The bounds of this file. A unit is `rounding`. `tiny` covers underflow, `huge` is where the filter abstains.
struct CrossingBounds {
  double height;  ///< times the largest coordinate of the arm. Proved: 5.75 units
  double vertex;  ///< times the range of the crossing. Proved: 17.5 units
  double edge;    ///< times the range, times the polygon's extent. Proved: 94 units and the vertex's 4·½
  double tiny, huge;
};

inline constexpr CrossingBounds crossing_bounds{6 * rounding, 18 * rounding, 97 * rounding, 0x1p-800, 0x1p850};

/// The plane's normal is scaled by a power of two such that a product of two arms of the triangle that it comes from is
/// below 1/8 on any two axes. So heights cannot overflow.
inline constexpr double normal_scale = 0.125;

/// Source and target minus a point of the plane, as the two numbers of a twin; a ray's target is its direction.
template <class N>
Vec3<Twin<N>> ends_from(const Vec3<Twin<N>>& base, const Segment& s) {
  return beside(lift<N>(s.p), lift<N>(s.q)) - base;
}

template <class N>
Vec3<Twin<N>> ends_from(const Vec3<Twin<N>>& base, const Ray& r) {
  const Vec3<N> o{first(base.x), first(base.y), first(base.z)};
  return beside(lift<N>(r.o) - o, lift<N>(r.d.v));
}

/// The largest coordinate of each end, in magnitude.
template <class N>
Twin<N> reach_of(const Vec3<Twin<N>>& ends) {
  return larger(larger(magnitude(ends.x), magnitude(ends.y)), magnitude(ends.z));
}

/// The point, seen from the base and projected, is point / den.
template <class N>
struct PlaneCrossing {
  Vec2<N> point;
  N den;

  /// From the point to a vertex f along one axis, times den.
  N ahead_u(const N& f) const { return f * den - point.u; }
  N ahead_v(const N& f) const { return f * den - point.v; }
};

/// The crossing of a segment from w to z with the heights s and t above the plane: (s·z − t·w) / (s − t). For a ray z
/// is the direction, and t what the height gains along it: (s·z − t·w) / (−t).
template <class P, class N>
PlaneCrossing<N> plane_crossing(const Twin<N>& heights, const Vec2<Twin<N>>& ends) {
  const N s = first(heights), t = second(heights);
  const Vec2<N> point{s * second(ends.u) - t * first(ends.u), s * second(ends.v) - t * first(ends.v)};
  if constexpr (std::is_same_v<P, Segment>) {
    return {point, s - t};
  } else {
    return {point, N(-t)};
  }
}

/// The factor of the bounds `vertex` and `edge`: |w|·|z| + extent·(|w| + |z|), on a ray |w|·|z| + extent·|z|.
template <class P, class N>
N crossing_range(const Twin<N>& reach, const N& extent) {
  const N w = first(reach), z = second(reach);
  const N range = (w + extent) * z;
  if constexpr (std::is_same_v<P, Segment>) {
    return range + extent * w;
  } else {
    return range;
  }
}

/// Twice the signed area of the triangle of edge ab and the crossing, times den.
template <class N>
N edge_side(const PlaneCrossing<N>& x, const Vec2<N>& a, const Vec2<N>& b) {
  return (b.v - a.v) * x.ahead_u(a.u) - (b.u - a.u) * x.ahead_v(a.v);
}

}  // namespace tribunal::detail
