// The five signed volumes of the Segura–Feito test from four shared differences, and what their signs decide.
// The formula is a template: doubles, vector lanes, toy floats and the error-tracking type run the same lines.
#pragma once

#include <type_traits>

#include "core/moeller_trumbore.h"
#include "core/query.h"
#include "exact/filtered/filter_bounds.h"
#include "exact/filtered/twin.h"

namespace tribunal {

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

/// orient3d(a, b, c, source) and orient3d(a, b, c, target).
template <class N>
struct Sides {
  N source, target;
};

/// orient3d(source, a, b, target) and so on around the triangle.
template <class N>
struct Edges {
  N ab, bc, ca;
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
/// ca = −v·moment. The three edges add up to `toward`, so the third costs two subtractions.
template <class P, class N>
SharedVolumes<N> shared_volumes(const Arms<N>& r) {
  const Vec3<Twin<N>> normal_moment = cross(r.uw, r.vd);
  const Twin<N> source_ab = dot(normal_moment, swapped(r.uw));
  const Twin<N> toward_ac = dot(normal_moment, swapped(r.vd));
  const N source = first(source_ab), ab = second(source_ab), toward = first(toward_ac), ac = second(toward_ac);
  const N bc = toward - ab + ac;
  if constexpr (std::is_same_v<P, Segment>) {
    const N target = source + toward;
    return {{source, target}, {ab, bc, -ac}};
  } else {
    return {{source, toward}, {ab, bc, -ac}};
  }
}

/// The largest magnitude on each axis of all arms. A NaN may go unseen: volumes that depend on it are NaN too.
template <class N>
Vec3<N> largest(const Arms<N>& r) {
  const Vec3<Twin<N>> m = largest(r.uw, r.vd);
  return {larger(first(m.x), second(m.x)), larger(first(m.y), second(m.y)), larger(first(m.z), second(m.z))};
}

// What is certain where every volume is known up to ±bound. A NaN compares false, so it makes nothing certain. The
// operators & and | serve truth values and masks of vector lanes.

/// Both ends lie off the plane on one side, or the line passes one edge on its left and another on its right.
template <class N>
auto certain_miss(const SharedVolumes<N>& v, const N& bound) {
  const auto& [s, e] = v;
  const N below = -bound;
  const auto above_plane = (s.source > bound) & (s.target > bound);
  const auto below_plane = (s.source < below) & (s.target < below);
  const auto left = (e.ab > bound) | (e.bc > bound) | (e.ca > bound);
  const auto right = (e.ab < below) | (e.bc < below) | (e.ca < below);
  return above_plane | below_plane | (left & right);
}

/// The ends lie on either side of the plane, and the line passes all edges on one side. On which makes no difference:
/// the edges add up to `toward`, which has the sign of the target's side.
template <class N>
auto certain_hit(const SharedVolumes<N>& v, const N& bound) {
  const auto& [s, e] = v;
  const N below = -bound;
  const auto upward = (s.source < below) & (s.target > bound);
  const auto downward = (s.source > bound) & (s.target < below);
  const auto left = (e.ab > bound) & (e.bc > bound) & (e.ca > bound);
  const auto right = (e.ab < below) & (e.bc < below) & (e.ca < below);
  return (upward | downward) & (left | right);
}

}  // namespace tribunal
