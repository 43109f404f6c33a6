// The Segura–Feito test of a segment or ray against a polygon with holes, by signs alone.
// Source: Segura & Feito, "An algorithm for determining intersection segment-polygon in 3D", Computers & Graphics
// 22(5), 1998; Jiménez, Segura & Feito, "Optimizing ray-tracing for complex solids", figure 1; for probes in the
// polygon's plane: Feito, Torres & Ureña, "Orientation, simplicity and inclusion test for planar polygons", Computers &
// Graphics 19(4), 1995. The published test leaves out probes in the plane and triangles without area.
#pragma once

#include "core/covering.h"
#include "core/segura_feito.h"

namespace tribunal {

namespace detail {

/// The sides of a plane on which the probe's ends lie.
struct PlaneSides {
  Sign source, target;

  bool in_plane() const { return source == Sign::zero && target == Sign::zero; }
  At at() const { return source == Sign::zero ? At::source : target == Sign::zero ? At::target : At::between; }
};

template <Kernel K, class P>
PlaneSides sides_of(const Triangle& t, const P& probe, const K& k) {
  return {k.orient3d(t.a, t.b, t.c, source(probe)), k.orient3d(t.a, t.b, t.c, target(probe))};
}

/// What a probe meets in a covering.
struct Crossings {
  int halves = 0;           ///< twice the signed sum of crossings
  bool boundary = false;    ///< a ring edge or ring vertex is met; the other numbers are then incomplete
  std::size_t edge_on = 0;  ///< triangles seen edge-on; if all are, the probe may lie in the polygon's plane
  bool one_place = true;    ///< all crossings agree on `at`
  At at = At::unsaid;

  bool hit() const { return boundary || is_odd(halves); }

