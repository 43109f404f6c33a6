// Shapes under integer maps.
#include "exact/cases/polygon_families/aim.h"
#include "exact/cases/polygon_families/table.h"

namespace tribunal {
namespace {

Trial make(Format format, std::uint64_t seed, std::uint64_t k) {
  Draw draw(stream_of("polygon family affine"), seed, k);
  const std::span<const int> fills = polygon_fills(format);
  const Aim aim = draw_aim(k, fills.size(), draw);
  return image_of(aim, draw_polygon_map(draw, format, fills[aim.turn.level]), format, draw);
}

}  // namespace

/// Every case knows its construction, which is an oracle of its own.
Family polygon_affine_family() {
  return {.name = "polygon-affine",
          .stresses = "22 ring configurations, 26 kinds of place, with growing mantissa fill",
          .population = "exact affine images of the shapes",
          .axis = "bits of the map's entries",
          .constructs = true,
          .levels = polygon_fills,
          .make = make,
          .operands = Operands::polygons};
}

}  // namespace tribunal
