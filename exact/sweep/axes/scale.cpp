// Small integers times a power of two: all coordinates, or those of one axis.
#include "exact/cases/families/shapes.h"
#include "exact/sweep/axes/placed.h"
#include "exact/sweep/axes/table.h"

namespace tribunal {
namespace {

constexpr int scales_64[] = {-1074, -1060, -1022, -900, -700, -537, -450, -400, -370, -360, -359,
                             -358,  -357,  -350,  -340, -330, -323, -200, -100, -50,  -25,  -15,
                             -10,   -8,    -6,    -4,   -2,   0,    100,  200,  300,  330,  338,
                             339,   340,   341,   342,  350,  400,  500,  700,  900,  1020};
constexpr int scales_32[] = {-149, -140, -126, -100, -75, -60, -51, -50, -49, -48, -45, -40, -25, -15, -10, -8,
                             -6,   -4,   -2,   0,    20,  35,  38,  39,  40,  41,  42,  43,  50,  70,  100, 124};
constexpr auto scales = by_format<scales_64, scales_32>;

constexpr int one_scales_64[] = {-1074, -1060, -1022, -900, -800, -700, -600, -537, -500, -400, -300, -200, -100,
                                 0,     100,   200,   300,  400,  500,  510,  600,  700,  800,  900,  1000, 1020};
constexpr int one_scales_32[] = {-149, -140, -126, -100, -75, -60, -50, -40, -25, 0,
                                 20,   40,   50,   58,   60,  65,  75,  90,  100, 124};
constexpr auto one_scales = by_format<one_scales_64, one_scales_32>;

/// Entries in {−1, 0, 1} keep |M·x| ≤ 7, so that 7·2¹⁰²⁰ and 7·2¹²⁴ are finite and multiples of the least subnormal
/// are exact.
Trial place(Draw& draw, Format format, int value, std::uint64_t k) {
  AffineMap map = draw_map(draw, 0);
  map.scale = {value, value, value};
  return placed_image(class_in_turn(k), map, format, draw);
}

Trial place_one(Draw& draw, Format format, int value, std::uint64_t k) {
  AffineMap map = draw_map(draw, 0);
  map.scale[draw.below(3)] = value;
  return placed_image(class_in_turn(k), map, format, draw);
}

}  // namespace

/// From subnormals to the largest numbers: products underflow or overflow, and nothing else is hard.
StressAxis scale_axis() {
  return {.name = "scale",
          .quantity = "scale of all coordinates (log2)",
          .population = "all classes with coordinates of at most 7, times 2^value",
          .easiest = zero,
          .values = scales,
          .stream = stream_of("sweep scale"),
          .place = place};
}

/// The same on one axis of the three, drawn case by case.
StressAxis one_scale_axis() {
  return {.name = "scale-one",
          .quantity = "scale of the coordinates on one axis of three (log2)",
          .population = "all classes with coordinates of at most 7, those on one axis times 2^value",
          .easiest = zero,
          .values = one_scales,
          .stream = stream_of("sweep scale-one"),
          .place = place_one};
}

}  // namespace tribunal
