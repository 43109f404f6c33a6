// The test that a genetic search over equal formulas found to be the fastest.
// Source: Kensler & Shirley, "Optimizing Ray-Triangle Intersection via Automated Search", IEEE Symposium on
// Interactive Ray Tracing 2006, the formula that it gives in code: one normal, one further cross product.
#pragma once

#include "core/rivals/rival.h"

namespace tribunal::published {

template <class N>
struct KenslerShirley {
  using Number = N;
  using Prepared = Corners<N>;
  static constexpr RivalCard card{"the fastest of many equal formulas, by automated search; divides at once",
                                  "Kensler & Shirley 2006"};
  static constexpr Contract contract{.convention = Convention::transversal};

  /// A line parallel to the plane divides by zero: no coordinate is finite, and none passes.
  static std::optional<RivalHit<N>> meet(const Vec3<N>& o, const Vec3<N>& d, const Prepared& t) {
    const Vec3<N> e0 = t.b - t.a;
    const Vec3<N> e1 = t.a - t.c;
    const Vec3<N> normal = cross(e1, e0);
    const Vec3<N> e2 = scaled(t.a - o, N(1 / dot(normal, d)));
    const Vec3<N> beside = cross(d, e2);
    const N beta = dot(beside, e1);
    const N gamma = dot(beside, e0);
    if (!(beta >= 0 && gamma >= 0 && beta + gamma <= 1)) return std::nullopt;
    return RivalHit<N>{dot(normal, e2), Weights<N>{beta, gamma}};
  }
};

}  // namespace tribunal::published
