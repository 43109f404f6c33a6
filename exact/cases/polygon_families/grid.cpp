// Random rings on a grid.
#include <algorithm>

#include "exact/cases/polygon_families/aim.h"
#include "exact/cases/polygon_families/counts.h"
#include "exact/cases/polygon_families/table.h"

namespace tribunal {
namespace {

/// One to three rings of up to `count` vertices in all on a 5×5 grid.
std::vector<PlaneRing> draw_grid_rings(Draw& draw, int count) {
  std::vector<PlaneRing> rings(static_cast<std::size_t>(1 + draw.below(3)));
  for (PlaneRing& ring : rings) {
    const std::int64_t size = draw.between(1, std::max(1, count / static_cast<int>(rings.size())));
    for (std::int64_t i = 0; i < size; ++i) {
      const auto cell = static_cast<int>(draw.below(25));
      ring.push_back({3 * (cell % 5), 3 * (cell / 5)});
    }
  }
  return rings;
}

Trial make(Format format, std::uint64_t seed, std::uint64_t k) {
  Draw draw(stream_of("polygon family grid"), seed, k);
  const auto [is_ray, level] = turn_of(k, vertex_counts(format).size());
  const int bits = draw_fill(draw, format);
  const AffineMap map = draw_polygon_map(draw, format, bits);
  const auto rings = draw_grid_rings(draw, vertex_counts(format)[level]);
  const auto u = static_cast<int>(draw.between(-1, 13));
  const auto v = static_cast<int>(draw.between(-1, 13));
  const auto approach = static_cast<Approach>(draw.below(approach_count));
  const ProbeEnds ends = draw_piercing(draw, {u, v}, approach);
  return {.query = {image(is_ray, map, ends, format, draw), image(map, rings)},
          .format = format,
          .level = static_cast<std::uint16_t>(level)};
}

}  // namespace

/// Rings between any points of a grid, pierced at integer points among them.
Family polygon_grid_family() {
  return {.name = "polygon-grid",
          .stresses = "random rings on a grid, degenerate in every way",
          .population = "exact affine images of rings on a 5x5 grid",
          .axis = "vertices, at most",
          .constructs = false,
          .levels = vertex_counts,
          .make = make,
          .operands = Operands::polygons};
}

}  // namespace tribunal
