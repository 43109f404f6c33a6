// The five signed volumes of the Segura–Feito test from four shared differences, and what their signs decide.
// The formula is a template: doubles, vector lanes, toy floats and the error-tracking type run the same lines.
#pragma once

#include <type_traits>
#include <utility>

#include "core/operands.h"
#include "core/products.h"
#include "exact/filtered/filter_bounds.h"
#include "exact/filtered/twin.h"

namespace tribunal::detail {

/// The differences that all five volumes are made of, two by two: (u | w) and (v | d), where u = b − a, v = c − a,
/// w = source − a, and d leads from source to target. Each coordinate is rounded once; a ray's direction not at all.
template <class N>
struct Arms {
  Vec3<Twin<N>> uw, vd;
};

/// Operands in number type N, as they are lifted or loaded.
template <class N>
struct LiftedTriangle {
  Vec3<N> a, b, c;
};

template <class N>
Arms<N> segment_arms(const Vec3<N>& p, const Vec3<N>& q, const LiftedTriangle<N>& t) {
  return {beside(t.b, p) - beside(t.a, t.a), beside(t.c, q) - beside(t.a, p)};
}

template <class N>
Arms<N> ray_arms(const Vec3<N>& o, const Vec3<N>& d, const LiftedTriangle<N>& t) {
  return {beside(t.b, o) - beside(t.a, t.a), beside(t.c - t.a, d)};
}

template <class N>
Arms<N> arms_of(const Segment& s, const Triangle& t) {
  return segment_arms<N>(lift<N>(s.p), lift<N>(s.q), {lift<N>(t.a), lift<N>(t.b), lift<N>(t.c)});
}

template <class N>
Arms<N> arms_of(const Ray& r, const Triangle& t) {
  return ray_arms<N>(lift<N>(r.o), lift<N>(r.d.v), {lift<N>(t.a), lift<N>(t.b), lift<N>(t.c)});
}

/// orient3d(a, b, c, source) and orient3d(a, b, c, target), and by how much d changes the first: normal·d.
template <class N>
struct Sides {
  N source, target, toward;
};

/// orient3d(source, a, b, target), orient3d(source, b, c, target), orient3d(source, a, c, target). Around the triangle
/// the third would be ca = −ac: ab + bc − ac = toward.
template <class N>
struct Edges {
  N ab, bc, ac;
};

template <class N>
struct SharedVolumes {
  Sides<N> sides;
  Edges<N> edges;
};

/// The five volumes of a segment or ray (P) by two cross products and four dot products, two at a time.
///
/// (u | w) × (v | d) is the plane's normal and the line's moment. The normal tells the sides: source = normal·w, and
/// `toward` = normal·d is what a point gains along d; for a target at infinity it is the side. The moment tells the
/// edges: det(a−p, b−p, d) = det(u, w, d), since adding one column to another changes nothing; so ab = u·moment and
/// ac = v·moment. ab + bc − ac = toward, so the third costs two additions.
template <class P, class N>
SharedVolumes<N> shared_volumes(const Arms<N>& r) {
  const Vec3<Twin<N>> normal_moment = cross(r.uw, r.vd);
  const Twin<N> source_ab = dot(normal_moment, swapped(r.uw));
  const Twin<N> toward_ac = dot(normal_moment, swapped(r.vd));
  const N source = first(source_ab), ab = second(source_ab), toward = first(toward_ac), ac = second(toward_ac);
  const N bc = toward - ab + ac;
  if constexpr (std::is_same_v<P, Segment>) {
    const N target = source + toward;
    return {{source, target, toward}, {ab, bc, ac}};
  } else {
    return {{source, toward, toward}, {ab, bc, ac}};
  }
}

/// The largest magnitude on each axis of all arms. A NaN may go unseen: volumes that depend on it are NaN too.
template <class N>
Vec3<N> largest(const Arms<N>& r) {
  const auto over_lanes = [](const Twin<N>& m) { return larger(first(m), second(m)); };
  return {over_lanes(larger_magnitude(r.uw.x, r.vd.x)), over_lanes(larger_magnitude(r.uw.y, r.vd.y)),
          over_lanes(larger_magnitude(r.uw.z, r.vd.z))};
}

/// The type of a comparison of two numbers: bool, or a mask of lanes.
template <class N>
using Truth = decltype(std::declval<const N&>() < std::declval<const N&>());

/// By how much the volumes decide: positive where they say hit, negative where they say miss.
///
/// With all signs flipped if `toward` < 0, a probe that crosses the triangle runs from below the plane to
/// above it and passes the edges ab, bc, ca on its left: so −source, target, ab, bc and −ac are all positive, and the
/// margin is the least of them.
/// bc comes last: a NaN in any coordinate makes it NaN, and `smaller` then returns its second operand.
template <class N>
N margin_of(const SharedVolumes<N>& v) {
  const auto& [s, e] = v;
  const N forward = unit_with_sign_of(s.toward), backward = -forward;
  const N sides = smaller(N(s.source * backward), N(s.target * forward));
  const N edges = smaller(N(e.ab * forward), N(e.ac * backward));
  return smaller(smaller(sides, edges), N(e.bc * forward));
}

/// Whether the bound of the volumes and the conclusions below hold: no intermediate result overflows and, of a ray,
/// the direction is long enough for t times what underflows in normal·d to stay below `tiny`.
template <class P, class N>
Truth<N> in_range(const Arms<N>& r, const Vec3<N>& largest_arm, const PairConstants<N>& c) {
  if constexpr (std::is_same_v<P, Segment>) {
    return in_range(largest_arm, c);
  } else {
    const N y_or_z = larger_magnitude(second(r.vd.y), second(r.vd.z));
    const N length = larger(magnitude(second(r.vd.x)), y_or_z);
    return Truth<N>(in_range(largest_arm, c) & (length >= c.direction));
  }
}

/// What is certain of a pair.
template <class N>
struct Conclusion {
  SharedVolumes<N> volumes;
  N bound;                   ///< of the error of each volume, where `safe`
  Truth<N> safe, hit, miss;  ///< within range; certainly a hit; certainly a miss
};

/// The one place where volumes become an answer, for scalars and lanes, single pairs, batches and trees.
///
/// A hit where margin > bound. Every volume is known up to ±bound, so all of them have the signs that they show; and
/// the sign of the edges is that of their exact sum, whatever `toward` shows.
///
/// A miss where margin < −3·bound. Flip all signs if `toward` < 0 as computed.
///   An edge is below −3·bound: another is above bound, since together they are `toward`; so the line certainly passes
///   one on its left and one on its right.
///   Of a segment, source is above 3·bound, or target below −3·bound: their difference is `toward` ≥ 0, so both lie
///   off the plane on one side. Of a ray, source is above 3·bound. `toward` may show the wrong sign, as it is known up
///   to ±bound only. But if the ray met the triangle, at t, then t·d would lead from source into the triangle, and be
///   no longer than two arms on any axis; so t·toward is known up to ±bound too, and too small to take the source down
///   to the plane.
/// decision.g and ray_decision.g prove these, range.g and ray_range.g that underflow does not spoil them;
/// docs/error-bounds.md has the argument.
template <class P, class N>
Conclusion<N> conclude(const Arms<N>& arms, const PairConstants<N>& c) {
  const Vec3<N> m = largest(arms);
  const N bound = volume_bound(m, c);
  const SharedVolumes<N> volumes = shared_volumes<P>(arms);
  const N margin = margin_of(volumes);
  const Truth<N> safe = in_range<P>(arms, m, c);
  return {volumes, bound, safe, Truth<N>((margin > bound) & safe), Truth<N>((margin < bound * N(-3.0)) & safe)};
}

}  // namespace tribunal::detail
