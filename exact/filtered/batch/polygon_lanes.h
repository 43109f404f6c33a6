// The filter of filtered_polygon.h on vector lanes: one polygon, a probe on each lane. The formulas and their bounds
// are those of plane_crossing.h. Included by files that are compiled for one instruction set each.
#pragma once

#include "exact/filtered/batch/lanes.h"
#include "exact/filtered/plane_crossing.h"
#include "exact/filtered/polygon_figures.h"

namespace tribunal::HWY_NAMESPACE {

/// The lanes on which the probe certainly misses and certainly hits the face, one bit each. A ray that hits reaches the
/// plane at t = num/den; the bounds are those of the errors of num and den, and |den| certainly exceeds its own.
struct LaneVerdict {
  unsigned missed, hit;
  Lanes num, den, num_bound, den_bound;
};

/// One probe on each lane, to be filtered against one polygon after the other.
template <class P>
class PolygonFilter {
 public:
  /// The sources of the probes, and the targets of segments or the directions of rays.
  PolygonFilter(const Vec3<Lanes>& source, const Vec3<Lanes>& target) : source_(source), target_(target) {}

  /// First the plane: a probe with both ends certainly on one side misses. Then, for those lanes of `asked` on which
  /// the ends certainly lie on different sides, the parity of the edges ahead of the point where the probe meets the
  /// plane.
  HWY_INLINE LaneVerdict filter(const PolygonFigures& f, unsigned asked) const {
    const Vec3<Twin<Lanes>> base = twice_each(f.base);
    const Vec3<Lanes> end = is_ray ? target_ : target_ - of(f.base);
    const Vec3<Twin<Lanes>> ends = beside(source_ - first_of(base), end);
    const Twin<Lanes> reach = reach_of(ends), h = dot(twice_each(f.normal), ends);
    const Twin<Lanes> bound = reach * both(crossing_bounds.height) + both(crossing_bounds.tiny);
    const LaneMask sure = (magnitude(h.first) > bound.first) & (magnitude(h.second) > bound.second);
    const unsigned below_first = negative(h.first), below_second = negative(h.second);
    const unsigned beside_plane = sure.bits() & ~(below_first ^ below_second);
    const unsigned crossing = asked & sure.bits() & (below_first ^ below_second);
    LaneVerdict verdict{beside_plane, 0, h.first, -h.second, bound.first, bound.second};
    if (crossing != 0) add_parity(f, ends, h, reach, crossing, verdict);
    return verdict;
  }

 private:
  static constexpr bool is_ray = std::is_same_v<P, Ray>;

  static HWY_INLINE Vec3<Lanes> of(const Vec3<double>& v) { return {Lanes(v.x), Lanes(v.y), Lanes(v.z)}; }
  static HWY_INLINE Twin<Lanes> both(double x) { return twice(Lanes(x)); }
  static HWY_INLINE Vec3<Twin<Lanes>> twice_each(const Vec3<double>& v) { return {both(v.x), both(v.y), both(v.z)}; }
  static HWY_INLINE Vec3<Lanes> first_of(const Vec3<Twin<Lanes>>& v) { return {v.x.first, v.y.first, v.z.first}; }
  static HWY_INLINE unsigned negative(const Lanes& a) { return (a < Lanes(0.0)).bits(); }

  static HWY_INLINE void add_parity(const PolygonFigures& f, const Vec3<Twin<Lanes>>& ends, const Twin<Lanes>& heights,
                                    const Twin<Lanes>& reach, unsigned crossing, LaneVerdict& verdict) {
    const Lanes extent(f.extent), range = crossing_range<P>(reach, extent);
    const Twin<Lanes> along[3] = {ends.x, ends.y, ends.z};
    const PlaneCrossing<Lanes> at = plane_crossing<P>(heights, Vec2<Twin<Lanes>>{along[f.u], along[f.v]});
    const Lanes vertex = Lanes(crossing_bounds.vertex) * range + Lanes(crossing_bounds.tiny);
    const Lanes edge = Lanes(Lanes(crossing_bounds.edge) * range) * extent + Lanes(crossing_bounds.tiny);
    unsigned sure = crossing & (range < Lanes(crossing_bounds.huge)).bits(), odd = 0;
    for (const RingRun& run : f.runs) add_run(run, at, vertex, edge, sure, odd);
    verdict.hit = sure & odd;
    verdict.missed |= sure & ~odd;
  }

  /// Vertices at the height of the point, and edges through it, make a lane unsure.
  static HWY_INLINE void add_run(const RingRun& run, const PlaneCrossing<Lanes>& at, const Lanes& vertex,
                                 const Lanes& edge, unsigned& sure, unsigned& odd) {
    Lanes least(crossing_bounds.huge);
    unsigned below = 0;
    for (std::size_t i = 0; i < run.size; ++i) {
      const Lanes ahead = at.ahead_v(Lanes(run.v[i]));
      least = smaller(magnitude(ahead), least);
      const unsigned now = negative(ahead);
      const bool leads_here = i > 0 && (run.edges >> (i - 1) & 1) != 0;
      const unsigned crossed = leads_here ? (below ^ now) & sure : 0;
      if (crossed != 0) {
        const Lanes side =
            edge_side(at, {Lanes(run.u[i - 1]), Lanes(run.v[i - 1])}, {Lanes(run.u[i]), Lanes(run.v[i])});
        sure &= ~crossed | (magnitude(side) > edge).bits();
        odd ^= crossed & ~((side > Lanes(0.0)).bits() ^ below);
      }
      below = now;
    }
    sure &= (least > vertex).bits();
  }

  Vec3<Lanes> source_, target_;
};

}  // namespace tribunal::HWY_NAMESPACE
