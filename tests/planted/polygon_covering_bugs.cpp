// Bugs in the polygon test: its covering, its count, its planes, its holes.
#include <cstdlib>

#include "core/segura_feito_polygon.h"
#include "exact/methods/cgal_kernels.h"
#include "exact/methods/naive.h"
#include "tests/planted/polygon_bugs.h"

namespace tribunal::planted {
namespace {

using namespace detail;

const EpickKernel k;

/// The answer by a covering that `Spoil` has changed.
template <class Spoil>
Answer by_covering(const Probe& probe, const Polygon& polygon, const Spoil& spoil) {
  Covering c = cover(polygon, k);
  const bool planar = c.planar;
  spoil(c);
  Answer answer = std::visit([&](const auto& p) { return segura_feito(p, c, k); }, probe);
  answer.planar = planar;
  return answer;
}

Answer stops_early(const Probe& probe, const Polygon& polygon) {
  return by_covering(probe, polygon, [](Covering& c) { c.disjoint = c.planar; });
}

Answer projects_to_xy(const Probe& probe, const Polygon& polygon) {
  return by_covering(probe, polygon, [](Covering& c) {
    if (c.plane) c.plane->dropped = Axis::z;
  });
}

Answer one_plane_for_all(const Probe& probe, const Polygon& polygon) {
  return by_covering(probe, polygon, [](Covering& c) { c.plane = spanned_plane(c.polygon, k); });
}

/// The signed count of a planar polygon with other weights for the triangles that are hit; the answer is right on the
/// boundary and in the plane.
template <class Weight>
Answer weighed(const Probe& probe, const Polygon& polygon, const Weight& weight, bool as_line = false) {
  Answer answer = right(probe, polygon);
  const auto* s = std::get_if<Segment>(&probe);
  const Covering c = cover(polygon, k);
  if (s == nullptr || !c.plane || (answer.hit && answer.contact != Contact::interior)) return answer;
  const PlaneSides sides = sides_of(c.plane->triangle, *s, k);
  if (sides.in_plane() || (!as_line && !reaches(sides.source, sides.target, s->q))) return answer;
  int sum = 0;
  const auto side = [&](const Point3& a, const Point3& b) { return k.orient3d(s->p, a, b, s->q); };
  visit_passed(polygon, side, [&](const Point3&, const Point3&, const Passage& passage) {
    sum += weight(passage);
    return false;
  });
  answer.hit = is_odd(sum);
  return answer;
}

int due(const Passage& p) { return halves(p.location(), p.direction()); }

Answer spokes_whole(const Probe& probe, const Polygon& polygon) {
  return weighed(probe, polygon, [](const Passage& p) { return 2 * value(p.direction()); });
}

Answer spokes_not_counted(const Probe& probe, const Polygon& polygon) {
  return weighed(probe, polygon, [](const Passage& p) { return p.location() == Location::internal_edge ? 0 : due(p); });
}

Answer undirected(const Probe& probe, const Polygon& polygon) {
  return weighed(probe, polygon, [](const Passage& p) { return std::abs(due(p)); });
}

Answer flat_counted(const Probe& probe, const Polygon& polygon) {
  return weighed(probe, polygon, [](const Passage& p) { return p.edge_on() ? 1 : due(p); });
}

Answer segment_as_line(const Probe& probe, const Polygon& polygon) { return weighed(probe, polygon, due, true); }

Answer holes_forgotten(const Probe& probe, const Polygon& polygon) {
  return about(first_rings(polygon, 1), probe, polygon);
}

Answer hole_edges_excluded(const Probe& probe, const Polygon& polygon) {
  Answer answer = right(probe, polygon);
  const Contact outer = right(probe, first_rings(polygon, 1)).contact;
  const bool boundary = answer.contact == Contact::edge || answer.contact == Contact::vertex;
  if (boundary && outer != Contact::edge && outer != Contact::vertex) answer.hit = false;
  return answer;
}

Answer vertices_excluded(const Probe& probe, const Polygon& polygon) {
  Answer answer = right(probe, polygon);
  if (answer.contact == Contact::vertex) answer.hit = false;
  return answer;
}

Answer in_plane_missed(const Probe& probe, const Polygon& polygon) {
  Answer answer = right(probe, polygon);
  if (answer.contact == Contact::coplanar) answer.hit = false;
  return answer;
}

/// In the plane, tests whether a ring edge is met, but not whether the whole probe is inside.
Answer inside_in_plane_missed(const Probe& probe, const Polygon& polygon) {
  Answer answer = right(probe, polygon);
  if (answer.contact != Contact::coplanar) return answer;
  const auto met = [&](const Point3& a, const Point3& b) {
    return std::visit([&](const auto& p) { return meets_ring_edge(p, a, b, k); }, probe);
  };
  answer.hit = any_ring_edge(polygon, met);
  return answer;
}

Answer planar_as_it_rounds(const Probe& probe, const Polygon& polygon) {
  Answer answer = right(probe, polygon);
  answer.planar = cover(polygon, FormulaKernel<double>{}).planar;
  return answer;
}

}  // namespace

std::vector<Method> covering_bugs() {
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
      polygon_method("planted-no-vertices", "ring vertices are excluded", vertices_excluded),
      polygon_method("planted-no-plane", "probes in the plane miss", in_plane_missed),
      polygon_method("planted-plane-edges", "probes in the plane hit on ring edges only", inside_in_plane_missed),
  };
}

Method sound_covering() {
  return polygon_method("sound-polygon", "figure 1 with the right weights",
                        [](const Probe& probe, const Polygon& polygon) { return weighed(probe, polygon, due); });
}

}  // namespace tribunal::planted
