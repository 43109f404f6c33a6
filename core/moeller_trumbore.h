// The Möller–Trumbore test: solve o + t·d = (1−u−v)·a + u·b + v·c by Cramer's rule, divide, compare.
// Source: Möller & Trumbore, "Fast, Minimum Storage Ray/Triangle Intersection", Journal of Graphics Tools 2(1), 1997
// (the two-sided variant, with 0 in place of its tolerance on the determinant).
#pragma once

#include <optional>

#include "core/answer.h"
#include "core/operands.h"
#include "core/signed_volume.h"

namespace tribunal {

/// Parameter t of the line origin + t·d where it meets the closed triangle, or nothing. A line parallel to the plane
/// (determinant exactly 0 in N) meets nothing. N is a floating type.
template <class N>
std::optional<N> moeller_trumbore_line(const Vec3<N>& origin, const Vec3<N>& d, const Triangle& t) {
  const Vec3<N> a = lift<N>(t.a);
  const Vec3<N> e1 = arm<N>(a, t.b);
  const Vec3<N> e2 = arm<N>(a, t.c);
  const Vec3<N> pvec = cross(d, e2);
  const N det = dot(e1, pvec);
  if (det == 0) return std::nullopt;
  const N inverse = 1 / det;
  const Vec3<N> tvec = origin - a;
  const N u = dot(tvec, pvec) * inverse;
  if (!(u >= 0 && u <= 1)) return std::nullopt;
  const Vec3<N> qvec = cross(tvec, e1);
  const N v = dot(d, qvec) * inverse;
  if (!(v >= 0 && u + v <= 1)) return std::nullopt;
  return dot(e2, qvec) * inverse;
}

template <class N>
std::optional<N> moeller_trumbore(const Ray& r, const Triangle& t) {
  const std::optional<N> at = moeller_trumbore_line<N>(lift<N>(r.o), lift<N>(r.d.v), t);
  return at && *at >= 0 ? at : std::nullopt;
}

template <class N>
std::optional<N> moeller_trumbore(const Segment& s, const Triangle& t) {
  const Vec3<N> p = lift<N>(s.p);
  const std::optional<N> at = moeller_trumbore_line<N>(p, arm<N>(p, s.q), t);
  return at && *at >= 0 && *at <= 1 ? at : std::nullopt;
}

}  // namespace tribunal
