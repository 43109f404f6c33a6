// The certified polygon test: a filter in doubles decides about the whole polygon at once; where it fails, the covering
// test decides sign by sign.
#pragma once

#include <bit>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/polygon.h"
#include "core/segura_feito_polygon.h"
#include "exact/filtered/plane_crossing.h"
#include "exact/filtered/polygon_figures.h"

namespace tribunal {

/// A polygon prepared for many probes. Views the polygon, which must outlive it and be finite.
///
/// Law: the answer is that of the covering test on exact numbers, always, whatever the rounding mode of the thread.
/// Answers of Stage::filter come from doubles. A probe with a NaN or an infinity meets nothing.
class FilteredPolygon {
 public:
  explicit FilteredPolygon(const Polygon& polygon);
  FilteredPolygon(FilteredPolygon&&) = default;
  FilteredPolygon& operator=(FilteredPolygon&&) = default;

  Answer meet(const Segment& s) const;
  Answer meet(const Ray& r) const;

  /// Whether probe and polygon meet. Some 10 ns where doubles decide.
  template <class P>
  bool hits(const P& probe) const {
    return filtered<bool>(probe, [&] { return hits_exactly(probe); });
  }

  /// Whether the probe certainly hits or certainly misses; nothing where rounding could matter, where the probe meets
  /// the plane in a degenerate place, and where the polygon is not planar.
  template <class P>
  std::optional<bool> filter_hits(const P& probe) const {
    return filtered<std::optional<bool>>(probe, [] { return std::nullopt; });
  }

  /// Whether the polygon certainly covers, or certainly does not cover, every point of its plane that lies between the
  /// two ends in the projection. For short segments that cross the plane at so flat an angle, or so close to an end,
  /// that doubles cannot say where. It is certain where both ends see all edges alike, so that all points between them
  /// do too. The segment must be finite; whether it crosses the plane is not asked.
  std::optional<bool> filter_between(const Segment& s) const;

  /// For the same filter on vector lanes (batch/polygon_lanes.h). Views this polygon, which may be moved.
  detail::PolygonFigures figures() const;

 private:
  /// The vertices of a run as seen from a point, one bit each: `below`, which lie below the point; `ahead`, which begin
  /// an edge that is crossed ahead of the point.
  struct View {
    bool certain;
    std::uint64_t below, ahead;

    bool odd() const { return __builtin_parityll(ahead) != 0; }
  };

  void prepare_filter();
  void flatten(const Vec3<double>& base);
  bool hits_exactly(const Segment& s) const;
  bool hits_exactly(const Ray& r) const;
  template <class Result, class P, class Otherwise>
  Result filtered(const P& probe, const Otherwise& otherwise) const;
  template <class P>
  Answer decide(const P& probe) const;
  template <class P>
  Answer decide_exactly(const P& probe) const;
  template <class P>
  bool decide_hit(const P& probe) const;
  template <class P>
  std::optional<bool> certain_parity(detail::Twin<double> x, detail::Twin<double> y, detail::Twin<double> z,
                                     detail::Twin<double> heights, detail::Twin<double> reach) const;
  View view_of(const detail::RingRun& run, const detail::PlaneCrossing<double>& x, double range) const;

  Vec3<detail::Twin<double>> base_{{0, 0}, {0, 0}, {0, 0}},
      normal_{{0, 0}, {0, 0}, {0, 0}};       ///< a vertex, and the plane's normal, scaled, or zero
  double extent_ = 0;                        ///< the largest coordinate of the projected vertices
  int u_ = 0, v_ = 1;                        ///< the axes on which the polygon is projected
  detail::RingRun first_run_{};              ///< the rings, closed, one after the other, as seen from the base
  std::vector<detail::RingRun> other_runs_;  ///< the vertices beyond the first 64
  std::vector<double> flat_;                 ///< the coordinates that the runs view
  Covering covering_;
};

/// First the plane: a probe with both ends certainly on one side misses. If they certainly lie on different sides, the
/// point where the probe meets the plane decides, if its parity is certain. Else otherwise() does.
template <class Result, class P, class Otherwise>
[[gnu::always_inline]] inline Result FilteredPolygon::filtered(const P& probe, const Otherwise& otherwise) const {
  const Vec3<detail::Twin<double>> ends = detail::ends_from(base_, probe);
  const detail::Twin<double> reach = reach_of(ends), h = dot(normal_, ends);
  const detail::Twin<double> bound =
      reach * detail::twice(detail::crossing_bounds.height) + detail::twice(detail::crossing_bounds.tiny);
  if (!both_beyond(h, bound)) return otherwise();
  if (same_sign(h)) return false;
  if (const std::optional<bool> odd = certain_parity<P>(ends.x, ends.y, ends.z, h, reach)) return *odd;
  return otherwise();
}

/// The parity of the edges that a ray in the plane along the first axis crosses, from the point where the probe meets
/// the plane, if certain. Certain only in general position: no vertex at the height of the point, no edge through it.
/// There the parity is that of the covering's sum (docs/polygons.md).
template <class P>
[[gnu::noinline]] std::optional<bool> FilteredPolygon::certain_parity(detail::Twin<double> x, detail::Twin<double> y,
                                                                      detail::Twin<double> z,
                                                                      detail::Twin<double> heights,
                                                                      detail::Twin<double> reach) const {
  const double range = detail::crossing_range<P>(reach, extent_);
  if (!(range < detail::crossing_bounds.huge)) return std::nullopt;
  const detail::Twin<double> along[3] = {x, y, z};
  const detail::PlaneCrossing<double> at = plane_crossing<P>(heights, Vec2<detail::Twin<double>>{along[u_], along[v_]});
  bool certain = true, odd = false;
  const detail::RingRun* run = &first_run_;
  for (std::size_t others = 0;; run = &other_runs_[others++]) {
    const View view = view_of(*run, at, range);
    certain &= view.certain;
    odd ^= view.odd();
    if (others == other_runs_.size()) break;
  }
  if (!certain) return std::nullopt;
  return odd;
}

[[gnu::always_inline]] inline FilteredPolygon::View FilteredPolygon::view_of(const detail::RingRun& run,
                                                                             const detail::PlaneCrossing<double>& x,
                                                                             double range) const {
  const detail::Twin<double> den = detail::twice(x.den), point = detail::twice(x.point.v);
  detail::Twin<double> least = detail::twice(detail::crossing_bounds.huge);
  std::uint64_t below = 0;
  for (std::size_t i = run.size; i > 0;) {
    i -= 2;
    const detail::Twin<double> ahead = detail::Twin<double>{run.v[i], run.v[i + 1]} * den - point;
    below = below << 2 | negative_bits(ahead);
    least = smaller(magnitude(ahead), least);
  }
  const double vertex = detail::crossing_bounds.vertex * range + detail::crossing_bounds.tiny;
  const double edge = detail::crossing_bounds.edge * range * extent_ + detail::crossing_bounds.tiny;
  View view{both_beyond(least, detail::twice(vertex)), below, 0};
  for (std::uint64_t crossed = (below ^ below >> 1) & run.edges; crossed != 0; crossed &= crossed - 1) {
    const auto i = static_cast<std::size_t>(std::countr_zero(crossed));
    const double side = edge_side(x, {run.u[i], run.v[i]}, {run.u[i + 1], run.v[i + 1]});
    view.certain &= detail::magnitude(side) > edge;
    view.ahead |= std::uint64_t{(side > 0) == ((below >> i & 1) != 0)} << i;
  }
  return view;
}

}  // namespace tribunal
