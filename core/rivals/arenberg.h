// Arenberg's test: the inverse of the matrix (b − a, c − a, normal) takes the ray to coordinates in which the triangle
// is the unit triangle in the plane z = 0.
// Source: Arenberg, "Re: Ray/Triangle Intersection with Barycentric Coordinates", in Haines (ed.), Ray Tracing News
// 1(11), 1988. Equations: P = a + α·(b − a) + β·(c − a) + γ·normal, t = −γ(origin) / γ(direction).
#pragma once

#include "core/rivals/rival.h"

namespace tribunal::published {

template <class N>
struct Arenberg {
  using Number = N;
  static constexpr RivalCard card{"stored inverse of the triangle's matrix, one division for t", "Arenberg 1988"};
  static constexpr Contract contract{.convention = Convention::transversal};

  /// The rows of the inverse, and the vertex a.
  struct Prepared {
    Vec3<N> alpha, beta, gamma, a;
  };

  /// The determinant of the matrix is the square of the normal's length. A triangle without area has none: its rows
  /// are infinite or NaN.
  static Prepared prepare(const Corners<N>& t) {
    const Plane<N> p = plane_of(t);
    const N inverse = 1 / dot(p.normal, p.normal);
    return {scaled(cross(p.ac, p.normal), inverse), scaled(cross(p.normal, p.ab), inverse), scaled(p.normal, inverse),
            t.a};
  }

  static std::optional<RivalHit<N>> meet(const Vec3<N>& o, const Vec3<N>& d, const Prepared& t) {
    const Vec3<N> from_a = o - t.a;
    const N slope = dot(t.gamma, d);
    if (slope == 0) return std::nullopt;
    const N at = -dot(t.gamma, from_a) / slope;
    const N alpha = dot(t.alpha, from_a) + at * dot(t.alpha, d);
    const N beta = dot(t.beta, from_a) + at * dot(t.beta, d);
    if (!(alpha >= 0 && beta >= 0 && alpha + beta <= 1)) return std::nullopt;
    return RivalHit<N>{at, Weights<N>{alpha, beta}};
  }
};

}  // namespace tribunal::published
