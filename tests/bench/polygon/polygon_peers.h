// What the covering test is measured against: CGAL's triangulation with its triangle test; and, since the library's
// rivals are written to be read, the crossing count and the covering in double as a careful programmer tunes them.
#pragma once

#include <bit>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/classical_polygon.h"
#include "exact/filtered/plane_crossing.h"

namespace tribunal::bench {

using namespace detail;  // what the peers are tuned with is the filter's own

/// A constrained Delaunay triangulation of a planar polygon by exact predicates (CGAL, GPL: never part of the library),
/// asked triangle by triangle with EPICK. Peer for simple polygons: rings that neither touch nor cross.
class TriangulatedPolygon {
 public:
  explicit TriangulatedPolygon(const Polygon& polygon);
  TriangulatedPolygon(TriangulatedPolygon&&) noexcept;
  ~TriangulatedPolygon();

  bool meets(const Segment& s) const;
  std::size_t triangles() const;

 private:
  struct Triangles;
  std::unique_ptr<const Triangles> triangles_;
};

/// The crossing count as a careful programmer tunes it, uncertified: heights of both ends before any division, and no
/// division per edge (the multiplying form of Haines 1994).
inline bool meets_tuned(const ClassicalPolygon<double>& c, const Segment& s) {
  const Vec3<double> p = lift<double>(s.p), q = lift<double>(s.q);
  const double below = dot(c.normal, p) - c.height, above = dot(c.normal, q) - c.height;
  if ((below > 0) == (above > 0)) return false;
  const double t = below / (below - above);
  const Vec2<double> x =
      project(Vec3<double>{p.x + t * (q.x - p.x), p.y + t * (q.y - p.y), p.z + t * (q.z - p.z)}, c.dropped);
  bool inside = false;
  std::size_t begin = 0;
  for (const std::size_t end : c.polygon.ends) {
    const Vec2<double>* a = &c.flat[end - 1];
    bool a_above = a->v > x.v;
    for (std::size_t i = begin; i < end; ++i) {
      const Vec2<double>* b = &c.flat[i];
      const bool b_above = b->v > x.v;
      if (a_above != b_above) {
        inside ^= ((b->u - a->u) * (x.v - a->v) > (b->v - a->v) * (x.u - a->u)) == b_above;
        a_above = b_above;
      }
      a = b;
    }
    begin = end;
  }
  return inside;
}

/// A covering prepared in double: its triangles' normals are all multiples of the plane's.
struct TunedCovering {
  Vec3<double> base, normal;
  std::vector<Vec3<double>> arms;  ///< of every ring, closed
  std::vector<double> weights;     ///< weights[i]·normal = arms[i] × arms[i+1]; 0 from one ring to the next
};

inline TunedCovering tuned_covering(const Polygon& polygon) {
  TunedCovering c{lift<double>(polygon.vertices.front()), classical_polygon<double>(polygon).normal, {}, {}};
  for (std::size_t r = 0; r < polygon.rings(); ++r) {
    for (const Point3& v : polygon.ring(r)) {
      c.arms.push_back(arm(c.base, v));
      c.weights.push_back(1);
    }
    c.arms.push_back(arm(c.base, polygon.ring(r).front()));
    c.weights.push_back(0);
  }
  for (std::size_t i = 0; i + 1 < c.arms.size(); ++i) {
    c.weights[i] *= dot(cross(c.arms[i], c.arms[i + 1]), c.normal) / dot(c.normal, c.normal);
  }
  return c;
}

/// The paper's test by signed volumes alone, uncertified, for probes in general position. With w and z the ends seen
/// from o: side(o, v) = (v − o)·(w × z), and side(a, b) is what is missing to the volume of the triangle's normal with
/// the line, weight·(height of z − height of w).
inline bool meets_tuned(const TunedCovering& c, const Segment& s) {
  const Vec3<double> w = arm(c.base, s.p), z = arm(c.base, s.q);
  const double below = dot(c.normal, w), above = dot(c.normal, z);
  if ((below > 0) == (above > 0)) return false;
  const Vec3<double> moment = cross(w, z);
  bool odd = false;
  double oa = dot(c.arms[0], moment);
  for (std::size_t i = 0; i + 1 < c.arms.size(); ++i) {
    const double ob = dot(c.arms[i + 1], moment);
    if ((oa > 0) != (ob > 0) && c.weights[i] != 0) {
      const double ab = c.weights[i] * (above - below) - oa + ob;
      odd ^= (ab > 0) == (oa > 0);
    }
    oa = ob;
  }
  return odd;
}

/// What sf-filtered computes, without its bounds: what certainty costs. Up to 64 vertices, each ring closed.
struct UncertifiedPolygon {
  Vec3<Twin<double>> base, normal;
  int u_axis, v_axis;
  std::vector<double> u, v;
  std::uint64_t edges = 0;
};

inline UncertifiedPolygon uncertified(const Polygon& polygon) {
  const ClassicalPolygon<double> c = classical_polygon<double>(polygon);
  const Vec3<double> base = lift<double>(polygon.vertices.front());
  const int dropped = static_cast<int>(c.dropped);
  UncertifiedPolygon p{beside(base, base), beside(c.normal, c.normal), (dropped + 1) % 3, (dropped + 2) % 3, {}, {}};
  const auto add = [&](const Point3& vertex) {
    p.u.push_back(vertex[p.u_axis] - polygon.vertices.front()[p.u_axis]);
    p.v.push_back(vertex[p.v_axis] - polygon.vertices.front()[p.v_axis]);
  };
  for (std::size_t r = 0; r < polygon.rings(); ++r) {
    for (const Point3& vertex : polygon.ring(r)) {
      p.edges |= std::uint64_t{1} << p.u.size();
      add(vertex);
    }
    add(polygon.ring(r).front());
  }
  if (p.u.size() % 2 == 1) add(polygon.vertices.back());
  return p;
}

[[gnu::noinline]] inline bool crossed_oddly(const UncertifiedPolygon& polygon, Twin<double> x, Twin<double> y,
                                            Twin<double> z, Twin<double> heights) {
  const Twin<double> along[3] = {x, y, z};
  const auto at = plane_crossing<Segment>(heights, Vec2<Twin<double>>{along[polygon.u_axis], along[polygon.v_axis]});
  const double *const u = polygon.u.data(), *const v = polygon.v.data();
  std::uint64_t below = 0;
  for (std::size_t i = polygon.u.size(); i > 0;) {
    i -= 2;
    below = below << 2 | negative_bits(Twin<double>{v[i], v[i + 1]} * twice(at.den) - twice(at.point.v));
  }
  bool odd = false;
  for (std::uint64_t crossed = (below ^ below >> 1) & polygon.edges; crossed != 0; crossed &= crossed - 1) {
    const auto i = static_cast<std::size_t>(std::countr_zero(crossed));
    const double side = edge_side(at, {u[i], v[i]}, {u[i + 1], v[i + 1]});
    odd ^= (side > 0) == ((below >> i & 1) != 0);
  }
  return odd;
}

inline bool meets_uncertified(const UncertifiedPolygon& polygon, const Segment& s) {
  const Vec3<Twin<double>> ends = ends_from(polygon.base, s);
  const Twin<double> heights = dot(polygon.normal, ends);
  return !same_sign(heights) && crossed_oddly(polygon, ends.x, ends.y, ends.z, heights);
}

}  // namespace tribunal::bench
