// Rings with rounded vertices.
#include "exact/cases/families/probe.h"
#include "exact/cases/polygon_families/counts.h"
#include "exact/cases/polygon_families/star.h"
#include "exact/cases/polygon_families/table.h"

namespace tribunal {
namespace {

Trial make(Format format, std::uint64_t seed, std::uint64_t k) {
  Draw draw(stream_of("polygon family rounded"), seed, k);
  const auto [is_ray, level] = turn_of(k, vertex_counts(format).size());
  Star star = draw_star(draw, format, vertex_counts(format)[level]);
  return {.query = {draw_probe(is_ray, star.through, format, draw), std::move(star.polygon)},
          .format = format,
          .level = static_cast<std::uint16_t>(level)};
}

}  // namespace

/// Star-shaped rings with `level` vertices, planar up to rounding.
Family polygon_rounded_family() {
  return {.name = "polygon-rounded",
          .stresses = "star-shaped rings planar up to rounding, aimed at vertices, edges and spokes",
          .population = "random rings in [-1,1]^3 as they round",
          .axis = "vertices",
          .constructs = false,
          .levels = vertex_counts,
          .make = make,
          .operands = Operands::polygons};
}

}  // namespace tribunal
