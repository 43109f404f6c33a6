// Oracles for a segment or ray against a polygon: exact coordinates of the point where the plane is met, not signs of
// volumes. They share the number type and the vocabulary with the test that they judge, and no formula.
#pragma once

#include <optional>

#include "core/polygon.h"
#include "exact/oracles/caratheodory.h"
#include "exact/oracles/point_in_rings.h"

namespace tribunal {

namespace polygon_oracle_detail {

template <class N>
Vec3<N> cross_product(const Vec3<N>& u, const Vec3<N>& v) {
  return {N(u.y * v.z - u.z * v.y), N(u.z * v.x - u.x * v.z), N(u.x * v.y - u.y * v.x)};
}

template <class N>
N inner(const Vec3<N>& u, const Vec3<N>& v) {
  return N(u.x * v.x + u.y * v.y + u.z * v.z);
}

template <class N>
bool vanishes(const Vec3<N>& u) {
  return sign_of(u.x) == Sign::zero && sign_of(u.y) == Sign::zero && sign_of(u.z) == Sign::zero;
}

/// The points p + t·d, t ≥ 0, up to t = 1 if it `ends`.
template <class N>
struct Line {
  Vec3<N> p, d;
  bool ends;
};

template <class N>
Line<N> line_of(const Segment& s) {
  return {lift<N>(s.p), lift<N>(s.q) - lift<N>(s.p), true};
}

template <class N>
Line<N> line_of(const Ray& r) {
  return {lift<N>(r.o), lift<N>(r.d.v), false};
}

/// A point (x, y, z)/w with w > 0.
template <class N>
struct Homogeneous {
  Vec3<N> x;
  N w;
};

/// Where the probe meets the plane through `at` with normal n, if it crosses it: t = n·(at − p) / n·d.
template <class N>
std::optional<Homogeneous<N>> crossing(const Line<N>& l, const Vec3<N>& at, const Vec3<N>& n) {
  N num = inner(n, at - l.p), den = inner(n, l.d);
  if (sign_of(den) == Sign::zero) return std::nullopt;
  if (sign_of(den) == Sign::negative) num = N(0) - num, den = N(0) - den;
  const N beyond = num - den;
  if (sign_of(num) == Sign::negative || (l.ends && sign_of(beyond) == Sign::positive)) return std::nullopt;
  return Homogeneous<N>{{N(l.p.x * den + l.d.x * num), N(l.p.y * den + l.d.y * num), N(l.p.z * den + l.d.z * num)},
                        den};
}

/// The vertex minus the point x, times w.
template <class N>
Vec3<N> seen_from(const Homogeneous<N>& x, const Point3& vertex) {
  const Vec3<N> v = lift<N>(vertex);
  return Vec3<N>{N(v.x * x.w), N(v.y * x.w), N(v.z * x.w)} - x.x;
}

template <class N>
std::vector<SeenEdge<N>> seen_edges(const Polygon& polygon, const Homogeneous<N>& x, Axis dropped) {
  std::vector<SeenEdge<N>> edges;
  for (std::size_t r = 0; r < polygon.rings(); ++r) {
    const Ring ring = polygon.ring(r);
    for (std::size_t i = 0; i < ring.size(); ++i) {
      edges.push_back(
          {project(seen_from(x, ring[i]), dropped), project(seen_from(x, ring[(i + 1) % ring.size()]), dropped)});
    }
  }
  return edges;
}

template <class N, class P>
bool meets_boundary(const P& probe, const Polygon& polygon) {
  for (std::size_t r = 0; r < polygon.rings(); ++r) {
    const Ring ring = polygon.ring(r);
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point3& a = ring[i];
      const Point3& b = ring[(i + 1) % ring.size()];
      if (meets_by_caratheodory<N>(probe, Triangle{a, b, b})) return true;
    }
  }
  return false;
}

/// A normal of three vertices not on one line; zero if there are none.
template <class N>
Vec3<N> normal_of(const Polygon& polygon) {
  const Vec3<N> o = lift<N>(polygon.vertices.front());
  Vec3<N> arm = o - o;
  for (const Point3& v : polygon.vertices) {
    const Vec3<N> to = lift<N>(v) - o;
    const Vec3<N> n = cross_product(arm, to);
    if (!vanishes(n)) return n;
    if (vanishes(arm)) arm = to;
  }
  return o - o;
}

template <class N>
Axis axis_across(const Vec3<N>& n) {
  return sign_of(n.x) != Sign::zero ? Axis::x : sign_of(n.y) != Sign::zero ? Axis::y : Axis::z;
}

}  // namespace polygon_oracle_detail

