// Small integers, far from the origin.
#include "exact/cases/families/shapes.h"
#include "exact/sweep/axes/placed.h"
#include "exact/sweep/axes/table.h"

namespace tribunal {
namespace {

constexpr int offsets_64[] = {0, 5, 10, 14, 16, 18, 20, 22, 24, 26, 28, 30, 35, 40, 45, 50, 52};
constexpr int offsets_32[] = {0, 2, 4, 6, 7, 8, 9, 10, 11, 12, 14, 16, 18, 20, 22, 23};
constexpr auto offsets = by_format<offsets_64, offsets_32>;

/// Determinants of differences of images with entries so short are exact: they are below 6·2^(3·(bits + 4)).
constexpr int most_bits(Format format) { return format == Format::binary32 ? 3 : 12; }

Trial place(Draw& draw, Format format, int value, std::uint64_t k) {
  AffineMap map = draw_map(draw, static_cast<int>(draw.between(0, most_bits(format))));
  const std::int64_t far = std::int64_t{1} << value;
  for (std::int64_t& o : map.offset) o = draw.below(2) == 0 ? far : -far;
  return placed_image(class_in_turn(k), map, format, draw);
}

}  // namespace

/// A test that begins with differences of points does not notice: only products of the coordinates themselves do.
StressAxis offset_axis() {
  return {.name = "offset",
          .quantity = "offset from the origin, exact (log2)",
          .population = "all classes with short integers, moved by +-2^value on each axis",
          .easiest = zero,
          .values = offsets,
          .stream = stream_of("sweep offset"),
          .place = place};
}

}  // namespace tribunal
