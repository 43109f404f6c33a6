// CGAL's tests at their fastest: without the checks that they make of their preconditions elsewhere.
#define CGAL_NDEBUG
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/intersections.h>

#include "tests/bench/predicate/peers.h"

namespace tribunal::bench {
namespace {

template <class K>
bool meet(const Segment& s, const Triangle& t) {
  using P = typename K::Point_3;
  const auto point = [](const Point3& p) { return P(p.x, p.y, p.z); };
  return CGAL::do_intersect(typename K::Segment_3(point(s.p), point(s.q)),
                            typename K::Triangle_3(point(t.a), point(t.b), point(t.c)));
}

}  // namespace

bool epick(const Segment& s, const Triangle& t) {
  return meet<CGAL::Exact_predicates_inexact_constructions_kernel>(s, t);
}

bool epeck(const Segment& s, const Triangle& t) {
  return meet<CGAL::Exact_predicates_exact_constructions_kernel>(s, t);
}

}  // namespace tribunal::bench
