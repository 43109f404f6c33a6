// Degenerate operands given to CGAL without checks.
#include "tests/planted/bugs.h"

/// The five points a, b, c, p, q, by coordinates.
extern "C" bool tribunal_unguarded_do_intersect(const double* points);

namespace tribunal::planted {
namespace {

Answer unguarded(const Segment& s, const Triangle& t) {
  const double points[] = {t.a.x, t.a.y, t.a.z, t.b.x, t.b.y, t.b.z, t.c.x, t.c.y,
                           t.c.z, s.p.x, s.p.y, s.p.z, s.q.x, s.q.y, s.q.z};
  return tribunal_unguarded_do_intersect(points) ? hit_at(Contact::unsaid) : miss();
}

}  // namespace

std::vector<Method> cgal_bugs() {
  return {method("planted-cgal-unguarded", "degenerate operands given to CGAL without checks", unguarded)};
}

}  // namespace tribunal::planted