/// Whether all vertices lie in one plane. N must be exact for the operands, here and below; polygons have a vertex.
template <class N>
bool is_planar_by_normal(const Polygon& polygon) {
  namespace detail = polygon_oracle_detail;
  const Vec3<N> n = detail::normal_of<N>(polygon), o = lift<N>(polygon.vertices.front());
  for (const Point3& v : polygon.vertices) {
    const N height = detail::inner(n, lift<N>(v) - o);
    if (sign_of(height) != Sign::zero) return false;
  }
  return true;
}

/// The edges of a planar polygon as seen from the point where the probe meets its plane, or from the probe's source if
/// the probe lies in the plane. Nothing if it misses the plane, or if all vertices lie on a line.
template <class N, class P>
std::optional<std::vector<SeenEdge<N>>> seen_from_plane(const P& probe, const Polygon& polygon) {
  namespace detail = polygon_oracle_detail;
  const Vec3<N> n = detail::normal_of<N>(polygon), o = lift<N>(polygon.vertices.front());
  if (detail::vanishes(n)) return std::nullopt;
  const detail::Line<N> line = detail::line_of<N>(probe);
  const N height = detail::inner(n, line.p - o), slope = detail::inner(n, line.d);
  const bool in_plane = sign_of(height) == Sign::zero && sign_of(slope) == Sign::zero;
  const auto x = in_plane ? detail::Homogeneous<N>{line.p, N(1)} : detail::crossing(line, o, n);
  if (!x) return std::nullopt;
  return detail::seen_edges(polygon, *x, detail::axis_across(n));
}

/// Twice the signed number of covering triangles that the probe crosses, each by the barycentric coordinates of the
/// point where it meets the triangle's plane: on an internal edge half. The probe must meet no ring edge.
template <class N, class P>
int surface_halves(const P& probe, const Polygon& polygon) {
  namespace detail = polygon_oracle_detail;
  const detail::Line<N> line = detail::line_of<N>(probe);
  const Point3& o = polygon.vertices.front();
  int halves = 0;
  for (std::size_t r = 0; r < polygon.rings(); ++r) {
    const Ring ring = polygon.ring(r);
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point3 &a = ring[i], &b = ring[(i + 1) % ring.size()];
      const Vec3<N> n = detail::cross_product(lift<N>(a) - lift<N>(o), lift<N>(b) - lift<N>(o));
      const auto x = detail::crossing(line, lift<N>(o), n);
      if (!x) continue;
      const Vec3<N> to_o = detail::seen_from(*x, o), to_a = detail::seen_from(*x, a), to_b = detail::seen_from(*x, b);
      const N of_o = detail::inner(n, detail::cross_product(to_a, to_b));
      const N of_a = detail::inner(n, detail::cross_product(to_b, to_o));
      const N of_b = detail::inner(n, detail::cross_product(to_o, to_a));
      if (value(sign_of(of_o)) < 0 || value(sign_of(of_a)) < 0 || value(sign_of(of_b)) < 0) continue;
      const bool on_spoke = sign_of(of_a) == Sign::zero || sign_of(of_b) == Sign::zero;
      const N slope = detail::inner(n, line.d);
      halves += (on_spoke ? 1 : 2) * value(sign_of(slope));
    }
  }
  return halves;
}

/// The answers of the oracles to a probe and a polygon.
struct PolygonVerdicts {
  bool planar;
  bool boundary;  ///< a ring edge is met, by Carathéodory: then the probe meets the polygon, and no other oracle is
                  ///< asked
  /// For a planar polygon: whether the point where the probe meets the plane lies inside, on no ring edge.
  bool by_generic_ray = false, by_half_open_crossings = false;
  int surface_halves = 0;  ///< 2 modulo 4: the covering surface is crossed an odd number of times
};

template <class N, class P>
PolygonVerdicts ask_oracles(const P& probe, const Polygon& polygon) {
  PolygonVerdicts v{is_planar_by_normal<N>(polygon), polygon_oracle_detail::meets_boundary<N>(probe, polygon)};
  if (v.boundary) return v;
  v.surface_halves = surface_halves<N>(probe, polygon);
  if (!v.planar) return v;
  if (const auto edges = seen_from_plane<N>(probe, polygon)) {
    v.by_generic_ray = inside_by_generic_ray(*edges);
    v.by_half_open_crossings = inside_by_half_open_crossings(*edges);
  }
  return v;
}

}  // namespace tribunal
