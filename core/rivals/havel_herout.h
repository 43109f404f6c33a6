// The test of Havel and Herout: three stored planes, the triangle's and two across it, and sign bits compared before
// the one division.
// Source: Havel & Herout, "Yet Faster Ray-Triangle Intersection (Using SSE4)", IEEE Transactions on Visualization and
// Computer Graphics 16(3), 2010, doi:10.1109/TVCG.2009.73: its three planes and its test.
#pragma once

#include "core/rivals/lanes.h"

namespace tribunal::published {

template <class N>
struct HavelHerout {
  using Number = N;
  static constexpr RivalCard card{"three stored planes, sign bits compared before the one division",
                                  "Havel & Herout 2010"};
  static constexpr Contract contract{.triangles = Triangles::proper,
                                     .convention = Convention::unspecified,
                                     .boundary = Boundary::unspecified,
                                     .ends = Ends::unspecified};

  /// A normal and an offset.
  struct Level {
    Vec3<N> n;
    N d;
  };

  /// The plane of the triangle as n·x = d, and the functions n·x + d that yield the weights of b and c.
  struct Prepared {
    Level plane, of_b, of_c;
  };

  static Prepared prepare(const Corners<N>& t) {
    const Plane<N> p = plane_of(t);
    const N inverse = 1 / dot(p.normal, p.normal);
    const Vec3<N> n1 = scaled(cross(p.ac, p.normal), inverse);
    const Vec3<N> n2 = scaled(cross(p.normal, p.ab), inverse);
    return {{p.normal, dot(p.normal, t.a)}, {n1, N(-dot(n1, t.a))}, {n2, N(-dot(n2, t.a))}};
  }

  /// Nothing tests det for zero: where the line lies in the plane all signs are those of zeros, and agree.
  /// Four rays or four triangles at once in the source.
  static Found<N> meet(const Vec3<N>& o, const Vec3<N>& d, const N& t_max, const Prepared& t) {
    const N det = dot(t.plane.n, d);
    const N dett = t.plane.d - dot(o, t.plane.n);
    const N beyond = t_max * det - dett;
    const MaskOf<N> within = sign_bit(dett) == sign_bit(select(t_max * 0 == 0, beyond, det));
    if (none(within)) return {};
    const Vec3<N> p = {o.x * det + d.x * dett, o.y * det + d.y * dett, o.z * det + d.z * dett};
    const N detu = dot(p, t.of_b.n) + det * t.of_b.d;
    const MaskOf<N> beside = within & (sign_bit(detu) == sign_bit(N(det - detu)));
    if (none(beside)) return {};
    const N detv = dot(p, t.of_c.n) + det * t.of_c.d;
    const MaskOf<N> inside = beside & (sign_bit(detv) == sign_bit(N(det - detu - detv)));
    if (none(inside)) return {};
    const N inverse = 1 / det;
    return {inside, dett * inverse, {detu * inverse, detv * inverse}};
  }
};

}  // namespace tribunal::published
