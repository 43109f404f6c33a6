// Chirkov's test of a segment: the sides of its ends to the plane, then two sign comparisons in a projection, all
// without a division.
// Source: Chirkov, "Fast 3D Line Segment–Triangle Intersection Test", Journal of Graphics Tools 10(3), 2005, variants
// C2 (no stored data) and C3 (stored plane) of its code. The published C2 compares |n_x| and |n_y| with 0.57735·|n|²,
// where 0.57735·|n| is meant (docs/findings.md); here the squares are compared: 3·n_x² with |n|².
#pragma once

#include "core/rivals/rival.h"

namespace tribunal::published {

namespace chirkov_detail {

/// What both variants decide by: the signed distances, unnormalised, of the segment's ends from the plane, and the axis
/// that is dropped.
template <class N>
struct Sides {
  N source, target;
  Axis dropped;
};

template <class N>
N area(const Vec2<N>& f, const Vec2<N>& g) {
  return f.u * g.v - f.v * g.u;
}

/// Whether the crossing point lies strictly inside the angle of two edges e and f that start at one corner, or inside
/// the opposite angle. `base` is p − corner, `direction` q − p, both projected. The crossing point minus the corner,
/// times `scale`, is scale · base + s.source · direction.
template <class N>
bool between(const Sides<N>& s, const Vec2<N>& direction, const Vec2<N>& base, const Vec2<N>& e, const Vec2<N>& f) {
  const N scale = s.source - s.target;
  const N left = s.source * area(e, direction) + scale * area(e, base);
  const N right = s.source * area(direction, f) + scale * area(base, f);
  return left * right > 0;
}

template <class N>
std::optional<RivalHit<N>> hit_by_sides(const Vec3<N>& p, const Vec3<N>& q, const Corners<N>& t, const Sides<N>& s) {
  if (s.source * s.target > 0) return std::nullopt;
  const auto flat = [&](const Vec3<N>& v) { return project(v, s.dropped); };
  const Vec2<N> direction = flat(q - p), ab = flat(t.b - t.a);
  if (!between<N>(s, direction, flat(p - t.a), ab, flat(t.c - t.a))) return std::nullopt;
  if (!between<N>(s, direction, flat(p - t.b), ab, flat(t.b - t.c))) return std::nullopt;
  return RivalHit<N>{s.source / (s.source - s.target)};
}

inline constexpr Contract contract{
    .probes = {.rays = false}, .convention = Convention::transversal, .boundary = Boundary::open};

}  // namespace chirkov_detail

/// C2: nothing is stored.
template <class N>
struct ChirkovUnprepared {
  using Number = N;
  using Prepared = Corners<N>;
  static constexpr RivalCard card{"sides of the ends, signs in a projection; no stored data (C2), axis by squares",
                                  "Chirkov 2005"};
  static constexpr Contract contract = chirkov_detail::contract;

  /// An axis on which the normal is longer than 1/√3 of its length, or z.
  static Axis axis_of(const Vec3<N>& normal) {
    const N whole = dot(normal, normal);
    if (3 * (normal.x * normal.x) > whole) return Axis::x;
    return 3 * (normal.y * normal.y) > whole ? Axis::y : Axis::z;
  }

  static std::optional<RivalHit<N>> meet_segment(const Vec3<N>& p, const Vec3<N>& q, const Prepared& t) {
    const Vec3<N> normal = plane_of(t).normal;
    const N height = dot(normal, t.a);
    return chirkov_detail::hit_by_sides<N>(p, q, t,
                                           {dot(normal, p) - height, dot(normal, q) - height, axis_of(normal)});
  }
};

/// C3: the plane and the axis on which its normal is longest are stored.
template <class N>
struct ChirkovPrepared {
  using Number = N;
  static constexpr RivalCard card{"sides of the ends to a stored plane, signs in a projection (C3)", "Chirkov 2005"};
  static constexpr Contract contract = chirkov_detail::contract;

  struct Prepared {
    Corners<N> corners;
    Vec3<N> normal;
    N height;
    Axis dropped;
  };

  static Prepared prepare(const Corners<N>& t) {
    const Vec3<N> normal = plane_of(t).normal;
    return {t, normal, dot(normal, t.a), longest_axis(normal)};
  }

  static std::optional<RivalHit<N>> meet_segment(const Vec3<N>& p, const Vec3<N>& q, const Prepared& t) {
    return chirkov_detail::hit_by_sides<N>(p, q, t.corners,
                                           {dot(t.normal, p) - t.height, dot(t.normal, q) - t.height, t.dropped});
  }
};

}  // namespace tribunal::published
