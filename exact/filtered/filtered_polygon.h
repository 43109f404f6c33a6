// The certified polygon test: doubles decide where they are certain, whole polygons at once; else sign by sign.
#pragma once

#include <bit>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/polygon.h"
#include "core/segura_feito_polygon.h"
#include "exact/filtered/plane_crossing.h"

namespace tribunal {

/// A polygon prepared for many probes. Views the polygon, which must outlive it and be finite.
///
/// Law: the answer is that of the covering test on exact numbers, always. Stage::filter: doubles told.
class FilteredPolygon {
 public:
  explicit FilteredPolygon(const Polygon& polygon);

  PolygonAnswer meet(const Segment& s) const;
  PolygonAnswer meet(const Ray& r) const;

  /// Whether they meet, and no more. Some 10 ns where doubles tell.
  template <class P>
  bool hits(const P& probe) const {
    const std::optional<bool> certain = filter_hits(probe);
    return certain ? *certain : hits_exactly(probe);
  }

  /// Whether the probe certainly hits or certainly misses; nothing where rounding could matter, where the probe meets
  /// the plane in a degenerate place, and where the polygon is not planar.
  template <class P>
  std::optional<bool> filter_hits(const P& probe) const;

 private:
  /// Up to 64 vertices in a row; bit i of `edges` is set if a ring edge leads from vertex i to the next.
  struct Run {
    const double *u, *v;
    std::uint32_t size;  ///< even
    std::uint64_t edges;
  };

  void prepare_filter();
  void flatten();
  bool hits_exactly(const Segment& s) const;
  bool hits_exactly(const Ray& r) const;
  template <class P>
  PolygonAnswer decide(const P& probe) const;
  template <class P>
  PolygonAnswer decide_exactly(const P& probe) const;
  template <class P>
  std::optional<bool> certain_parity(const Vec3<Twin<double>>& ends, const Twin<double>& heights,
                                     const Twin<double>& reach) const;
  static std::optional<bool> run_parity(const Run& run, const PlaneCrossing<double>& x, double range, double extent);

  Vec3<double> base_{}, normal_{};  ///< a vertex, and the plane's normal, scaled; zero where nothing is certain
  double extent_ = 0;               ///< the largest coordinate of the projected vertices
  int u_ = 0, v_ = 1;               ///< the axes on which the polygon is projected
  std::vector<Run> runs_;           ///< the rings, closed, one after the other, as seen from the base
  std::vector<double> flat_;        ///< what they point to
  Covering covering_;
};

/// The plane first: both ends certainly on one side miss. Then the point, if they are certainly on two.
template <class P>
std::optional<bool> FilteredPolygon::filter_hits(const P& probe) const {
  const Vec3<Twin<double>> ends = ends_from(base_, probe);
  const Twin<double> reach = reach_of(ends), h = heights(normal_, ends);
  const double k = crossing_bounds.height, tiny = crossing_bounds.tiny;
  if (!both_beyond(h, reach * Twin<double>{k, k} + Twin<double>{tiny, tiny})) return std::nullopt;
  const unsigned below = negative_bits(h);
  if (below == 0 || below == 3) return false;
  return certain_parity<P>(ends, h, reach);
}

/// The parity of the edges that are crossed from the point where the probe meets the plane along the first axis, if
/// certain. Certain only in general position: no vertex at the height of the point, no edge through it. There the
/// parity is that of the covering's sum (docs/polygons.md).
template <class P>
std::optional<bool> FilteredPolygon::certain_parity(const Vec3<Twin<double>>& ends, const Twin<double>& heights,
                                                    const Twin<double>& reach) const {
  const double range = crossing_range<P>(reach, extent_);
  if (!(range < crossing_bounds.huge)) return std::nullopt;
  const Twin<double> along[3] = {ends.x, ends.y, ends.z};
  const PlaneCrossing<double> x = plane_crossing<P>(heights, Vec2<Twin<double>>{along[u_], along[v_]});
  bool inside = false;
  for (const Run& run : runs_) {
    const std::optional<bool> odd = run_parity(run, x, range, extent_);
    if (!odd) return std::nullopt;
    inside ^= *odd;
  }
  return inside;
}

inline std::optional<bool> FilteredPolygon::run_parity(const Run& run, const PlaneCrossing<double>& x, double range,
                                                       double extent) {
  const Twin<double> den{x.den, x.den}, point{x.point.v, x.point.v};
  Twin<double> least{crossing_bounds.huge, crossing_bounds.huge};
  std::uint64_t below = 0;
  for (std::uint32_t i = 0; i < run.size; i += 2) {
    const Twin<double> ahead = Twin<double>{run.v[i], run.v[i + 1]} * den - point;
    below |= std::uint64_t{negative_bits(ahead)} << i;
    least = smaller_magnitude(ahead, least);
  }
  const double vertex = crossing_bounds.vertex * range + crossing_bounds.tiny;
  const double edge = crossing_bounds.edge * range * extent + crossing_bounds.tiny;
  bool certain = both_beyond(least, Twin<double>{vertex, vertex}), odd = false;
  for (std::uint64_t crossed = (below ^ below >> 1) & run.edges; crossed != 0; crossed &= crossed - 1) {
    const int i = std::countr_zero(crossed);
    const double side = edge_side(x, {run.u[i], run.v[i]}, {run.u[i + 1], run.v[i + 1]});
    certain &= magnitude(side) > edge;
    odd ^= (side > 0) == ((below >> i & 1) != 0);
  }
  if (!certain) return std::nullopt;
  return odd;
}

}  // namespace tribunal
