// The coplanar branch of the Segura–Feito test: probe and triangle in one plane, or a triangle without area.
// Everything reduces to closed segments: in the plane, a probe meets a triangle iff it meets an edge or starts inside.
#pragma once

#include <utility>

#include "core/answer.h"
#include "core/kernel.h"

namespace tribunal {

namespace detail {

/// Whether a probe whose source and target lie on these sides of a plane (or, in the plane, of a line)
/// reaches it. Both zero means that the probe lies in it. A target at infinity is never in the plane
/// itself: if its side is zero, the ray runs parallel.
template <class X>
constexpr bool reaches(Sign source_side, Sign target_side, const X& /*target*/) {
  return value(source_side) * value(target_side) <= 0;
}

constexpr bool reaches(Sign source_side, Sign target_side, const Direction& /*target*/) {
  return source_side == Sign::zero || value(source_side) * value(target_side) < 0;
}

/// Sign of x − a in lexicographic order. On a line this order runs along the line, so it compares positions on it.
template <Kernel K, class X>
Sign lexicographic(const Point3& a, const X& x, const K& k) {
  for (const Axis axis : all_axes) {
    const Sign s = k.compare(axis, a, x);
    if (s != Sign::zero) return s;
  }
  return Sign::zero;
}

/// Whether a probe that runs in the direction `heading` along its line has its target at x or beyond. The target of a
/// ray that runs toward x, a point at infinity, always lies beyond.
template <Kernel K, class X>
bool at_or_beyond(const Point3& x, const X& target, Sign heading, const K& k) {
  return lexicographic(x, target, k) * heading != Sign::negative;
}

template <Kernel K>
bool at_or_beyond(const Point3&, const Direction&, Sign, const K&) {
  return true;
}

/// All four points on one line, lo ≤ hi lexicographically: does the probe meet [lo, hi]?
template <Kernel K, class P>
bool meets_on_line(const P& probe, const Point3& lo, const Point3& hi, const K& k) {
  const auto& p = source(probe);
  const Sign heading = lexicographic(base(probe), along(probe), k);
  if (heading == Sign::zero) {
    return lexicographic(lo, p, k) != Sign::negative && lexicographic(hi, p, k) != Sign::positive;
  }
  const Point3& near_end = heading == Sign::positive ? lo : hi;
  const Point3& far_end = heading == Sign::positive ? hi : lo;
  return lexicographic(far_end, p, k) * heading != Sign::positive && at_or_beyond(near_end, target(probe), heading, k);
}

template <Kernel K, class P>
bool meets_on_line_unordered(const P& probe, const Point3& a, const Point3& b, const K& k) {
  return lexicographic(a, b, k) == Sign::negative ? meets_on_line(probe, b, a, k) : meets_on_line(probe, a, b, k);
}

/// Sides in the plane, after dropping one axis: of the probe's ends to the line ab, of a and b to the probe's line.
struct CrossingSigns {
  Sign source_of_ab, target_of_ab, a_of_probe, b_of_probe;

  bool all_zero() const {
    return source_of_ab == Sign::zero && target_of_ab == Sign::zero && a_of_probe == Sign::zero &&
           b_of_probe == Sign::zero;
  }
};

template <Kernel K, class P>
CrossingSigns crossing_signs(Axis dropped, const P& probe, const Point3& a, const Point3& b, const K& k) {
  const Point3& p = base(probe);
  const auto& q = along(probe);
  return {k.orient2d(dropped, a, b, source(probe)), k.orient2d(dropped, a, b, target(probe)),
          k.orient2d(dropped, p, a, q), k.orient2d(dropped, p, b, q)};
}

/// Closed probe against closed segment ab, not all on one line. Each must reach the other's line. If either is a
/// point, its own two signs vanish and the other pair, equal and nonzero, rejects; so no case split is needed. A part
/// of a ray that is a point has its ray's line, and meets ab where it lies on the line ab and ab reaches its own.
template <class X>
bool crosses(const CrossingSigns& s, const X& probe_target) {
  return reaches(s.source_of_ab, s.target_of_ab, probe_target) && value(s.a_of_probe) * value(s.b_of_probe) <= 0;
}

/// Probe against edge ab in a plane on which dropping `dropped` is one-to-one.
template <Kernel K, class P>
bool meets_edge(Axis dropped, const P& probe, const Point3& a, const Point3& b, const K& k) {
  const CrossingSigns s = crossing_signs(dropped, probe, a, b, k);
  return s.all_zero() ? meets_on_line_unordered(probe, a, b, k) : crosses(s, target(probe));
}

/// Probe in the plane of a triangle with area, whose projection has orientation `turn` ≠ 0.
template <Kernel K, class P>
bool meets_in_plane(Axis dropped, Sign turn, const P& probe, const Triangle& t, const K& k) {
  const auto& p = source(probe);
  const bool starts_inside = k.orient2d(dropped, t.a, t.b, p) == turn && k.orient2d(dropped, t.b, t.c, p) == turn &&
                             k.orient2d(dropped, t.c, t.a, p) == turn;
  return starts_inside || meets_edge(dropped, probe, t.a, t.b, k) || meets_edge(dropped, probe, t.b, t.c, k) ||
         meets_edge(dropped, probe, t.c, t.a, k);
}

/// Probe against the segment [lo, hi] anywhere in space; either may be a point. If the four points span a plane,
/// one of the four signs is nonzero in some projection, and that projection is one-to-one on the plane.
template <Kernel K, class P>
bool meets_segment(const P& probe, const Point3& lo, const Point3& hi, const K& k) {
  if (k.orient3d(base(probe), lo, hi, along(probe)) != Sign::zero) return false;
  for (const Axis dropped : all_axes) {
    const CrossingSigns s = crossing_signs(dropped, probe, lo, hi, k);
    if (!s.all_zero()) return crosses(s, target(probe));
  }
  return meets_on_line(probe, lo, hi, k);
}

/// The lexicographically least and greatest vertex. A triangle without area is the segment between these two.
template <Kernel K>
std::pair<Point3, Point3> extent(const Triangle& t, const K& k) {
  std::pair<Point3, Point3> e{t.a, t.a};
  for (const Point3& v : {t.b, t.c}) {
    if (lexicographic(v, e.first, k) == Sign::positive) e.first = v;
    if (lexicographic(e.second, v, k) == Sign::positive) e.second = v;
  }
  return e;
}

}  // namespace detail

/// Decides operands for which both ends of the probe have volume zero with abc: they lie in one plane,
/// or the triangle has no area. Exact kernels make it total; it costs at most 18 two-dimensional signs, beside
/// comparisons.
template <Kernel K, class P>
Answer coplanar(const P& probe, const Triangle& t, const K& k) {
  for (const Axis dropped : all_axes) {
    const Sign turn = k.orient2d(dropped, t.a, t.b, t.c);
    if (turn == Sign::zero) continue;
    return detail::meets_in_plane(dropped, turn, probe, t, k) ? hit_at(Contact::coplanar) : miss();
  }
  const auto [lo, hi] = detail::extent(t, k);
  return detail::meets_segment(probe, lo, hi, k) ? hit_at(Contact::coplanar) : miss();
}

}  // namespace tribunal
