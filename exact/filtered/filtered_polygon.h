// The certified polygon test: doubles decide where they are certain, whole coverings at once; else sign by sign.
#pragma once

#include <optional>
#include <vector>

#include "core/polygon.h"
#include "core/segura_feito_polygon.h"
#include "exact/filtered/shared_volumes.h"

namespace tribunal {

/// A polygon prepared for many probes. Views the polygon, which must outlive it and be finite.
///
/// Law: the answer is that of the covering test on exact numbers, always. Stage::filter: doubles told.
class FilteredPolygon {
 public:
  explicit FilteredPolygon(const Polygon& polygon);

  PolygonAnswer meet(const Segment& s) const;
  PolygonAnswer meet(const Ray& r) const;

  /// Whether they meet, and no more.
  template <class P>
  bool hits(const P& probe) const {
    const std::optional<bool> certain = filter_hits(probe);
    return certain ? *certain : meet(probe).answer.hit;
  }

  /// Whether the probe certainly hits or certainly misses; nothing where rounding could matter, where the probe meets
  /// the plane in a degenerate place, and where the polygon is not planar.
  template <class P>
  std::optional<bool> filter_hits(const P& probe) const;

 private:
  template <class P>
  PolygonAnswer decide(const P& probe) const;
  template <class P>
  std::optional<bool> certain_parity(const P& probe, const Vec3<double>& p, const Vec3<double>& d) const;

  Covering covering_;
  Vec3<double> lowest_{}, highest_{};  ///< on each axis, of all vertices
  Vec3<double> base_{}, normal_{};     ///< a vertex, and (b−a) × (c−a) of the plane's triangle as it rounds
  Vec3<double> reach_{};               ///< the largest magnitude on each axis of b−a and c−a
  int along_ = 2, i_ = 0, j_ = 1;      ///< the axis that runs most nearly in the plane, and the other two
  std::vector<Vec2<double>> flat_;     ///< the vertices without it
};

namespace filtered_polygon_detail {

/// From source to target.
inline Vec3<double> lead(const Segment& s) { return lift<double>(s.q) - lift<double>(s.p); }
inline Vec3<double> lead(const Ray& r) { return lift<double>(r.d.v); }

inline double at(const Vec3<double>& v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

}  // namespace filtered_polygon_detail

/// The plane first: both ends certainly on one side miss. Then the line, if they are certainly on two.
/// Bound: an arm times a normal of two arms is one determinant of rounded differences (filter_bounds.h).
template <class P>
std::optional<bool> FilteredPolygon::filter_hits(const P& probe) const {
  namespace detail = filtered_polygon_detail;
  if (!covering_.plane) return std::nullopt;
  const Vec3<double> p = lift<double>(source(probe));
  const Vec3<Twin<double>> arms = beside(p - base_, arm<double>(base_, target(probe)));
  const Vec3<Twin<double>> r = beside(reach_, reach_), n = beside(normal_, normal_);
  const Vec3<Twin<double>> both{larger_magnitude(r.x, arms.x), larger_magnitude(r.y, arms.y),
                                larger_magnitude(r.z, arms.z)};
  const Vec3<double> m{larger(first(both.x), second(both.x)), larger(first(both.y), second(both.y)),
                       larger(first(both.z), second(both.z))};
  const double bound = volume_bound(m, volume_filter);
  const Twin<double> heights = dot(n, arms);
  const double s = first(heights), t = second(heights);
  const bool certain = (magnitude(s) > bound) & (magnitude(t) > bound) & in_range(m, volume_filter);
  if (!certain) return std::nullopt;
  if ((s > 0) == (t > 0)) return false;
  return certain_parity(probe, p, detail::lead(probe));
}

/// The parity of the edges that a half-plane bounded by the probe's line crosses, if certain. The half-plane runs along
/// an axis; an edge crosses its plane iff that axis sees its ends on two sides of the line, and then the volume of edge
/// and line tells on which half. Certain only in general position: no vertex in the plane, no edge through the line.
/// There the parity is that of the covering's sum (docs/polygons.md).
template <class P>
std::optional<bool> FilteredPolygon::certain_parity(const P&, const Vec3<double>& p, const Vec3<double>& d) const {
  namespace detail = filtered_polygon_detail;
  const Vec3<double> m = largest(d, lowest_ - p, highest_ - p);
  if (!in_range(m, volume_filter)) return std::nullopt;
  const double p_u = detail::at(p, i_), p_v = detail::at(p, j_), d_u = detail::at(d, i_), d_v = detail::at(d, j_);
  const double volume = volume_bound(m, volume_filter);
  const auto side = [&](const Vec2<double>& v) { return (v.u - p_u) * d_v - (v.v - p_v) * d_u; };
  double least = area_filter.huge;
  bool inside = false;
  std::size_t begin = 0;
  for (const std::size_t end : covering_.polygon.ends) {
    std::size_t a = end - 1;
    double side_a = side(flat_[a]);
    for (std::size_t b = begin; b < end; ++b) {
      const double side_b = side(flat_[b]);
      least = smaller(magnitude(side_b), least);
      if ((side_a > 0) != (side_b > 0)) {
        const auto& v = covering_.polygon.vertices;
        const double edge = det3(lift<double>(v[a]) - p, lift<double>(v[b]) - p, d);
        if (!(magnitude(edge) > volume)) return std::nullopt;
        inside ^= (edge > 0) == (side_b > 0);
      }
      a = b;
      side_a = side_b;
    }
    begin = end;
  }
  const double area = area_filter.k * detail::at(m, i_) * detail::at(m, j_) + area_filter.tiny;
  if (!(least > area)) return std::nullopt;
  return inside;
}

}  // namespace tribunal
