// The five signed volumes of the Segura–Feito test from four shared differences, and what their signs decide.
// The formula is a template: doubles, vector lanes, toy floats and the error-tracking type run the same lines.
#pragma once

#include <type_traits>

#include "core/moeller_trumbore.h"
#include "core/query.h"
#include "core/signed_volume.h"

namespace tribunal {

/// b − a, c − a, source − a, and the way from source to target (for a ray its direction, which no rounding touches).
template <class N>
struct Arms {
  Vec3<N> u, v, w, d;
};

template <class N>
Arms<N> arms_of(const Segment& s, const Triangle& t) {
  const Vec3<N> a = lift<N>(t.a), p = lift<N>(s.p);
  return {arm<N>(a, t.b), arm<N>(a, t.c), p - a, arm<N>(p, s.q)};
}

template <class N>
Arms<N> arms_of(const Ray& r, const Triangle& t) {
  const Vec3<N> a = lift<N>(t.a);
  return {arm<N>(a, t.b), arm<N>(a, t.c), lift<N>(r.o) - a, lift<N>(r.d.v)};
}

/// orient3d(a, b, c, source) and orient3d(a, b, c, target). `toward` = det(u, v, d) is what a point gains on the plane
/// along d: for a target at infinity, its side.
template <class N>
struct Sides {
  N source, target, toward;
};

/// Both sides share the normal u × v.
template <class P, class N>
Sides<N> sides_of(const Arms<N>& r) {
  const Vec3<N> normal = cross(r.u, r.v);
  const N source = dot(normal, r.w);
  const N toward = dot(normal, r.d);
  if constexpr (std::is_same_v<P, Segment>) {
    const N target = source + toward;
    return {source, target, toward};
  } else {
    return {source, toward, toward};
  }
}

/// orient3d(source, a, b, target) and so on around the triangle.
template <class N>
struct Edges {
  N ab, bc, ca;
};

/// det(a−p, b−p, d) = det(p−a, d, b−a), since adding one column to another changes nothing: so ab = u·(w × d) and
/// ca = −v·(w × d). The three edges add up to det(u, v, d): the third costs two subtractions.
template <class N>
Edges<N> edges_of(const Arms<N>& r, const N& toward) {
  const Vec3<N> moment = cross(r.w, r.d);
  const N ab = dot(r.u, moment);
  const N ac = dot(r.v, moment);
  const N bc = toward - ab + ac;
  return {ab, bc, -ac};
}

// What is certain where every volume is known up to ±bound. A NaN compares false, so it makes nothing certain. The
// operators & and | serve truth values and masks of lanes.

/// Both ends lie off the plane on one side: a miss.
template <class N>
auto on_one_side(const Sides<N>& s, const N& bound) {
  const N below = -bound;
  return ((s.source > bound) & (s.target > bound)) | ((s.source < below) & (s.target < below));
}

/// The ends lie on either side of the plane.
template <class N>
auto on_both_sides(const Sides<N>& s, const N& bound) {
  const N below = -bound;
  return ((s.source > bound) & (s.target < below)) | ((s.source < below) & (s.target > bound));
}

/// The line passes one edge on its left and another on its right: a miss.
template <class N>
auto passes_outside(const Edges<N>& e, const N& bound) {
  const N below = -bound;
  const auto left = (e.ab > bound) | (e.bc > bound) | (e.ca > bound);
  const auto right = (e.ab < below) | (e.bc < below) | (e.ca < below);
  return left & right;
}

/// The line runs through the interior. With `on_both_sides`: a hit, since the edges add up to `toward`, which has the
/// sign of the target's side.
template <class N>
auto passes_inside(const Edges<N>& e, const N& bound) {
  const N below = -bound;
  return ((e.ab > bound) & (e.bc > bound) & (e.ca > bound)) | ((e.ab < below) & (e.bc < below) & (e.ca < below));
}

}  // namespace tribunal
