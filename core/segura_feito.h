// The Segura–Feito test of a segment or ray against a triangle, by signs alone.
// Source: Segura & Feito, "An algorithm for determining intersection segment-polygon in 3D", Computers &
// Graphics 22(5), 1998; "Algorithms to test ray-triangle intersection", WSCG 2001. The published test leaves
// coplanar and degenerate operands out; here they are decided too, so that `hit` says that the point sets meet.
#pragma once

#include "core/answer.h"
#include "core/coplanar.h"
#include "core/kernel.h"

namespace tribunal {

namespace detail {

/// Whether the probe's line lies in the plane in which its ends lie. Of a part of a ray these may be one point, at
/// which the line crosses the plane.
template <Kernel K, class P>
bool line_lies_with_ends(const P&, const Triangle&, const K&) {
  return true;
}

template <Kernel K>
bool line_lies_with_ends(const Stretch& probe, const Triangle& t, const K& k) {
  return k.orient3d(t.a, t.b, t.c, along(probe)) == Sign::zero;
}

/// The side of the plane from which the probe's line comes, given the sides of its ends.
template <Kernel K, class P>
Sign side_before(Sign source_side, Sign target_side, const P& probe, const Triangle& t, const K& k) {
  if (source_side != Sign::zero) return source_side;
  return target_side != Sign::zero ? -target_side : -k.orient3d(t.a, t.b, t.c, along(probe));
}

}  // namespace detail

/// Decides whether the probe meets the triangle, from at most five signs in the general case.
///
/// The plane of abc must separate source and target, weakly. Then the line of the probe passes the three edges
/// on one side iff it runs through the triangle; reversing probe or triangle flips all signs, so one loop serves
/// all. Cost: 2 signs for a probe that misses the plane, 3 to 5 otherwise; coplanar operands go to `coplanar`.
///
/// Law: for an exact kernel, hit ⇔ the closed point sets meet; contact is `coplanar` iff they lie in one plane. Of a
/// part of a ray, which may be a point where the ray crosses the triangle, `coplanar` means that the ray lies in the
/// plane.
template <Kernel K, class P>
Answer segura_feito(const P& probe, const Triangle& t, const K& k) {
  const Point3& p = base(probe);
  const auto& q = along(probe);
  const Sign source_side = k.orient3d(t.a, t.b, t.c, source(probe));
  const Sign target_side = k.orient3d(t.a, t.b, t.c, target(probe));
  const bool ends_in_plane = source_side == Sign::zero && target_side == Sign::zero;
  if (ends_in_plane && detail::line_lies_with_ends(probe, t, k)) return coplanar(probe, t, k);
  if (!detail::reaches(source_side, target_side, target(probe))) return miss();

  const Sign side = detail::side_before(source_side, target_side, probe, t, k);
  const Point3* const corner[] = {&t.a, &t.b, &t.c, &t.a};
  int touched = 0;
  for (int i = 0; i < 3; ++i) {
    const Sign edge = k.orient3d(p, *corner[i], *corner[i + 1], q);
    if (side * edge == Sign::positive) return miss();
    touched += edge == Sign::zero;
  }
  constexpr Contact contacts[] = {Contact::interior, Contact::edge, Contact::vertex, Contact::vertex};
  const At at = source_side == Sign::zero ? At::source : target_side == Sign::zero ? At::target : At::between;
  Answer answer = hit_at(contacts[touched], at);
  answer.facing = side == Sign::positive ? Facing::front : Facing::back;
  return answer;
}

/// The same for the part of the ray within the bounds.
template <BoundsKernel K>
Answer segura_feito(const Ray& ray, const Bounds& bounds, const Triangle& t, const K& k) {
  return decide_within(ray, bounds, [&](const auto& part) { return segura_feito(part, t, k); });
}

}  // namespace tribunal
