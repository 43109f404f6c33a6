// Full mantissas at the ends of the range.
#include "exact/cases/families/affine.h"
#include "exact/cases/families/levels.h"
#include "exact/cases/families/probe.h"
#include "exact/cases/families/shapes.h"
#include "exact/cases/families/table.h"

namespace tribunal {
namespace {

Trial make(Format format, std::uint64_t seed, std::uint64_t k) {
  Draw draw(stream_of("family extreme"), seed, k);
  const auto scales = extreme_scales(format);
  const ClassTurn turn = class_turn_of(k, scales.size());
  AffineMap map =
      draw_placed_map(draw, format, static_cast<int>(draw.between(digits_of(format) - 13, digits_of(format) - 3)));
  const bool per_axis = draw.below(2) == 0;
  for (int& s : map.scale) s = per_axis ? draw_near_levels(draw, scales) : scales[turn.level];
  return image_of(turn, map, format, draw);
}

}  // namespace

/// Class representatives under integer maps that fill the significand, times 2^level: a subnormal stands beside a
/// normal number, or a square overflows where its factors do not. Half of the cases scale each axis by a
/// power of its own.
Family extreme_family() {
  return {.name = "extreme",
          .stresses = "full mantissas at the ends of the range, subnormals beside normal numbers: all classes",
          .population = "exact affine images of the class representatives with long entries, scaled by powers of two",
          .axis = "log2 of the scale",
          .constructs = true,
          .levels = extreme_scales,
          .make = make};
}

}  // namespace tribunal
