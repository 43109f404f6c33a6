#include "exact/filtered/crossing.h"

#include "exact/filtered/filtered.h"
#include "exact/filtered/filtered_kernel.h"

namespace tribunal {
namespace {

/// The sign of det(a − o, b − o, d(ε)); zero where o, a and b lie on one line.
Sign passed_side(const FilteredKernel& k, const Ray& r, const Point3& a, const Point3& b) {
  for (const Direction& d : {r.d, Direction{{1, 0, 0}}, Direction{{0, 1, 0}}, Direction{{0, 0, 1}}}) {
    const Sign s = k.orient3d(r.o, a, b, d);
    if (s != Sign::zero) return s;
  }
  return Sign::zero;
}

}  // namespace

Crossing crossing(const Ray& r, const Triangle& t) {
  const FilteredKernel kernel;
  const Sign source = kernel.orient3d(t.a, t.b, t.c, r.o);
  if (source == Sign::zero) return {hits(Segment{r.o, r.o}, t), 0};
  const Sign cone = -source;  // of det(a − o, b − o, c − o): the source has moved past three points
  const bool crosses = passed_side(kernel, r, t.a, t.b) == cone && passed_side(kernel, r, t.b, t.c) == cone &&
                       passed_side(kernel, r, t.c, t.a) == cone;
  return {false, crosses ? value(cone) : 0};
}

}  // namespace tribunal