  void add(const Passage& passage, At where) {
    one_place = one_place && (at == At::unsaid || at == where);
    at = where;
    halves += detail::halves(passage.location(), passage.direction());
  }
};

template <Kernel K, class P>
bool meets_ring_edge(const P& probe, const Point3& a, const Point3& b, const K& k) {
  return lexicographic(a, b, k) == Sign::negative ? meets_segment(probe, b, a, k) : meets_segment(probe, a, b, k);
}

/// Figure 1 of Jiménez et al.: the signed sum of crossings. `sides(a, b)` gives the sides of the plane of (o, a, b) on
/// which the probe's ends lie. A triangle seen edge-on counts nothing itself, but its ring edge may still be met.
template <Kernel K, class P, class SidesOf>
Crossings crossings(const P& probe, const Covering& c, const SidesOf& sides, const K& k) {
  Crossings sum;
  const auto side = [&](const Point3& a, const Point3& b) { return k.orient3d(source(probe), a, b, target(probe)); };
  visit_passed(c.polygon, side, [&](const Point3& a, const Point3& b, const Passage& passage) {
    if (passage.edge_on()) {
      ++sum.edge_on;
      return sum.boundary = meets_ring_edge(probe, a, b, k);
    }
    const PlaneSides s = sides(a, b);
    if (s.in_plane() || !reaches(s.source, s.target, target(probe))) return false;
    const Location location = passage.location();
    if (location == Location::vertex || location == Location::external_edge) return sum.boundary = true;
    sum.add(passage, s.at());
    return c.disjoint && location == Location::inside;
  });
  return sum;
}

/// Feito's inclusion test: a point in the polygon's plane, on no ring edge, is inside iff its signed count is odd.
template <Kernel K>
bool is_inside(const Point3& x, const Polygon& polygon, Axis dropped, const K& k) {
  int sum = 0;
  const auto side = [&](const Point3& a, const Point3& b) { return k.orient2d(dropped, a, b, x); };
  visit_passed(polygon, side, [&](const Point3&, const Point3&, const Passage& passage) {
    sum += halves(passage.location(), passage.direction());
    return false;
  });
  return is_odd(sum);
}

/// Whether visit(a, b) holds for some ring edge ab.
template <class Visit>
bool any_ring_edge(const Polygon& polygon, const Visit& visit) {
  for (std::size_t r = 0; r < polygon.rings(); ++r) {
    const Ring ring = polygon.ring(r);
    for (std::size_t i = 0; i < ring.size(); ++i) {
      if (visit(ring[i], ring[i + 1 == ring.size() ? 0 : i + 1])) return true;
    }
  }
  return false;
}

/// Probe in the plane of the polygon: it meets a ring edge, or lies inside as a whole.
template <Kernel K, class P>
bool meets_in_plane(const P& probe, const Polygon& polygon, Axis dropped, const K& k) {
  const auto met = [&](const Point3& a, const Point3& b) { return meets_edge(dropped, probe, a, b, k); };
  return any_ring_edge(polygon, met) || is_inside(source(probe), polygon, dropped, k);
}

/// The kind of a contact with the boundary by a probe that is not in the polygon's plane.
template <Kernel K, class P>
Contact boundary_contact(const P& probe, const Polygon& polygon, const K& k) {
  const bool vertex = std::any_of(polygon.vertices.begin(), polygon.vertices.end(),
                                  [&](const Point3& v) { return meets_segment(probe, v, v, k); });
  return vertex ? Contact::vertex : Contact::edge;
}

template <Kernel K, class P>
Answer answer_of(const Crossings& sum, const P& probe, const Polygon& polygon, At boundary_at, const K& k) {
  if (sum.boundary) return hit_at(boundary_contact(probe, polygon, k), boundary_at);
  return sum.hit() ? hit_at(Contact::interior, sum.one_place ? sum.at : At::unsaid) : miss();
}

/// The crossings where all triangles lie in one plane; `sides` are the sides of it on which the probe's ends lie.
template <Kernel K, class P>
Crossings plane_crossings(const P& probe, const Covering& c, const PlaneSides& sides, const K& k) {
  return crossings(
      probe, c, [&](const Point3&, const Point3&) { return sides; }, k);
}

/// A polygon in one plane: the plane is asked first, once, and then the line alone decides.
template <Kernel K, class P>
Answer meet_planar(const P& probe, const Covering& c, const K& k) {
  const PlaneSides s = sides_of(c.plane->triangle, probe, k);
  if (s.in_plane()) {
    return meets_in_plane(probe, c.polygon, c.plane->dropped, k) ? hit_at(Contact::coplanar) : miss();
  }
  if (!reaches(s.source, s.target, target(probe))) return miss();
  return answer_of(plane_crossings(probe, c, s, k), probe, c.polygon, s.at(), k);
}

/// The crossings where each triangle has a plane of its own.
template <Kernel K, class P>
Crossings surface_crossings(const P& probe, const Covering& c, const K& k) {
  const Point3& o = c.polygon.vertices.front();
  return crossings(
      probe, c,
      [&](const Point3& a, const Point3& b) {
        return sides_of({o, a, b}, probe, k);
      },
      k);
}

/// The answer about a triangle that is a polygon: a polygon has no front.
constexpr Answer of_polygon(Answer answer) {
  answer.facing = Facing::unsaid;
  return answer;
}

}  // namespace detail

/// Decides whether the probe meets the prepared polygon.
///
/// Law: for an exact kernel and a planar polygon, hit ⇔ the point sets meet. If it is not planar, hit ⇔ a ring edge is
/// met or the signed sum of crossings is an odd whole number; a probe in the plane of one triangle, crossing another
/// on the edge they share, counts half, which is not odd.
/// Contact: `coplanar` iff planar and the probe lies in the plane; `vertex` iff else the probe meets a ring vertex,
/// `edge` iff else a ring edge. `at` is said where one point is met, or several that agree on it. If all vertices
/// lie on one line, every contact is coplanar.
template <Kernel K, class P>
Answer segura_feito(const P& probe, const Covering& c, const K& k) {
  if (c.is_triangle()) return detail::of_polygon(segura_feito(probe, c.triangle(), k));
  if (c.plane) return detail::meet_planar(probe, c, k);
  if (c.polygon.vertices.empty()) return miss();
  const detail::Crossings sum = detail::surface_crossings(probe, c, k);
  if (c.planar) return sum.boundary ? hit_at(Contact::coplanar) : miss();
  Answer answer = detail::answer_of(sum, probe, c.polygon, At::unsaid, k);
  answer.planar = false;
  return answer;
}

/// The same without preparation: no plane is sought. Only if a ring edge is met, or all triangles are seen edge-on, is
/// the polygon prepared after all. For an exact kernel the answer is that of the prepared form, except that `planar`
/// may be true of a polygon that is not.
template <Kernel K, class P>
Answer segura_feito(const P& probe, const Polygon& polygon, const K& k) {
  const Covering unprepared{.polygon = polygon};
  if (unprepared.is_triangle()) return detail::of_polygon(segura_feito(probe, unprepared.triangle(), k));
  if (polygon.vertices.empty()) return miss();
  const detail::Crossings sum = detail::surface_crossings(probe, unprepared, k);
  if (sum.boundary || sum.edge_on == polygon.vertices.size()) return segura_feito(probe, cover(polygon, k), k);
  return detail::answer_of(sum, probe, polygon, At::unsaid, k);
}

}  // namespace tribunal
