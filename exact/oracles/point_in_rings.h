// Two oracles for a point and the rings of a flat polygon. Neither divides, sums areas or uses triangles.
// Sources: generic-direction ray: Edelsbrunner & Mücke's simulation of simplicity is not needed, since some direction
// meets no vertex; half-open crossings: Shimrat, "Algorithm 112: position of point relative to polygon", CACM 5(8),
// 1962, with the half-open rule of Haines, "Point in polygon strategies", Graphics Gems IV, 1994.
#pragma once

#include <vector>

#include "core/sign.h"
#include "core/vec3.h"

namespace tribunal {

/// The edges of all rings as seen from the point: both ends minus the point, times any positive number.
template <class N>
struct SeenEdge {
  Vec2<N> a, b;
};

namespace point_in_rings_detail {

template <class N>
Sign turn(const Vec2<N>& f, const Vec2<N>& g) {
  const N d = f.u * g.v - f.v * g.u;
  return sign_of(d);
}

template <class N>
Sign along(const Vec2<N>& f, const Vec2<N>& g) {
  const N d = f.u * g.u + f.v * g.v;
  return sign_of(d);
}

}  // namespace point_in_rings_detail

/// Whether the point lies on a closed edge: its ends are seen in opposite directions, or one of them is the point.
template <class N>
bool on_ring_edge(const std::vector<SeenEdge<N>>& edges) {
  namespace detail = point_in_rings_detail;
  for (const SeenEdge<N>& e : edges) {
    if (detail::turn(e.a, e.b) == Sign::zero && detail::along(e.a, e.b) != Sign::positive) return true;
  }
  return false;
}

/// Whether a ray that avoids the vertices crosses an odd number of edges. Its direction is the first of (1, 0), (1, 1),
/// (1, 2), … of which the line meets no vertex; a vertex excludes at most one of them, so one of the first n + 1
/// serves. The point must lie on no edge.
template <class N>
bool inside_by_generic_ray(const std::vector<SeenEdge<N>>& edges) {
  namespace detail = point_in_rings_detail;
  for (int m = 0;; ++m) {
    const Vec2<N> direction{N(1), N(m)};
    bool generic = true, inside = false;
    for (const SeenEdge<N>& e : edges) {
      const Sign a = detail::turn(direction, e.a), b = detail::turn(direction, e.b);
      generic = generic && a != Sign::zero && b != Sign::zero;
      inside ^= a * b == Sign::negative && detail::turn(e.a, e.b) == b;
    }
    if (generic) return inside;
  }
}

/// Whether the ray in the direction (1, 0) crosses an odd number of edges, where an edge contains its lower end but not
/// its upper.
template <class N>
bool inside_by_half_open_crossings(const std::vector<SeenEdge<N>>& edges) {
  bool inside = false;
  for (const SeenEdge<N>& e : edges) {
    const bool a_above = sign_of(e.a.v) == Sign::positive, b_above = sign_of(e.b.v) == Sign::positive;
    if (a_above == b_above) continue;
    inside ^= point_in_rings_detail::turn(e.a, e.b) == (b_above ? Sign::positive : Sign::negative);
  }
  return inside;
}

}  // namespace tribunal
