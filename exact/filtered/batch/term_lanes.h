// The second filter, term_filter.h, on vector lanes: one triangle, a probe on each lane. All five signs at once instead
// of one by one. Included by files that are compiled for one instruction set each.
#pragma once

#include "exact/filtered/batch/lanes.h"
#include "exact/filtered/term_filter.h"

namespace tribunal::HWY_NAMESPACE {

using namespace detail;

/// One probe on each lane: its source, and its target or, for a ray, its direction.
struct LaneProbe {
  Vec3<Lanes> source, target;
};

/// The lanes on which a determinant is certainly positive, and those on which it is certainly negative.
struct CertainSigns {
  unsigned positive, negative;
};

HWY_INLINE CertainSigns certain_signs(const Vec3<Lanes>& u, const Vec3<Lanes>& v, const Vec3<Lanes>& w,
                                      const FilterConstants<Lanes>& c) {
  const Expansion<Lanes> e = expanded(u, v, w);
  const Lanes bound = c.k * e.terms + c.tiny;
  const unsigned safe = in_range(largest(u, v, w), c).bits();
  return {(e.value > bound).bits() & safe, (e.value < -bound).bits() & safe};
}

/// The lanes on which filter_hits_by_terms says miss, and hit.
template <class P>
HWY_INLINE std::pair<unsigned, unsigned> missed_and_hit_by_terms(const LaneProbe& probe,
                                                                 const LiftedTriangle<Lanes>& t) {
  constexpr bool is_ray = std::is_same_v<P, Ray>;
  const FilterConstants<Lanes> c = in_lanes(volume_terms_filter);
  const Vec3<Lanes>&p = probe.source, &q = probe.target, u = t.b - t.a, v = t.c - t.a, d = is_ray ? q : q - p;
  const CertainSigns from = certain_signs(u, v, p - t.a, c), to = certain_signs(u, v, is_ray ? q : q - t.a, c);
  const CertainSigns ab = certain_signs(t.a - p, u, d, c), bc = certain_signs(t.b - p, t.c - t.b, d, c),
                     ca = certain_signs(t.c - p, t.a - t.c, d, c);
  const unsigned one_side = (from.positive & to.positive) | (from.negative & to.negative);
  const unsigned two_sides = (from.positive & to.negative) | (from.negative & to.positive);
  const unsigned left = ab.positive | bc.positive | ca.positive, right = ab.negative | bc.negative | ca.negative;
  const unsigned inside = (ab.positive & bc.positive & ca.positive) | (ab.negative & bc.negative & ca.negative);
  return {one_side | (left & right), two_sides & inside};
}

}  // namespace tribunal::HWY_NAMESPACE
