// The test of Jiménez, Segura and Feito: volumes of tetrahedra with the vertex c and the two ends of the segment.
// Source: Jiménez, Segura & Feito, "A robust segment/triangle intersection algorithm for interference tests.
// Efficiency study", Computational Geometry 43(5), 2010, doi:10.1016/j.comgeo.2009.10.001: its theorem, whose
// condition that the first end is not in the plane is met by swapping the ends, and its algorithm, with 0 for the
// tolerance.
#pragma once

#include "core/rivals/rival.h"

namespace tribunal::published {

template <class N>
struct Jimenez {
  using Number = N;
  using Prepared = Corners<N>;
  static constexpr RivalCard card{"volumes at the ends of the segment, swapped if the first is in the plane",
                                  "Jiménez, Segura & Feito 2010"};
  static constexpr Contract contract{.probes = {.rays = false}, .convention = Convention::transversal};

  static std::optional<RivalHit<N>> meet_segment(const Vec3<N>& p, const Vec3<N>& q, const Prepared& t) {
    const Vec3<N> first = p - t.c, second = q - t.c;
    const Vec3<N> to_a = t.a - t.c, to_b = t.b - t.c;
    const Vec3<N> normal = cross(to_a, to_b);
    const N w = dot(first, normal), s = dot(second, normal);
    if (w != 0) return from_outside(first, second, to_a, to_b, w, s, false);
    if (s != 0) return from_outside(second, first, to_a, to_b, s, w, true);
    return std::nullopt;
  }

 private:
  /// The theorem, for a `first` that is not in the plane. w ≠ 0 and s are the volumes of `first` and `second` with abc.
  static std::optional<RivalHit<N>> from_outside(const Vec3<N>& first, const Vec3<N>& second, const Vec3<N>& to_a,
                                                 const Vec3<N>& to_b, const N& w, const N& s, bool swapped) {
    const Vec3<N> beside = cross(first, second);
    const N t = dot(beside, to_b);
    const N u = -dot(beside, to_a);
    const bool above = w > 0;
    if (above ? s > 0 || t < 0 || u < 0 || w < s + t + u : s < 0 || t > 0 || u > 0 || w > s + t + u) {
      return std::nullopt;
    }
    const N inverse = 1 / (w - s);
    const N along = w * inverse;
    return RivalHit<N>{swapped ? N(1 - along) : along, Weights<N>{u * inverse, (w - s - t - u) * inverse}};
  }
};

}  // namespace tribunal::published
