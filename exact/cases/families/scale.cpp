// Class representatives at every scale that the format has.
#include "exact/cases/families/affine.h"
#include "exact/cases/families/shapes.h"
#include "exact/cases/families/table.h"

namespace tribunal {
namespace {

constexpr int scales_64[] = {-1074, -1060, -1022, -537, -400, -359, -358, -323, 0, 338, 341, 400, 1020};
constexpr int scales_32[] = {-149, -126, -75, -50, -49, 0, 41, 42, 100, 124};

constexpr auto levels = by_format<scales_64, scales_32>;

/// Entries in {−1, 0, 1} keep |M·x| ≤ 7, so that 7·2¹⁰²⁰ and 7·2¹²⁴ are finite and multiples of the least subnormal
/// are exact.
Trial make(Format format, std::uint64_t seed, std::uint64_t k) {
  Draw draw(stream_of("family scale"), seed, k);
  const auto scales = levels(format);
  const ClassTurn turn = class_turn_of(k, scales.size());
  AffineMap map = draw_map(draw, 0);
  const bool per_axis = draw.below(2) == 0;
  for (int& s : map.scale) s = per_axis ? draw_near_levels(draw, scales) : scales[turn.level];
  return image_of(turn, map, format, draw);
}

}  // namespace

/// Class representatives scaled by 2^level, from the least subnormal to the largest finite numbers; half of the cases
/// scale each axis by any power of its own.
Family scale_family() {
  return {.name = "scale",
          .stresses = "underflow and overflow: all classes from subnormals to the largest numbers",
          .population = "small images of the class representatives, axes scaled by powers of two",
          .axis = "log2 of the scale",
          .constructs = true,
          .levels = levels,
          .make = make};
}

}  // namespace tribunal
