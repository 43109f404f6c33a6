// Contacts at rounded midpoints.
#include "exact/cases/families/probe.h"
#include "exact/cases/families/shapes.h"
#include "exact/cases/families/table.h"

namespace tribunal {
namespace {

constexpr int kinds_of_midpoint[] = {0, 1, 2, 3};

std::span<const int> levels(Format) { return kinds_of_midpoint; }

Segment draw_touching(Draw& draw, Format format, std::size_t kind, Triangle& t) {
  const Point3 n = draw_point(draw, format);
  const Point3 middle = in_format((t.a + t.b) * 0.5, format);
  if (kind == 0) return {middle, n};
  if (kind == 1) return {in_format((t.a + t.b + t.c) / 3.0, format), n};
  if (kind == 2) return through(middle, n, n);
  const Point3 q = draw_point(draw, format);
  t.a = in_format((n + q) * 0.5, format);
  return {n, q};
}

Trial make(Format format, std::uint64_t seed, std::uint64_t k) {
  Draw draw(stream_of("family midpoint"), seed, k);
  const auto [is_ray, kind] = turn_of(k, std::size(kinds_of_midpoint));
  Triangle t = draw_triangle(draw, format);
  const Segment s = draw_touching(draw, format, kind, t);
  return unclassified(format, kind, draw_probe(is_ray, s, format, draw), t, draw);
}

}  // namespace

/// Contacts at rounded midpoints: a probe that starts or ends on, or crosses at, the rounded middle of an edge or the
/// rounded centroid; a vertex at the rounded middle of the probe's ends.
Family midpoint_family() {
  return {.name = "midpoint",
          .stresses = "contacts at rounded midpoints of edges, triangles and segments",
          .population = "random triangles in [-1,1]^3 touched at rounded midpoints",
          .axis = "kind: edge end, centroid end, edge crossing, vertex on probe",
          .constructs = false,
          .levels = levels,
          .make = make};
}

}  // namespace tribunal
