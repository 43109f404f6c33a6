// Edge functions in one fixed order: each edge is computed from its lexicographically smaller end, so that the two
// triangles that share it get the same number with opposite signs, in any arithmetic.
// Source: Pineda, "A Parallel Algorithm for Polygon Rasterization", SIGGRAPH 1988 (edge functions); the fixed order is
// the usual remedy where neighbours compute an edge from either end.
#pragma once

#include "core/rivals/order.h"
#include "core/rivals/pluecker.h"

namespace tribunal::published {

template <class N>
struct FixedEdges {
  using Number = N;
  using Prepared = Corners<N>;
  static constexpr RivalCard card{"edge functions, each computed from the smaller end of its edge", "Pineda 1988"};
  static constexpr Contract contract{.convention = Convention::transversal};

  static std::optional<RivalHit<N>> meet(const Vec3<N>& o, const Vec3<N>& d, const Prepared& t) {
    const Vec3<N> normal = plane_of(t).normal;
    return hit_by_volumes<N>(edge(o, d, t.b, t.c), edge(o, d, t.c, t.a), edge(o, d, t.a, t.b), dot(normal, t.a - o),
                             dot(normal, d));
  }

 private:
  static N edge(const Vec3<N>& o, const Vec3<N>& d, const Vec3<N>& x, const Vec3<N>& y) {
    return precedes(y, x) ? N(-volume(o, d, y, x)) : volume(o, d, x, y);
  }

  static N volume(const Vec3<N>& o, const Vec3<N>& d, const Vec3<N>& x, const Vec3<N>& y) {
    return dot(d, cross(x - o, y - o));
  }
};

}  // namespace tribunal::published
