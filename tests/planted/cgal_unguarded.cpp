// CGAL's do_intersect with its precondition checks compiled out, asked about anything. A shared library of its own with
// hidden symbols: its unchecked templates must not replace the checked ones of the program.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/intersections.h>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

static Kernel::Point_3 point(const double* v) { return {v[0], v[1], v[2]}; }

extern "C" __attribute__((visibility("default"))) bool tribunal_unguarded_do_intersect(const double* points) {
  const Kernel::Triangle_3 t(point(points), point(points + 3), point(points + 6));
  return CGAL::do_intersect(Kernel::Segment_3(point(points + 9), point(points + 12)), t);
}
