// Exact contacts with polygons, with longer and longer numbers.
#include "exact/cases/families/shapes.h"
#include "exact/cases/polygon_families/aim.h"
#include "exact/sweep/axes/table.h"

namespace tribunal {
namespace {

constexpr int fills_64[] = {0, 4, 8, 10, 12, 14, 16, 18, 20, 24, 30, 40, 47};
constexpr int fills_32[] = {0, 1, 2, 3, 4, 5, 6, 8, 10, 12, 15, 18};
constexpr auto fills = by_format<fills_64, fills_32>;

Trial place(Draw& draw, Format format, int value, std::uint64_t k) {
  const Aim aim = draw_aim(k, 1, draw);
  const AffineMap map = draw_polygon_map(draw, format, value);
  return image_of(aim, map, format, draw, 0);
}

}  // namespace

StressAxis polygon_fill_axis() {
  return {.name = "polygon-fill",
          .quantity = "bits of the differences of coordinates (entries of the map)",
          .population = "exact affine images of 22 ring configurations, probes aimed at 26 kinds of place",
          .operands = Operands::polygons,
          .easiest = zero,
          .values = fills,
          .stream = stream_of("sweep polygon-fill"),
          .place = place};
}

}  // namespace tribunal
