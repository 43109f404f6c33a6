// Full mantissas at the ends of the range.
#include "exact/cases/families/levels.h"
#include "exact/cases/polygon_families/aim.h"
#include "exact/cases/polygon_families/table.h"

namespace tribunal {
namespace {

/// The bits of the map's entries: as many as the significand has beside those that the image of a shape needs, or up to
/// ten fewer.
int draw_bits(Draw& draw, Format format) {
  const int most = digits_of(format) - polygon_image_bits;
  return static_cast<int>(draw.between(most - 10, most));
}

Trial make(Format format, std::uint64_t seed, std::uint64_t k) {
  Draw draw(stream_of("polygon family extreme"), seed, k);
  const std::span<const int> scales = extreme_scales(format);
  const Aim aim = draw_aim(k, scales.size(), draw);
  AffineMap map = draw_polygon_map(draw, format, draw_bits(draw, format));
  const bool per_axis = draw.below(2) == 0;
  for (int& s : map.scale) s = per_axis ? draw_near_levels(draw, scales) : scales[aim.turn.level];
  return image_of(aim, map, format, draw);
}

}  // namespace

/// Shapes under integer maps that fill the significand, times 2^level: a subnormal stands beside a normal number, or a
/// square overflows where its factors do not. Half of the cases scale each axis by a power of its own.
Family polygon_extreme_family() {
  return {.name = "polygon-extreme",
          .stresses = "full mantissas at the ends of the range, subnormals beside normal numbers",
          .population = "exact affine images of the shapes with long entries, scaled by powers of two",
          .axis = "log2 of the scale",
          .constructs = true,
          .levels = extreme_scales,
          .make = make,
          .operands = Operands::polygons};
}

}  // namespace tribunal
