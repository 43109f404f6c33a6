// Differences that overflow.
#include "exact/cases/families/affine.h"
#include "exact/cases/families/probe.h"
#include "exact/cases/families/shapes.h"
#include "exact/cases/families/table.h"

namespace tribunal {
namespace {

constexpr int axis_counts[] = {1, 2, 3};

std::span<const int> levels(Format) { return axis_counts; }

Trial make(Format format, std::uint64_t seed, std::uint64_t k) {
  Draw draw(stream_of("family overflow"), seed, k);
  const ClassTurn turn = class_turn_of(k, std::size(axis_counts));
  AffineMap map = draw_placed_map(draw, format, static_cast<int>(draw.between(0, digits_of(format) - 4)));
  const int lowest = least_exponent(format) + digits_of(format) + image_bits;
  const std::uint64_t first = draw.below(3);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t axis = (first + i) % 3;
    map.scale[axis] = static_cast<int>(draw.between(lowest, 0));
    if (i <= turn.level) stretch(map, axis, extent_of(turn, map, axis), format);
  }
  return image_of(turn, map, format, draw);
}

}  // namespace

/// Class representatives under integer maps, stretched on `level` axes until differences of finite coordinates are
/// infinite; the other axes at any scale up to that of integers, and large enough for a ray's direction, which may be
/// longer than the geometry: some power of two must keep all its coordinates exact.
Family overflow_family() {
  return {.name = "overflow",
          .stresses = "finite coordinates whose differences overflow: all classes",
          .population = "exact affine images of the class representatives, stretched about zero to the last binade",
          .axis = "axes on which differences overflow",
          .constructs = true,
          .levels = levels,
          .make = make};
}

}  // namespace tribunal
