// The side of the ray's line to each edge's line, by Plücker coordinates or as scalar triple products.
// Sources: Plücker coordinates: Amanatides & Choi, "Ray Tracing Triangular Meshes", Western Computer Graphics Symposium
// 1997; Erickson, "Pluecker Coordinates", Ray Tracing News 10(3), 1997 (the permuted inner product). Triple products:
// Ericson, "Real-Time Collision Detection", 2005, section 5.3.4, in its form for triangles that are seen from both
// sides.
#pragma once

#include "core/rivals/rival.h"

namespace tribunal::published {

/// Whether no two of the three have opposite signs.
template <class N>
bool same_side(const N& u, const N& v, const N& w) {
  return (u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0);
}

/// The hit from the volumes det(d, x − o, y − o) of the edges xy opposite to a, b and c, with t = height / slope from
/// the plane. The three volumes of a line in the plane are zero.
template <class N>
std::optional<RivalHit<N>> hit_by_volumes(const N& of_a, const N& of_b, const N& of_c, const N& height,
                                          const N& slope) {
  if (!same_side(of_a, of_b, of_c)) return std::nullopt;
  const N sum = of_a + of_b + of_c;
  if (sum == 0) return std::nullopt;
  const N inverse = 1 / sum;
  return RivalHit<N>{height / slope, Weights<N>{of_b * inverse, of_c * inverse}};
}

template <class N>
struct Pluecker {
  using Number = N;
  static constexpr RivalCard card{"sides of the ray to three stored lines, in Plücker coordinates",
                                  "Erickson 1997; Amanatides & Choi 1997"};
  static constexpr Contract contract{.convention = Convention::transversal};

  /// The line from x to y: y − x and x × y.
  struct Line {
    Vec3<N> direction, moment;
  };

  /// The lines of the edges, and the plane for t.
  struct Prepared {
    Line ab, bc, ca;
    Vec3<N> normal;
    N height;
  };

  static Line line(const Vec3<N>& x, const Vec3<N>& y) { return {y - x, cross(x, y)}; }

  static Prepared prepare(const Corners<N>& t) {
    const Plane<N> p = plane_of(t);
    return {line(t.a, t.b), line(t.b, t.c), line(t.c, t.a), p.normal, dot(p.normal, t.a)};
  }

  static N side(const Line& ray, const Line& edge) {
    return dot(ray.direction, edge.moment) + dot(ray.moment, edge.direction);
  }

  static std::optional<RivalHit<N>> meet(const Vec3<N>& o, const Vec3<N>& d, const Prepared& t) {
    const Line ray{d, cross(o, d)};
    return hit_by_volumes<N>(side(ray, t.bc), side(ray, t.ca), side(ray, t.ab), t.height - dot(t.normal, o),
                             dot(t.normal, d));
  }
};

template <class N>
struct TripleProducts {
  using Number = N;
  using Prepared = Corners<N>;
  static constexpr RivalCard card{"three scalar triple products of the direction and vectors to the vertices",
                                  "Ericson 2005, 5.3.4"};
  static constexpr Contract contract{.convention = Convention::transversal};

  static std::optional<RivalHit<N>> meet(const Vec3<N>& o, const Vec3<N>& d, const Prepared& t) {
    const Vec3<N> a = t.a - o, b = t.b - o, c = t.c - o;
    const Vec3<N> beside_c = cross(d, c);
    const N of_a = -dot(beside_c, b);
    const N of_b = dot(beside_c, a);
    const N of_c = dot(d, cross(a, b));
    const Vec3<N> normal = plane_of(t).normal;
    return hit_by_volumes<N>(of_a, of_b, of_c, dot(normal, a), dot(normal, d));
  }
};

}  // namespace tribunal::published
