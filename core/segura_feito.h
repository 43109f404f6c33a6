// The Segura–Feito test of a segment or ray against a triangle, by signs alone.
// Source: Segura & Feito, "An algorithm for determining intersection segment-polygon in 3D", Computers &
// Graphics 22(5), 1998; "Algorithms to test ray-triangle intersection", WSCG 2001. The published test leaves
// coplanar and degenerate operands out; here they are decided too, so that `hit` says that the point sets meet.
#pragma once

#include "core/answer.h"
#include "core/coplanar.h"
#include "core/kernel.h"

namespace tribunal {

/// Decides whether the probe meets the triangle, from at most five signs in the general case.
///
/// The plane of abc must separate source and target, weakly. Then the line of the probe passes the three edges
/// on one side iff it runs through the triangle; reversing probe or triangle flips all signs, so one loop serves
/// all. Cost: 2 signs for a probe that misses the plane, 3 to 5 otherwise; coplanar operands go to `coplanar`.
///
/// Law: for an exact kernel, hit ⇔ the closed point sets meet; contact is `coplanar` iff they lie in one plane.
template <Kernel K, class P>
Answer segura_feito(const P& probe, const Triangle& t, const K& k) {
  const Point3& p = source(probe);
  const auto& q = target(probe);
  const Sign source_side = k.orient3d(t.a, t.b, t.c, p);
  const Sign target_side = k.orient3d(t.a, t.b, t.c, q);
  if (source_side == Sign::zero && target_side == Sign::zero) return coplanar(probe, t, k);
  if (!detail::reaches(source_side, target_side, q)) return miss();

  const Sign side = source_side != Sign::zero ? source_side : -target_side;
  const Point3* const corner[] = {&t.a, &t.b, &t.c, &t.a};
  int touched = 0;
  for (int i = 0; i < 3; ++i) {
    const Sign edge = k.orient3d(p, *corner[i], *corner[i + 1], q);
    if (side * edge == Sign::positive) return miss();
    touched += edge == Sign::zero;
  }
  constexpr Contact contacts[] = {Contact::interior, Contact::edge, Contact::vertex, Contact::vertex};
  const At at = source_side == Sign::zero ? At::source : target_side == Sign::zero ? At::target : At::between;
  return hit_at(contacts[touched], at);
}

}  // namespace tribunal
