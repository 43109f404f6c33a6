// The classical test of a polygon: intersect with its plane, project, ask whether the projected point is inside.
// Sources: inclusion by crossing count: Haines, "Point in polygon strategies", Graphics Gems IV, 1994; by signed
// triangles: Feito, Torres & Ureña, "Orientation, simplicity and inclusion test for
// planar polygons", Computers & Graphics 19(4), 1995.
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "core/covering.h"
#include "core/longest_axis.h"
#include "core/products.h"

namespace tribunal {

/// A polygon with its plane and its projection along the axis on which the plane's normal is longest, all rounded to N.
template <class N>
struct ClassicalPolygon {
  Polygon polygon;
  Vec3<N> normal;  ///< zero if all triangles of the covering are flat
  N height;        ///< normal · x for every point x of the plane
  Axis dropped;
  std::vector<Vec2<N>> flat;  ///< the vertices, projected
};

/// The normal is that of the largest triangle of the covering: the best that one cross product can do. (Newell's sum
/// over all of them would vanish on a bow-tie.)
template <class N>
ClassicalPolygon<N> classical_polygon(const Polygon& polygon) {
  ClassicalPolygon<N> c{polygon, {0, 0, 0}, 0, Axis::z, {}};
  const Vec3<N> o = lift<N>(polygon.vertices.front());
  for (std::size_t i = 1; i + 1 < polygon.vertices.size(); ++i) {
    const Vec3<N> n = cross(arm<N>(o, polygon.vertices[i]), arm<N>(o, polygon.vertices[i + 1]));
    if (dot(n, n) > dot(c.normal, c.normal)) c.normal = n;
  }
  c.height = dot(c.normal, o);
  c.dropped = longest_axis(c.normal);
  for (const Point3& v : polygon.vertices) c.flat.push_back(project(lift<N>(v), c.dropped));
  return c;
}

/// The point where the line p + t·d meets the plane, projected, and its t.
template <class N>
struct PlaneHit {
  N t;
  Vec2<N> x;
};

template <class N>
std::optional<PlaneHit<N>> plane_hit(const ClassicalPolygon<N>& c, const Vec3<N>& p, const Vec3<N>& d, N t_most) {
  const N slope = dot(c.normal, d);
  if (slope == 0) return std::nullopt;
  const N t = (c.height - dot(c.normal, p)) / slope;
  if (!(t >= 0 && t <= t_most)) return std::nullopt;
  return PlaneHit<N>{t, project(Vec3<N>{p.x + t * d.x, p.y + t * d.y, p.z + t * d.z}, c.dropped)};
}

template <class N>
std::optional<PlaneHit<N>> plane_hit(const ClassicalPolygon<N>& c, const Segment& s) {
  const Vec3<N> p = lift<N>(s.p);
  return plane_hit(c, p, arm<N>(p, s.q), N(1));
}

template <class N>
std::optional<PlaneHit<N>> plane_hit(const ClassicalPolygon<N>& c, const Ray& r) {
  return plane_hit(c, lift<N>(r.o), lift<N>(r.d.v), std::numeric_limits<N>::infinity());
}

/// Haines: whether the ray from x along the first axis crosses an odd number of edges. An edge contains its lower end
/// and not its upper one. A point on the boundary may come out either way.
template <class N>
bool inside_by_crossings(const ClassicalPolygon<N>& c, const Vec2<N>& x) {
  bool inside = false;
  std::size_t begin = 0;
  for (const std::size_t end : c.polygon.ends) {
    for (std::size_t i = begin, last = end - 1; i < end; last = i++) {
      const Vec2<N>&a = c.flat[last], &b = c.flat[i];
      if ((a.v > x.v) == (b.v > x.v)) continue;
      inside ^= x.u < a.u + (b.u - a.u) * (x.v - a.v) / (b.v - a.v);
    }
    begin = end;
  }
  return inside;
}

/// Feito: the signed count of the triangles (o, a, b) that hold x, those with x on an internal edge counted half; a
/// point on a ring edge is inside. Odd sums are inside, so the directions of the rings do not matter.
template <class N>
bool inside_by_signed_triangles(const ClassicalPolygon<N>& c, const Vec2<N>& x) {
  const auto flat = [&](const Point3& v) -> const Vec2<N>& { return c.flat[&v - c.polygon.vertices.data()]; };
  const auto side = [&](const Point3& a, const Point3& b) {
    const Vec2<N>&f = flat(a), &g = flat(b);
    return sign_of((f.u - x.u) * (g.v - x.v) - (f.v - x.v) * (g.u - x.u));
  };
  int sum = 0;
  bool boundary = false;
  detail::visit_passed(c.polygon, side, [&](const Point3& a, const Point3& b, const detail::Passage& passage) {
    const Vec2<N>&f = flat(a), &g = flat(b);
    const bool between = (f.u - x.u) * (g.u - x.u) + (f.v - x.v) * (g.v - x.v) <= 0;
    if (passage.edge_on()) return boundary = between;
    const detail::Location location = passage.location();
    sum += detail::halves(location, passage.direction());
    return boundary = location == detail::Location::vertex || location == detail::Location::external_edge;
  });
  return boundary || detail::is_odd(sum);
}

}  // namespace tribunal
