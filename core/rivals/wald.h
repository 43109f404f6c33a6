// Wald's test with a stored projection ("TriAccel"): t from the plane scaled to 1 on the dropped axis, then two
// coordinates, each linear in the projected hit.
// Source: Wald, "Realtime Ray Tracing and Interactive Global Illumination", PhD thesis, Saarland University, 2004:
// its structure TriAccel and its test.
#pragma once

#include "core/rivals/lanes.h"

namespace tribunal::published {

template <class N>
struct Wald {
  using Number = N;
  static constexpr RivalCard card{"stored projection (TriAccel), two coordinates linear in the hit", "Wald 2004"};
  static constexpr Contract contract{.convention = Convention::transversal};

  /// The linear function u·x + v·y + d of a projected point (x, y).
  struct Linear {
    N u, v, d;
  };

  struct Prepared {
    Linear plane;  ///< on the plane, the dropped coordinate is d − u·x − v·y
    AxisOf<N> dropped;
    Linear of_b, of_c;
  };

  static Prepared prepare(const Corners<N>& t) {
    const Plane<N> p = plane_of(t);
    const AxisOf<N> axis = longest_axis(p.normal);
    const N whole = coordinate(p.normal, axis);
    const Vec2<N> n = project(p.normal, axis), a = project(t.a, axis);
    const Vec2<N> ab = project(p.ab, axis), ac = project(p.ac, axis);
    return {{n.u / whole, n.v / whole, dot(p.normal, t.a) / whole},
            axis,
            {ac.v / whole, -ac.u / whole, (ac.u * a.v - ac.v * a.u) / whole},
            {-ab.v / whole, ab.u / whole, (ab.v * a.u - ab.u * a.v) / whole}};
  }

  /// Four rays at once in the source, which goes on where none is left.
  static Found<N> meet(const Vec3<N>& o, const Vec3<N>& d, const Prepared& t) {
    const Vec2<N> from = project(o, t.dropped), along = project(d, t.dropped);
    const N reciprocal = 1 / (coordinate(d, t.dropped) + t.plane.u * along.u + t.plane.v * along.v);
    const N at = (t.plane.d - coordinate(o, t.dropped) - t.plane.u * from.u - t.plane.v * from.v) * reciprocal;
    const N x = from.u + at * along.u, y = from.v + at * along.v;
    const N b = x * t.of_b.u + y * t.of_b.v + t.of_b.d;
    if (none(b >= 0)) return {};
    const N c = x * t.of_c.u + y * t.of_c.v + t.of_c.d;
    return {MaskOf<N>((b >= 0) & (c >= 0) & (b + c <= 1)), at, {b, c}};
  }
};

}  // namespace tribunal::published
