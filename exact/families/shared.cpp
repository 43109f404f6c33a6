// Edges and vertices that two triangles share.
#include "exact/families/shapes.h"
#include "exact/families/table.h"

namespace tribunal {
namespace {

constexpr auto levels = lattice_bits;

Trial make(Format format, std::uint64_t seed, std::uint64_t k) {
  Draw draw(12, seed, k / 2);
  const std::size_t level = k / 2 % levels(format).size();
  const int n = levels(format)[level];
  const Point3 a = draw_lattice_point(draw, n, 2), b = draw_lattice_point(draw, n, 2);
  const Point3 c = draw_lattice_point(draw, n, 2), d = draw_lattice_point(draw, n, 2);
  const Point3 e = draw_lattice_point(draw, n, 2), v = draw_lattice_point(draw, n, 1);
  const bool edge = draw.below(2) == 0;
  const Segment s = through_exactly(edge ? (a + b) * 0.5 : a, v);
  const Triangle first{a, b, c}, second = edge ? Triangle{b, a, d} : Triangle{a, d, e};
  return unclassified(format, level, s, k % 2 == 0 ? first : second);
}

}  // namespace

/// Two triangles that share an edge or a vertex, on integers of `level` bits, and a segment aimed exactly at the middle
/// of the edge or at the vertex. Case k asks triangle k mod 2 of pair k / 2.
Family shared_family() {
  return {.name = "shared",
          .stresses = "edges and vertices that two triangles share, met exactly",
          .population = "pairs of integer triangles, a segment exactly through the shared edge's middle or vertex",
          .axis = "bits of the coordinates",
          .proves_class = false,
          .levels = levels,
          .make = make};
}

}  // namespace tribunal
