// Directions far larger or smaller than the geometry.
#include "exact/cases/families/direction.h"

#include <algorithm>

#include "exact/cases/families/affine.h"
#include "exact/cases/families/levels.h"
#include "exact/cases/families/probe.h"
#include "exact/cases/families/shapes.h"
#include "exact/cases/families/table.h"

namespace tribunal {
namespace {

Trial make(Format format, std::uint64_t seed, std::uint64_t k) {
  Draw draw(stream_of("family direction"), seed, k);
  const ClassTurn turn = class_turn_of(k, direction_ratios(format).size());
  const int bits = static_cast<int>(draw.between(0, digits_of(format) / 2));
  const int ratio = draw_ratio(draw, format, direction_ratios(format)[turn.level]);
  AffineMap map = draw_map(draw, bits);
  const int scale = draw_scale_beside(draw, format, bits + image_bits, ratio);
  map.scale = {scale, scale, scale};
  return image_of(turn, map, format, draw, ratio);
}

}  // namespace

int draw_ratio(Draw& draw, Format format, int level) {
  const int width = format == Format::binary32 ? 4 : 24;
  return level + static_cast<int>(draw.between(-width, width));
}

int draw_scale_beside(Draw& draw, Format format, int bits, int ratio) {
  const int lowest = least_exponent(format), highest = largest_exponent(format) - bits;
  const int lo = std::max(lowest, lowest - ratio), hi = std::min(highest, highest - ratio);
  const auto any = static_cast<int>(draw.between(lo, hi));
  const bool below = draw.below(2) == 0;
  const int end = below ? lowest : largest_exponent(format);
  const auto beyond = static_cast<int>(draw.between(-4, digits_of(format)));
  const int critical = (end - ratio) / 3 - bits + 1 + (below ? -beyond : beyond);
  return draw.below(2) == 0 ? any : std::clamp(critical, lo, hi);
}

/// Class representatives at any scale; rays have directions 2^level times as large as the geometry. Segments have no
/// direction: their geometry is drawn in the same way.
Family direction_family() {
  return {.name = "direction",
          .stresses = "ray directions far larger or smaller than the geometry: all classes",
          .population = "exact affine images of the class representatives at any scale, the direction at another",
          .axis = "log2 of direction over geometry (of rays)",
          .constructs = true,
          .levels = direction_ratios,
          .make = make};
}

}  // namespace tribunal
