// What the covering test is measured against: CGAL's triangulation with its triangle test, and Haines's test by hand.
#pragma once

#include <memory>
#include <vector>

#include "core/classical_polygon.h"

namespace tribunal::bench {

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

}  // namespace tribunal::bench
