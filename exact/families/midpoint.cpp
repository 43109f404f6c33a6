// Contacts at rounded midpoints.
#include "exact/families/shapes.h"
#include "exact/families/table.h"

namespace tribunal {
namespace {

constexpr int kinds_of_midpoint[] = {0, 1, 2, 3};

std::span<const int> levels(Format) { return kinds_of_midpoint; }

Trial make(Format format, std::uint64_t seed, std::uint64_t k) {
  Draw draw(6, seed, k);
  const std::size_t kind = k % 4;
  Triangle t = draw_triangle(draw, format);
  const Point3 n = draw_point(draw, format);
  const Point3 middle = in_format((t.a + t.b) * 0.5, format);
  const Point3 centroid = in_format((t.a + t.b + t.c) / 3.0, format);
  if (kind == 0) return shuffled(unclassified(format, kind, {middle, n}, t), draw);
  if (kind == 1) return shuffled(unclassified(format, kind, {centroid, n}, t), draw);
  if (kind == 2) return shuffled(unclassified(format, kind, through(middle, n, n), t), draw);
  const Point3 q = draw_point(draw, format);
  t.a = in_format((n + q) * 0.5, format);
  return shuffled(unclassified(format, kind, {n, q}, t), draw);
}

}  // namespace

/// Contacts at rounded midpoints: a segment that ends on, or crosses at, the rounded middle of an edge or the rounded
/// centroid; a vertex at the rounded middle of the segment.
Family midpoint_family() {
  return {.name = "midpoint",
          .stresses = "contacts at rounded midpoints of edges, triangles and segments",
          .population = "random triangles in [-1,1]^3 touched at rounded midpoints",
          .axis = "kind: edge end, centroid end, edge crossing, vertex on segment",
          .proves_class = false,
          .levels = levels,
          .make = make};
}

}  // namespace tribunal
