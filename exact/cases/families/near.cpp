// Almost collinear and almost equal vertices.
#include "exact/cases/families/probe.h"
#include "exact/cases/families/shapes.h"
#include "exact/cases/families/table.h"
#include "exact/cases/families/ulp.h"

namespace tribunal {
namespace {

constexpr int steps[] = {0, 1, 2, 8, 64, 1024};

std::span<const int> levels(Format) { return steps; }

Trial make(Format format, std::uint64_t seed, std::uint64_t k) {
  Draw draw(stream_of("family near"), seed, k);
  const auto [is_ray, level] = turn_of(k, levels(format).size());
  Triangle t = draw_triangle(draw, format);
  const double along = draw_real(draw, format);
  if (draw.below(2) == 0)
    t.c = t.b;
  else
    t.c = in_format(t.a + 1.5 * along * (t.b - t.a), format);
  for (int axis = 0; axis < 3; ++axis) {
    const std::int64_t by = draw.between(-steps[level], steps[level]);
    t.c[axis] = moved_by_ulps(t.c[axis], by, format);
  }
  const Point3 x = draw_in_plane(draw, format, t);
  const Point3 n = draw_point(draw, format);
  return unclassified(format, level, draw_probe(is_ray, through(x, n, n), format, draw), t, draw);
}

}  // namespace

/// Triangles with a vertex level ulps from the line of the others, or from another vertex.
Family near_family() {
  return {.name = "near",
          .stresses = "almost collinear and almost equal vertices",
          .population = "random triangles in [-1,1]^3, one vertex ulps from the others' line or from another vertex",
          .axis = "units in the last place",
          .constructs = false,
          .levels = levels,
          .make = make};
}

}  // namespace tribunal
