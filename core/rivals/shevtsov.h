// The test of Shevtsov, Soupikov and Kapustin: a stored projection, sign bits compared before the one division.
// Source: Shevtsov, Soupikov & Kapustin, "Ray-Triangle Intersection Algorithm for Modern CPU Architectures", GraphiCon
// 2007: det, dett, Du, Dv, detu, detv, and the test that det − detu − detv, detu and detv have one sign bit.
#pragma once

#include "core/rivals/lanes.h"

namespace tribunal::published {

template <class N>
struct Shevtsov {
  using Number = N;
  static constexpr RivalCard card{"stored projection, sign bits compared before the one division",
                                  "Shevtsov, Soupikov & Kapustin 2007"};
  static constexpr Contract contract{
      .triangles = Triangles::proper, .convention = Convention::transversal, .boundary = Boundary::unspecified};

  /// The plane scaled so that its normal is 1 on the dropped axis, the projected vertex a, and the projected edges,
  /// scaled by the same factor.
  struct Prepared {
    Vec2<N> normal;
    N height;
    Vec2<N> a, ab, ac;
    AxisOf<N> dropped;
  };

  static Prepared prepare(const Corners<N>& t) {
    const Plane<N> p = plane_of(t);
    const AxisOf<N> axis = longest_axis(p.normal);
    const N inverse = 1 / coordinate(p.normal, axis);
    const auto shrunk = [&](const Vec3<N>& v) -> Vec2<N> {
      const Vec2<N> flat = project(v, axis);
      return {flat.u * inverse, flat.v * inverse};
    };
    return {shrunk(p.normal), dot(p.normal, t.a) * inverse, project(t.a, axis), shrunk(p.ab), shrunk(p.ac), axis};
  }

  /// Four rays at once in the source.
  static Found<N> meet(const Vec3<N>& o, const Vec3<N>& d, const Prepared& t) {
    const Vec2<N> from = project(o, t.dropped), along = project(d, t.dropped);
    const N det = along.u * t.normal.u + along.v * t.normal.v + coordinate(d, t.dropped);
    const N dett = t.height - (from.u * t.normal.u + from.v * t.normal.v + coordinate(o, t.dropped));
    const N du = along.u * dett - (t.a.u - from.u) * det;
    const N dv = along.v * dett - (t.a.v - from.v) * det;
    const N detu = t.ac.v * du - t.ac.u * dv;
    const N detv = t.ab.u * dv - t.ab.v * du;
    const N rest = det - detu - detv;
    const MaskOf<N> beside = sign_bit(rest) == sign_bit(detu);
    if (none(beside)) return {};
    const MaskOf<N> inside = beside & (sign_bit(detu) == sign_bit(detv));
    if (none(inside)) return {};
    const N inverse = 1 / det;
    return {inside, dett * inverse, {detu * inverse, detv * inverse}};
  }
};

}  // namespace tribunal::published
