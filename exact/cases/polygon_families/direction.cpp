// Directions far larger or smaller than the geometry.
#include "exact/cases/families/direction.h"

#include "exact/cases/families/levels.h"
#include "exact/cases/polygon_families/aim.h"
#include "exact/cases/polygon_families/table.h"

namespace tribunal {
namespace {

Trial make(Format format, std::uint64_t seed, std::uint64_t k) {
  Draw draw(stream_of("polygon family direction"), seed, k);
  const std::span<const int> ratios = direction_ratios(format);
  const Aim aim = draw_aim(k, ratios.size(), draw);
  const auto bits = static_cast<int>(draw.between(0, digits_of(format) / 2));
  const int ratio = draw_ratio(draw, format, ratios[aim.turn.level]);
  AffineMap map = draw_map(draw, bits);
  const int scale = draw_scale_beside(draw, format, bits + polygon_image_bits, ratio);
  map.scale = {scale, scale, scale};
  return image_of(aim, map, format, draw, ratio);
}

}  // namespace

/// Shapes at any scale; rays have directions 2^level times as large as the geometry. Segments have no direction: their
/// geometry is drawn in the same way.
Family polygon_direction_family() {
  return {.name = "polygon-direction",
          .stresses = "ray directions far larger or smaller than the geometry",
          .population = "exact affine images of the shapes at any scale, the direction at another",
          .axis = "log2 of direction over geometry (of rays)",
          .constructs = true,
          .levels = direction_ratios,
          .make = make,
          .operands = Operands::polygons};
}

}  // namespace tribunal
