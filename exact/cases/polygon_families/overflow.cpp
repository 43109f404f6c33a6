// Differences that overflow.
#include "exact/cases/families/shapes.h"
#include "exact/cases/polygon_families/aim.h"
#include "exact/cases/polygon_families/table.h"

namespace tribunal {
namespace {

constexpr int axis_counts[] = {1, 2, 3};

std::span<const int> levels(Format) { return axis_counts; }

Trial make(Format format, std::uint64_t seed, std::uint64_t k) {
  Draw draw(stream_of("polygon family overflow"), seed, k);
  const Aim aim = draw_aim(k, std::size(axis_counts), draw);
  const auto bits = static_cast<int>(draw.between(0, digits_of(format) - polygon_image_bits - 1));
  AffineMap map = draw_polygon_map(draw, format, bits);
  const int lowest = least_exponent(format) + digits_of(format) + polygon_image_bits;
  const ProbeEnds points = aim.turn.is_ray ? ProbeEnds{aim.ends.from, aim.ends.from} : aim.ends;
  const std::uint64_t first = draw.below(3);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t axis = (first + i) % 3;
    map.scale[axis] = static_cast<int>(draw.between(lowest, 0));
    if (i <= aim.turn.level) stretch(map, axis, extent_of(map, axis, aim.rings(), points), format);
  }
  return image_of(aim, map, format, draw);
}

}  // namespace

/// Shapes under integer maps, stretched on `level` axes until differences of finite coordinates are infinite; the
/// other axes at any scale up to that of integers, and large enough for a ray's direction, which may be longer
/// than the geometry: some power of two must keep all its coordinates exact.
Family polygon_overflow_family() {
  return {.name = "polygon-overflow",
          .stresses = "finite coordinates whose differences overflow",
          .population = "exact affine images of the shapes, stretched about zero to the last binade",
          .axis = "axes on which differences overflow",
          .constructs = true,
          .levels = levels,
          .make = make,
          .operands = Operands::polygons};
}

}  // namespace tribunal
