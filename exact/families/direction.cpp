// Directions far larger or smaller than the geometry.
#include <algorithm>

#include "exact/families/affine.h"
#include "exact/families/probe.h"
#include "exact/families/shapes.h"
#include "exact/families/table.h"

namespace tribunal {
namespace {

constexpr int ratios_64[] = {-2000, -1500, -1100, -900, -800, -700, -600, -400, -200,
                             -60,   0,     60,    200,  400,  600,  1000, 1500, 2000};
constexpr int ratios_32[] = {-240, -180, -140, -100, -50, -20, 0, 20, 50, 100, 180, 240};

constexpr auto levels = by_format<ratios_64, ratios_32>;

/// The level, give or take a few binades.
int draw_ratio(Draw& draw, Format format, int level) {
  const int width = format == Format::binary32 ? 4 : 24;
  return level + static_cast<int>(draw.between(-width, width));
}

/// Of the geometry: any for which it and the direction exist; or, every other time, one at which a volume, two lengths
/// times the direction, is below the least number of the format, or above the largest, by a little or by much.
int draw_scale(Draw& draw, Format format, int bits, int ratio) {
  const int lowest = least_exponent(format), highest = largest_exponent(format) - bits - image_bits;
  const int lo = std::max(lowest, lowest - ratio), hi = std::min(highest, highest - ratio);
  const auto any = static_cast<int>(draw.between(lo, hi));
  const bool below = draw.below(2) == 0;
  const int end = below ? lowest : largest_exponent(format);
  const auto beyond = static_cast<int>(draw.between(-4, digits_of(format)));
  const int critical = (end - ratio) / 3 - bits - 2 + (below ? -beyond : beyond);
  return draw.below(2) == 0 ? any : std::clamp(critical, lo, hi);
}

Trial make(Format format, std::uint64_t seed, std::uint64_t k) {
  Draw draw(19, seed, k);
  const ClassTurn turn = class_turn_of(k, levels(format).size());
  const int bits = static_cast<int>(draw.between(0, digits_of(format) / 2));
  const int ratio = draw_ratio(draw, format, levels(format)[turn.level]);
  AffineMap map = draw_map(draw, bits);
  const int scale = draw_scale(draw, format, bits, ratio);
  map.scale = {scale, scale, scale};
  return image_of(turn, map, format, draw, ratio);
}

}  // namespace

/// Class representatives at any scale, of rays with the direction 2^level times as large as the geometry. Segments
/// have no direction: theirs is the same geometry without that stress.
Family direction_family() {
  return {.name = "direction",
          .stresses = "ray directions far larger or smaller than the geometry: all classes",
          .population = "exact affine images of the class representatives at any scale, the direction at another",
          .axis = "log2 of direction over geometry (of rays)",
          .constructs = true,
          .levels = levels,
          .make = make};
}

}  // namespace tribunal
