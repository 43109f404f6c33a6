// The covering of a polygon by triangles (o, pᵢ, pᵢ₊₁), and on which sides a line passes their edges.
// Source: Segura & Feito, "An algorithm for determining intersection segment-polygon in 3D", Computers & Graphics
// 22(5), 1998; Jiménez, Segura & Feito, "Optimizing ray-tracing for complex solids", figure 1.
#pragma once

#include <optional>

#include "core/coplanar.h"
#include "core/polygon.h"

namespace tribunal {

namespace detail {

/// Where the line of the probe pierces a covering triangle (o, a, b) of the ring edge ab. Internal edges are oa and
/// ob, which neighbouring triangles share.
enum class Location : std::uint8_t { vertex, external_edge, inside, internal_edge };

/// The sides on which a line passes the edges of (o, a, b).
struct Passage {
  Sign oa, ab, bo;

  /// The triangle is seen edge-on: the line lies in its plane, or it has no area and the line is coplanar with it.
  bool edge_on() const { return oa == Sign::zero && ab == Sign::zero && bo == Sign::zero; }

  /// The direction of crossing if the line pierces the closed triangle transversally, else zero. Three signs that
  /// agree weakly suffice: their volumes sum to that of the triangle's normal with the line, which thus is not zero.
  Sign direction() const {
    const bool positive = oa == Sign::positive || ab == Sign::positive || bo == Sign::positive;
    const bool negative = oa == Sign::negative || ab == Sign::negative || bo == Sign::negative;
    return positive == negative ? Sign::zero : positive ? Sign::positive : Sign::negative;
  }

  /// Where the line pierces the triangle. `direction()` must not be zero.
  Location location() const {
    const int internal = (oa == Sign::zero) + (bo == Sign::zero);
    if (ab == Sign::zero) return internal > 0 ? Location::vertex : Location::external_edge;
    return internal == 2 ? Location::vertex : internal == 1 ? Location::internal_edge : Location::inside;
  }
};

/// Twice what a crossing counts: 1 with the sign of its direction, or on an internal edge one half, since the neighbour
/// counts the other half.
constexpr int halves(Location l, Sign direction) { return (l == Location::internal_edge ? 1 : 2) * value(direction); }

/// Whether a sum of halves is an odd whole number.
constexpr bool is_odd(int halves) { return halves % 4 == 2 || halves % 4 == -2; }

/// Calls visit(a, b, passage) for each triangle of the covering that is pierced or seen edge-on, ring edge by ring
/// edge, until it returns true. `side(a, b)` says on which side of ab the probe's line passes in space, or a point
/// lies in the plane, so one loop serves both. Cost: one sign a vertex, two where the line passes between two spokes.
template <class Side, class Visit>
void visit_passed(const Polygon& polygon, const Side& side, const Visit& visit) {
  const Point3* const o = polygon.vertices.data();
  const auto spoke = [&](const Point3& v) { return &v == o ? Sign::zero : side(*o, v); };
  for (std::size_t r = 0; r < polygon.rings(); ++r) {
    const Ring ring = polygon.ring(r);
    if (ring.empty()) continue;
    const Point3* a = &ring.back();
    Sign oa = spoke(*a);
    for (const Point3& b : ring) {
      const Sign ob = spoke(b);
      if (oa * ob != Sign::positive) {
        const Passage passage{oa, a == o ? ob : &b == o ? -oa : side(*a, b), -ob};
        if ((passage.edge_on() || passage.direction() != Sign::zero) && visit(*a, b, passage)) return;
      }
      a = &b;
      oa = ob;
    }
  }
}

}  // namespace detail

/// The plane of a planar polygon: three vertices not on one line, and an axis along which it projects one-to-one.
struct Plane {
  Triangle triangle;
  Axis dropped;
};

/// What is computed of a polygon before any probe is known. It views the polygon, which must outlive it.
/// The covering itself needs no memory: triangle i is (o, pᵢ, pᵢ₊₁), o the first vertex of the first ring.
struct Covering {
  Polygon polygon;
  bool planar = true;            ///< all vertices lie in one plane
  std::optional<Plane> plane{};  ///< of a planar polygon, unless it lies on a line
  bool disjoint = false;         ///< planar, and no two triangles overlap: the first one pierced inside decides

  /// One ring of three vertices is its own covering.
  bool is_triangle() const { return polygon.rings() == 1 && polygon.vertices.size() == 3; }
  Triangle triangle() const { return {polygon.vertices[0], polygon.vertices[1], polygon.vertices[2]}; }
};

namespace detail {

/// Three vertices not on one line, or nothing if there are none.
template <Kernel K>
std::optional<Plane> spanned_plane(const Polygon& polygon, const K& k) {
  const Point3& o = polygon.vertices.front();
  const Point3* u = nullptr;
  for (const Point3& v : polygon.vertices) {
    if (u == nullptr) {
      if (lexicographic(o, v, k) != Sign::zero) u = &v;
      continue;
    }
    for (const Axis dropped : all_axes) {
      if (k.orient2d(dropped, o, *u, v) != Sign::zero) return Plane{{o, *u, v}, dropped};
    }
  }
  return std::nullopt;
}

template <Kernel K>
bool lies_in(const Polygon& polygon, const Plane& plane, const K& k) {
  const Triangle& t = plane.triangle;
  return std::all_of(polygon.vertices.begin(), polygon.vertices.end(),
                     [&](const Point3& v) { return k.orient3d(t.a, t.b, t.c, v) == Sign::zero; });
}

/// Whether the triangles of one planar ring are a triangulation: all turn the same way, and seen from o no vertex lies
/// half a turn or more beyond the first. Convex rings without further vertices on the lines of the two edges at o
/// qualify, and so do all other rings that are visible from o as a whole.
template <Kernel K>
bool is_fan(const Polygon& polygon, Axis dropped, const K& k) {
  if (polygon.rings() != 1) return false;
  const Ring v = polygon.ring(0);
  if (v.size() < 3) return false;
  const Sign turn = k.orient2d(dropped, v[0], v[1], v[2]);
  if (turn == Sign::zero) return false;
  for (std::size_t i = 2; i < v.size(); ++i) {
    if (k.orient2d(dropped, v[0], v[i - 1], v[i]) != turn || k.orient2d(dropped, v[0], v[1], v[i]) != turn)
      return false;
  }
  return true;
}

}  // namespace detail

/// Prepares a polygon for many probes. Cost: one volume and at most two areas a vertex.
/// Law: for an exact kernel, `planar` is exact.
template <Kernel K>
Covering cover(const Polygon& polygon, const K& k) {
  Covering c{.polygon = polygon};
  if (polygon.vertices.empty()) return c;
  c.plane = detail::spanned_plane(polygon, k);
  if (!c.plane) return c;
  c.planar = detail::lies_in(polygon, *c.plane, k);
  if (!c.planar) c.plane.reset();
  c.disjoint = c.planar && detail::is_fan(polygon, c.plane->dropped, k);
  return c;
}

}  // namespace tribunal
