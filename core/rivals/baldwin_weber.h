// The test of Baldwin and Weber: a stored transformation to coordinates in which the triangle is the unit triangle,
// with one column fixed, so that nine numbers are kept.
// Source: Baldwin & Weber, "Fast Ray-Triangle Intersections by Coordinate Transformation", Journal of Computer
// Graphics Techniques 5(3), 2016: its transformations with a fixed column and its test with nine coefficients.
#pragma once

#include "core/rivals/rival.h"

namespace tribunal::published {

template <class N>
struct BaldwinWeber {
  using Number = N;
  static constexpr RivalCard card{"stored transformation to the unit triangle, nine coefficients",
                                  "Baldwin & Weber 2016"};
  static constexpr Contract contract{
      .triangles = Triangles::proper, .convention = Convention::transversal, .boundary = Boundary::unspecified};

  /// The linear function u·x + v·y + d of the two coordinates x, y that are not fixed.
  struct Row {
    N u, v, d;
    N of(const Vec2<N>& p) const { return u * p.u + v * p.v + d; }
  };

  /// The rows of the transformation. In the fixed column, which is not kept, the row `height` has 1, the others 0.
  struct Prepared {
    Row of_b, of_c, height;
    Axis fixed;
  };

  static Prepared prepare(const Corners<N>& t) {
    const Plane<N> p = plane_of(t);
    const Axis axis = longest_axis(p.normal);
    const N whole = coordinate(p.normal, axis);
    const Vec2<N> n = project(p.normal, axis), ab = project(p.ab, axis), ac = project(p.ac, axis);
    const Vec2<N> a = project(t.a, axis), b = project(t.b, axis), c = project(t.c, axis);
    return {{ac.v / whole, -ac.u / whole, (c.u * a.v - c.v * a.u) / whole},
            {-ab.v / whole, ab.u / whole, -(b.u * a.v - b.v * a.u) / whole},
            {n.u / whole, n.v / whole, -dot(p.normal, t.a) / whole},
            axis};
  }

  static std::optional<RivalHit<N>> meet(const Vec3<N>& o, const Vec3<N>& d, const Prepared& t) {
    const N from = coordinate(o, t.fixed) + t.height.of(project(o, t.fixed));
    const Vec2<N> along = project(d, t.fixed);
    const N slope = coordinate(d, t.fixed) + t.height.u * along.u + t.height.v * along.v;
    const N at = -from / slope;
    const Vec2<N> p = project(point_at(o, d, at), t.fixed);
    const N b = t.of_b.of(p), c = t.of_c.of(p);
    if (!(b >= 0 && c >= 0 && b + c < 1)) return std::nullopt;
    return RivalHit<N>{at, Weights<N>{b, c}};
  }
};

}  // namespace tribunal::published
