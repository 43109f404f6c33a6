// Polygons with small integers times a power of two.
#include "exact/cases/families/shapes.h"
#include "exact/cases/polygon_families/aim.h"
#include "exact/sweep/axes/table.h"

namespace tribunal {
namespace {

constexpr int scales_64[] = {-1074, -1022, -700, -537, -400, -370, -359, -350, -200, 0,
                             200,   320,   330,  338,  341,  350,  400,  700,  1015};
constexpr int scales_32[] = {-149, -126, -100, -75, -55, -50, -45, -40, -25, 0, 20, 35, 38, 41, 43, 60, 80, 100, 119};
constexpr auto scales = by_format<scales_64, scales_32>;

Trial place(Draw& draw, Format format, int value, std::uint64_t k) {
  const Aim aim = draw_aim(k, 1, draw);
  AffineMap map = draw_map(draw, 0);
  map.scale = {value, value, value};
  return image_of(aim, map, format, draw, 0);
}

}  // namespace

StressAxis polygon_scale_axis() {
  return {.name = "polygon-scale",
          .quantity = "scale of all coordinates (log2)",
          .population = "22 ring configurations with coordinates of at most 43, times 2^value",
          .operands = Operands::polygons,
          .easiest = zero,
          .values = scales,
          .stream = stream_of("sweep polygon-scale"),
          .place = place};
}

}  // namespace tribunal
