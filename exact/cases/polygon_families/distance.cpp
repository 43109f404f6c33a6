// Probes that reach far from the polygon, or hardly leave its plane.
#include "exact/cases/families/shapes.h"
#include "exact/cases/polygon_families/aim.h"
#include "exact/cases/polygon_families/table.h"

namespace tribunal {
namespace {

constexpr int heights_64[] = {-1074, -900, -600, -350, -150, -60, -25, 0, 14, 25, 60, 150, 350, 600, 900, 1020};
constexpr int heights_32[] = {-149, -120, -80, -40, -20, -10, 0, 10, 20, 40, 80, 124};

constexpr auto levels = by_format<heights_64, heights_32>;

/// Whether two rows are parallel as vectors of the plane, computed modulo 2⁶⁴: some that are not parallel count as
/// parallel.
bool are_parallel(const std::array<std::int64_t, 3>& a, const std::array<std::int64_t, 3>& b) {
  const auto u = [](std::int64_t x) { return static_cast<std::uint64_t>(x); };
  return u(a[0]) * u(b[1]) == u(a[1]) * u(b[0]);
}

/// A random map that takes the height above the plane, scaled by 2^height, to one axis and the coordinates in the plane
/// to the other two.
AffineMap draw_upright_map(Draw& draw, Format format, int height) {
  AffineMap map = draw_polygon_map(draw, format, draw_fill(draw, format));
  const std::uint64_t up = draw.below(3);
  auto &row = map.m[(up + 1) % 3], &other = map.m[(up + 2) % 3];
  if (are_parallel(row, other)) row = {1, 0, 0}, other = {0, 1, 0};
  row[2] = other[2] = 0;
  map.m[up] = {0, 0, draw.below(2) == 0 ? 1 : -1};
  map.offset[up] = 0;
  map.scale[up] = height;
  return map;
}

Trial make(Format format, std::uint64_t seed, std::uint64_t k) {
  Draw draw(stream_of("polygon family distance"), seed, k);
  const std::span<const int> heights = levels(format);
  const Aim aim = draw_aim(k, heights.size(), draw);
  const int height = draw_up_to_level(draw, heights, aim.turn.level);
  return image_of(aim, draw_upright_map(draw, format, height), format, draw);
}

}  // namespace

/// Shapes with integer coordinates, perpendicular to one axis, and probes that end 2^level above or below: they meet
/// the plane exactly at the point aimed at, however long or short they are.
Family polygon_distance_family() {
  return {.name = "polygon-distance",
          .stresses = "probes far longer than the polygon, and such as hardly leave its plane",
          .population = "exact images of the shapes across an axis, probe ends up to 2^level above them",
          .axis = "log2 of the height",
          .constructs = true,
          .levels = levels,
          .make = make,
          .operands = Operands::polygons};
}

}  // namespace tribunal
