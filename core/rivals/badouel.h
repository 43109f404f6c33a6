// Badouel's test: intersect with the plane, project along the axis on which the normal is longest, and solve for the
// point's two coordinates in the triangle.
// Source: Badouel, "An Efficient Ray–Polygon Intersection", Graphics Gems, 1990, pp. 390–393: t = −(d + N·O)/(N·D),
// then α and β of the projected point from u₀ = α·u₁ + β·u₂ and v₀ = α·v₁ + β·v₂, by two cases: u₁ = 0 and u₁ ≠ 0.
#pragma once

#include "core/rivals/rival.h"

namespace tribunal::published {

template <class N>
struct Badouel {
  using Number = N;
  static constexpr RivalCard card{"plane, projection along an axis, two coordinates by division", "Badouel 1990"};
  static constexpr Contract contract{.convention = Convention::transversal};

  /// The plane normal·x + d = 0, the axis that is dropped, the projected vertex a and the edges from it.
  struct Prepared {
    Vec3<N> normal;
    N d;
    Axis dropped;
    Vec2<N> a, ab, ac;
  };

  static Prepared prepare(const Corners<N>& t) {
    const Plane<N> p = plane_of(t);
    const N height = dot(p.normal, t.a);
    const Axis axis = longest_axis(p.normal);
    return {p.normal, N(-height), axis, project(t.a, axis), project(p.ab, axis), project(p.ac, axis)};
  }

  static std::optional<RivalHit<N>> meet(const Vec3<N>& o, const Vec3<N>& direction, const Prepared& t) {
    const N slope = dot(t.normal, direction);
    if (slope == 0) return std::nullopt;
    const N at = -(t.d + dot(t.normal, o)) / slope;
    const Vec2<N> p = project(point_at(o, direction, at), t.dropped);
    const std::optional<Weights<N>> weights = coordinates({N(p.u - t.a.u), N(p.v - t.a.v)}, t.ab, t.ac);
    if (!weights) return std::nullopt;
    return RivalHit<N>{at, weights};
  }

 private:
  /// α and β with x = α·ab + β·ac, if the point is inside.
  static std::optional<Weights<N>> coordinates(const Vec2<N>& x, const Vec2<N>& ab, const Vec2<N>& ac) {
    const bool upright = ab.u == 0;
    const N beta = upright ? N(x.u / ac.u) : N((x.v * ab.u - x.u * ab.v) / (ac.v * ab.u - ac.u * ab.v));
    if (!(beta >= 0 && beta <= 1)) return std::nullopt;
    const N alpha = upright ? N((x.v - beta * ac.v) / ab.v) : N((x.u - beta * ac.u) / ab.u);
    if (!(alpha >= 0 && alpha + beta <= 1)) return std::nullopt;
    return Weights<N>{alpha, beta};
  }
};

}  // namespace tribunal::published
