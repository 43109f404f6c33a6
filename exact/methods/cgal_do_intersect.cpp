// CGAL's own do_intersect as a peer, asked only where its preconditions hold: no degenerate operand. Its checks stay
// on in this file (no NDEBUG), so that a breach throws instead of yielding an answer.
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/intersections.h>

#include "exact/methods/exact_methods.h"

namespace tribunal {
namespace {

template <class K>
typename K::Triangle_3 triangle(const Triangle& t) {
  using P = typename K::Point_3;
  return {P(t.a.x, t.a.y, t.a.z), P(t.b.x, t.b.y, t.b.z), P(t.c.x, t.c.y, t.c.z)};
}

template <class Probe, class T>
Answer ask(const Probe& probe, const T& triangle) {
  if (probe.is_degenerate() || triangle.is_degenerate()) return refusal(Status::unsupported);
  return CGAL::do_intersect(probe, triangle) ? hit_at(Contact::unsaid) : miss();
}

template <class K>
Answer ask_segment(const Segment& s, const Triangle& t) {
  using P = typename K::Point_3;
  return ask(typename K::Segment_3(P(s.p.x, s.p.y, s.p.z), P(s.q.x, s.q.y, s.q.z)), triangle<K>(t));
}

/// Only exact constructions can form the second point that CGAL keeps of a ray.
template <class K>
Answer ask_ray(const Ray& r, const Triangle& t) {
  using P = typename K::Point_3;
  const Point3& d = r.d.v;
  if (d.x == 0 && d.y == 0 && d.z == 0) return refusal(Status::unsupported);
  return ask(typename K::Ray_3(P(r.o.x, r.o.y, r.o.z), typename K::Vector_3(d.x, d.y, d.z)), triangle<K>(t));
}

/// The guard against degenerate operands is part of what is timed.
template <class K>
NativeLoops checked() {
  return native_loops([](const Segment& s, const Triangle& t) { return ask_segment<K>(s, t).hit; });
}

Answer no_rays(const Ray&, const Triangle&) { return refusal(Status::unsupported); }

Method peer(const char* number, const char* summary, bool takes_rays) {
  return {.card = {.number = number, .summary = summary, .reference = "CGAL 5.5, 2D and 3D Linear Geometry Kernel"},
          .contract = {.probes = {.rays = takes_rays}, .triangles = Triangles::proper, .exact = true}};
}

}  // namespace

Method cgal_epick() {
  Method m = peer("CGAL filtered predicates", "CGAL's do_intersect on EPICK, within its preconditions", false);
  m.segment = ask_segment<CGAL::Exact_predicates_inexact_constructions_kernel>;
  m.native = checked<CGAL::Exact_predicates_inexact_constructions_kernel>();
  m.ray = no_rays;
  return m;
}

Method cgal_epeck() {
  Method m = peer("CGAL lazy exact numbers", "CGAL's do_intersect on EPECK, within its preconditions", true);
  m.segment = ask_segment<CGAL::Exact_predicates_exact_constructions_kernel>;
  m.native = checked<CGAL::Exact_predicates_exact_constructions_kernel>();
  m.ray = ask_ray<CGAL::Exact_predicates_exact_constructions_kernel>;
  m.native_rays = native_ray_loops([](const Ray& r, const Triangle& t) {
    return ask_ray<CGAL::Exact_predicates_exact_constructions_kernel>(r, t).hit;
  });
  return m;
}

}  // namespace tribunal
