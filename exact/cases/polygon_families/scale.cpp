// Shapes at every scale that the format has.
#include "exact/cases/families/shapes.h"
#include "exact/cases/polygon_families/aim.h"
#include "exact/cases/polygon_families/table.h"

namespace tribunal {
namespace {

constexpr int scales_64[] = {-1074, -1022, -537, -400, -359, 0, 338, 341, 400, 1015};
constexpr int scales_32[] = {-149, -126, -75, -50, 0, 41, 42, 100, 119};

constexpr auto levels = by_format<scales_64, scales_32>;

Trial make(Format format, std::uint64_t seed, std::uint64_t k) {
  Draw draw(stream_of("polygon family scale"), seed, k);
  const std::span<const int> scales = levels(format);
  const Aim aim = draw_aim(k, scales.size(), draw);
  AffineMap map = draw_map(draw, 0);
  const bool per_axis = draw.below(2) == 0;
  for (int& s : map.scale) s = per_axis ? draw_near_levels(draw, scales) : scales[aim.turn.level];
  return image_of(aim, map, format, draw);
}

}  // namespace

/// Shapes under maps with entries in {−1, 0, 1}, times 2^level, from the least subnormal to the largest finite numbers;
/// half of the cases scale each axis by any power of its own.
Family polygon_scale_family() {
  return {.name = "polygon-scale",
          .stresses = "underflow and overflow: the same from subnormals to the largest numbers",
          .population = "small images of the shapes, axes scaled by powers of two",
          .axis = "log2 of the scale",
          .constructs = true,
          .levels = levels,
          .make = make,
          .operands = Operands::polygons};
}

}  // namespace tribunal
