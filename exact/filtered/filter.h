// The filters of single signs: a sign that rounding cannot have changed, or nothing.
#pragma once

#include <optional>

#include "core/kernel.h"
#include "exact/filtered/filter_bounds.h"

namespace tribunal::detail {

/// The sign of x if |x| > bound; nothing otherwise, and for NaN.
template <class N>
std::optional<Sign> sign_beyond(const N& x, const N& bound) {
  if (x > bound) return Sign::positive;
  if (x < -bound) return Sign::negative;
  return std::nullopt;
}

/// The sign of det(u, v, w) of three arms, each coordinate rounded at most once.
template <class N>
std::optional<Sign> filter_volume(const Vec3<N>& u, const Vec3<N>& v, const Vec3<N>& w, const FilterConstants<N>& c) {
  const Vec3<N> m = largest(u, v, w);
  if (!in_range(m, c)) return std::nullopt;
  return sign_beyond<N>(det3(u, v, w), volume_bound(m, c));
}

template <class N, class X>
std::optional<Sign> filter_orient3d(const Point3& a, const Point3& b, const Point3& p, const X& x,
                                    const FilterConstants<N>& c) {
  const Vec3<N> o = lift<N>(a);
  return filter_volume(arm<N>(o, b), arm<N>(o, p), arm<N>(o, x), c);
}

template <class N, class X>
std::optional<Sign> filter_orient2d(Axis dropped, const Point3& a, const Point3& b, const X& x,
                                    const FilterConstants<N>& c) {
  const Vec3<N> o = lift<N>(a);
  const Vec2<N> m = project<N>(largest(arm<N>(o, b), arm<N>(o, x)), dropped);
  if (!(larger(m.u, m.v) < c.huge)) return std::nullopt;
  return sign_beyond<N>(signed_area<N>(dropped, a, b, x), c.k * m.u * m.v + c.tiny);
}

/// The order of two hits along one ray. The denominators must be certain too, since their signs take part.
template <class N>
std::optional<Sign> filter_compare_hits(const Ray& r, const Triangle& s, const Triangle& t,
                                        const FilterConstants<N>& order, const FilterConstants<N>& volume) {
  const Vec3<N> a = lift<N>(s.a), b = lift<N>(t.a);
  const Vec3<N> m = largest(arm<N>(a, s.b), arm<N>(a, s.c), arm<N>(a, r.o), arm<N>(b, t.b), arm<N>(b, t.c),
                            arm<N>(b, r.o), lift<N>(r.d.v));
  if (!in_range(m, order)) return std::nullopt;
  const HitParameter<N> f = hit_parameter<N>(r, s), g = hit_parameter<N>(r, t);
  const N product = m.x * m.y * m.z;
  const auto difference = sign_beyond<N>(f.num * g.den - g.num * f.den, order.k * product * product + order.tiny);
  const auto first = sign_beyond<N>(f.den, volume_bound(m, volume)),
             second = sign_beyond<N>(g.den, volume_bound(m, volume));
  if (!difference || !first || !second) return std::nullopt;
  return *difference * *first * *second;
}

}  // namespace tribunal::detail
