// Edges and vertices that two triangles share.
#include "exact/cases/families/probe.h"
#include "exact/cases/families/shapes.h"
#include "exact/cases/families/table.h"

namespace tribunal {
namespace {

constexpr auto levels = lattice_bits;

Trial make(Format format, std::uint64_t seed, std::uint64_t k) {
  Draw draw(stream_of("family shared"), seed, k);
  const auto [is_ray, level] = turn_of(k, levels(format).size());
  const int n = levels(format)[level];
  const Point3 a = draw_lattice_point(draw, n, 2), b = draw_lattice_point(draw, n, 2);
  const Point3 c = draw_lattice_point(draw, n, 2), d = draw_lattice_point(draw, n, 2);
  const Point3 e = draw_lattice_point(draw, n, 2), v = draw_lattice_point(draw, n, 1);
  const bool edge = draw.below(2) == 0;
  const bool first = draw.below(2) == 0;
  const bool beyond = draw.below(4) == 0;
  const Segment s = through_exactly(beyond ? 2.0 * a - b : edge ? (a + b) * 0.5 : a, v);
  const Triangle other = edge ? Triangle{b, a, d} : Triangle{a, d, e};
  return unclassified(format, level, draw_probe(is_ray, s, format, draw), first ? Triangle{a, b, c} : other, draw);
}

}  // namespace

/// Two triangles that share an edge or a vertex, on integers of `level` bits, and a probe aimed exactly at the middle
/// of the edge or at the vertex, or, one time in four, at a point of the edge's line beyond it. Each case asks one
/// triangle of a pair of its own.
Family shared_family() {
  return {.name = "shared",
          .stresses = "edges and vertices that two triangles share, met exactly",
          .population = "pairs of integer triangles, a probe exactly through the shared edge's middle or vertex",
          .axis = "bits of the coordinates",
          .constructs = false,
          .levels = levels,
          .make = make};
}

}  // namespace tribunal
