// Bugs in the polygon test: its covering, its count, its planes.
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "core/segura_feito_polygon.h"
#include "exact/kernels/cgal_kernels.h"
#include "exact/kernels/naive.h"
#include "tests/planted/bugs.h"

namespace tribunal::planted {
namespace {

const EpickKernel k;

PolygonAnswer right(const Probe& probe, const Polygon& polygon) {
  return std::visit([&](const auto& p) { return segura_feito(p, cover(polygon, k), k); }, probe);
}

/// The right answer by a covering that was spoilt.
template <class Spoil>
PolygonAnswer by_covering(const Probe& probe, const Polygon& polygon, const Spoil& spoil) {
  Covering c = cover(polygon, k);
  const bool planar = c.planar;
  spoil(c);
  PolygonAnswer answer = std::visit([&](const auto& p) { return segura_feito(p, c, k); }, probe);
  answer.planar = planar;
  return answer;
}

PolygonAnswer stops_early(const Probe& probe, const Polygon& polygon) {
  return by_covering(probe, polygon, [](Covering& c) { c.disjoint = c.planar; });
}

PolygonAnswer projects_to_xy(const Probe& probe, const Polygon& polygon) {
  return by_covering(probe, polygon, [](Covering& c) {
    if (c.plane) c.plane->dropped = Axis::z;
  });
}

PolygonAnswer one_plane_for_all(const Probe& probe, const Polygon& polygon) {
  return by_covering(probe, polygon, [](Covering& c) { c.plane = spanned_plane(c.polygon, k); });
}

/// The signed count of a planar polygon with another weight for what is passed; boundary and plane answered rightly.
template <class Weight>
PolygonAnswer weighed(const Probe& probe, const Polygon& polygon, const Weight& weight, bool as_line = false) {
  PolygonAnswer answer = right(probe, polygon);
  const auto* s = std::get_if<Segment>(&probe);
  const Covering c = cover(polygon, k);
  if (s == nullptr || !c.plane || (answer.answer.hit && answer.answer.contact != Contact::interior)) return answer;
  const PlaneSides sides = sides_of(c.plane->triangle, *s, k);
  if (sides.in_plane() || (!as_line && !reaches(sides.source, sides.target, s->q))) return answer;
  int sum = 0;
  const auto side = [&](const Point3& a, const Point3& b) { return k.orient3d(s->p, a, b, s->q); };
  visit_passed(polygon, side, [&](const Point3&, const Point3&, const Passage& passage) {
    sum += weight(passage);
    return false;
  });
  answer.answer.hit = is_odd(sum);
  return answer;
}

int due(const Passage& p) { return halves(p.location(), p.direction()); }

PolygonAnswer spokes_whole(const Probe& probe, const Polygon& polygon) {
  return weighed(probe, polygon, [](const Passage& p) { return 2 * value(p.direction()); });
}

PolygonAnswer spokes_not_counted(const Probe& probe, const Polygon& polygon) {
  return weighed(probe, polygon, [](const Passage& p) { return p.location() == Location::internal_edge ? 0 : due(p); });
}

PolygonAnswer undirected(const Probe& probe, const Polygon& polygon) {
  return weighed(probe, polygon, [](const Passage& p) { return std::abs(due(p)); });
}

PolygonAnswer flat_counted(const Probe& probe, const Polygon& polygon) {
  return weighed(probe, polygon, [](const Passage& p) { return p.edge_on() ? 1 : due(p); });
}

PolygonAnswer segment_as_line(const Probe& probe, const Polygon& polygon) { return weighed(probe, polygon, due, true); }

/// The polygon of the first `rings` rings.
Polygon first_rings(const Polygon& polygon, std::size_t rings) {
  const std::size_t size = polygon.ends[rings - 1];
  return {polygon.vertices.first(size), polygon.ends.first(rings)};
}

PolygonAnswer holes_forgotten(const Probe& probe, const Polygon& polygon) {
  PolygonAnswer answer = right(probe, first_rings(polygon, 1));
  answer.planar = right(probe, polygon).planar;
  return answer;
}

PolygonAnswer hole_edges_excluded(const Probe& probe, const Polygon& polygon) {
  PolygonAnswer answer = right(probe, polygon);
  const Contact outer = right(probe, first_rings(polygon, 1)).answer.contact;
  const bool boundary = answer.answer.contact == Contact::edge || answer.answer.contact == Contact::vertex;
  if (boundary && outer != Contact::edge && outer != Contact::vertex) answer.answer.hit = false;
  return answer;
}

/// The last vertex of a ring has no edge back to the first.
PolygonAnswer rings_not_closed(const Probe& probe, const Polygon& polygon) {
  PolygonData there_and_back;
  for (std::size_t r = 0; r < polygon.rings(); ++r) {
    std::vector<Point3> ring(polygon.ring(r).begin(), polygon.ring(r).end());
    ring.insert(ring.end(), ring.rbegin(), ring.rend());
    there_and_back.add(ring);
  }
  PolygonAnswer answer = right(probe, polygon);
  const Answer open = right(probe, there_and_back).answer;
  if (answer.answer.contact == Contact::edge && !open.hit) answer.answer.hit = false;
  return answer;
}

PolygonAnswer vertices_excluded(const Probe& probe, const Polygon& polygon) {
  PolygonAnswer answer = right(probe, polygon);
  if (answer.answer.contact == Contact::vertex) answer.answer.hit = false;
  return answer;
}

PolygonAnswer in_plane_missed(const Probe& probe, const Polygon& polygon) {
  PolygonAnswer answer = right(probe, polygon);
  if (answer.answer.contact == Contact::coplanar) answer.answer.hit = false;
  return answer;
}

/// In the plane ring edges are asked for, and not whether all of the probe is inside.
PolygonAnswer inside_in_plane_missed(const Probe& probe, const Polygon& polygon) {
  PolygonAnswer answer = right(probe, polygon);
  if (answer.answer.contact != Contact::coplanar) return answer;
  const auto met = [&](const Point3& a, const Point3& b) {
    return std::visit([&](const auto& p) { return meets_ring_edge(p, a, b, k); }, probe);
  };
  answer.answer.hit = any_ring_edge(polygon, met);
  return answer;
}

PolygonAnswer planar_as_it_rounds(const Probe& probe, const Polygon& polygon) {
  PolygonAnswer answer = right(probe, polygon);
  answer.planar = cover(polygon, FormulaKernel<double>{}).planar;
  return answer;
}

/// The answer about another polygon, but for `planar`.
PolygonAnswer about(const Polygon& other, const Probe& probe, const Polygon& polygon) {
  PolygonAnswer answer = right(probe, other);
  answer.planar = right(probe, polygon).planar;
  return answer;
}

/// Rings are copied into a buffer of 64 vertices.
PolygonAnswer buffer_of_64(const Probe& probe, const Polygon& polygon) {
  PolygonData cut;
  for (std::size_t r = 0; r < polygon.rings(); ++r) {
    const Ring ring = polygon.ring(r);
    cut.add({ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(std::min<std::size_t>(ring.size(), 64))});
  }
  return about(cut, probe, polygon);
}

PolygonAnswer four_rings(const Probe& probe, const Polygon& polygon) {
  return about(first_rings(polygon, std::min<std::size_t>(polygon.rings(), 4)), probe, polygon);
}

/// One ring is lost where there are many.
PolygonAnswer a_hole_cut_off(const Probe& probe, const Polygon& polygon) {
  PolygonData cut;
  for (std::size_t r = 0; r < polygon.rings(); ++r) {
    const Ring ring = polygon.ring(r);
    if (r == 0 || r != polygon.rings() / 2) cut.add({ring.begin(), ring.end()});
  }
  return about(cut, probe, polygon);
}

double size_of(const Point3& p) { return std::fabs(p.x) + std::fabs(p.y) + std::fabs(p.z); }

/// Probes more than 10⁴ times as long as the polygon's first edge find nothing.
PolygonAnswer long_probes_lost(const Probe& probe, const Polygon& polygon) {
  PolygonAnswer answer = right(probe, polygon);
  const auto* s = std::get_if<Segment>(&probe);
  if (s == nullptr || polygon.vertices.size() < 2) return answer;
  const double edge = size_of(polygon.vertices[1] - polygon.vertices[0]);
  if (size_of(s->q - s->p) > 1e4 * edge && edge > 0) answer.answer.hit = false;
  return answer;
}

PolygonAnswer ray_as_line(const Probe& probe, const Polygon& polygon) {
  const PolygonAnswer forward = right(probe, polygon);
  const auto* r = std::get_if<Ray>(&probe);
  return r == nullptr || forward.answer.hit ? forward : right(Ray{r->o, {-r->d.v}}, polygon);
}

/// A direction shorter than 2⁻¹⁰⁰ is none.
PolygonAnswer tiny_directions_flushed(const Probe& probe, const Polygon& polygon) {
  const auto* r = std::get_if<Ray>(&probe);
  return r == nullptr || size_of(r->d.v) > 0x1p-100 ? right(probe, polygon) : right(Ray{r->o, {Point3(0)}}, polygon);
}

using PolygonDecision = PolygonAnswer (*)(const Probe&, const Polygon&);

/// A method that claims to be exact on polygons, and takes no triangles.
Method polygon_method(const char* name, const char* what, PolygonDecision decide) {
  Method m = method(name, what, [](const Segment&, const Triangle&) { return refusal(Status::unsupported); });
  m.contract = {.triangles = Triangles::none, .polygons = Polygons::any, .exact = true};
  m.polygon = [decide](const Polygon& polygon) -> PreparedPolygon {
    return {.segment = [decide, polygon](const Segment& s) { return decide(s, polygon); },
            .ray = [decide, polygon](const Ray& r) { return decide(r, polygon); }};
  };
  return m;
}

}  // namespace

std::vector<Method> polygon_bugs() {
  return {
      polygon_method("planted-spokes-whole", "crossings on internal edges count whole", spokes_whole),
      polygon_method("planted-spokes-none", "crossings on internal edges count nothing", spokes_not_counted),
      polygon_method("planted-undirected", "the direction of crossing is forgotten", undirected),
      polygon_method("planted-flat-counted", "triangles seen edge-on count a half", flat_counted),
      polygon_method("planted-polygon-line", "the segment is taken for its line", segment_as_line),
      polygon_method("planted-stops-early", "stops at the first pierced triangle, concave or not", stops_early),
      polygon_method("planted-polygon-xy", "always projects to xy", projects_to_xy),
      polygon_method("planted-one-plane", "one plane for polygons that are not planar", one_plane_for_all),
      polygon_method("planted-rounded-planar", "planarity in double", planar_as_it_rounds),
      polygon_method("planted-holes-forgotten", "holes are forgotten", holes_forgotten),
      polygon_method("planted-hole-edges", "edges of holes are excluded", hole_edges_excluded),
      polygon_method("planted-open-rings", "the edge back to the first vertex is excluded", rings_not_closed),
      polygon_method("planted-no-vertices", "ring vertices are excluded", vertices_excluded),
      polygon_method("planted-no-plane", "probes in the plane miss", in_plane_missed),
      polygon_method("planted-64-vertices", "rings are cut off after 64 vertices", buffer_of_64),
      polygon_method("planted-four-rings", "only four rings are looked at", four_rings),
      polygon_method("planted-hole-cut-off", "one of many rings is lost", a_hole_cut_off),
      polygon_method("planted-long-probes", "probes 10^4 times as long as an edge are lost", long_probes_lost),
      polygon_method("planted-polygon-ray-line", "the ray is taken for its line", ray_as_line),
      polygon_method("planted-polygon-directions", "short directions are flushed to zero", tiny_directions_flushed),
      polygon_method("planted-plane-edges", "probes in the plane hit on ring edges only", inside_in_plane_missed),
  };
}

Method sound_polygon() {
  return polygon_method("sound-polygon", "figure 1 with the right weights",
                        [](const Probe& probe, const Polygon& polygon) { return weighed(probe, polygon, due); });
}

}  // namespace tribunal::planted
