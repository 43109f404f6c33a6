#include "exact/cases/families/affine.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "exact/cases/families/probe.h"
#include "exact/cases/families/shapes.h"
#include "exact/cases/families/table.h"
#include "exact/classes/class_table.h"

namespace tribunal {
namespace {

constexpr int fills_64[] = {0, 8, 16, 17, 20, 30, 40, 50};
constexpr int fills_32[] = {0, 4, 7, 8, 12, 16, 21};

/// The determinant modulo 2⁶⁴. Nonzero there implies nonzero; the converse fails for one matrix in about 2⁶⁴.
std::uint64_t determinant(const AffineMap& map) {
  const auto u = [&](std::size_t i, std::size_t j) { return static_cast<std::uint64_t>(map.m[i][j]); };
  return u(0, 0) * (u(1, 1) * u(2, 2) - u(1, 2) * u(2, 1)) + u(0, 1) * (u(1, 2) * u(2, 0) - u(1, 0) * u(2, 2)) +
         u(0, 2) * (u(1, 0) * u(2, 1) - u(1, 1) * u(2, 0));
}

/// Half of the time an offset that images below 7·2^bits leave room for in the format's integers.
void draw_offset(AffineMap& map, Draw& draw, Format format, int bits) {
  if (draw.below(2) == 0) return;
  const int digits = digits_of(format);
  const std::int64_t room = (std::int64_t{1} << digits) - 7 * (std::int64_t{1} << bits);
  const std::int64_t limit = std::min(room, std::int64_t{1} << (digits - 1));
  for (std::int64_t& o : map.offset) o = draw.between(-limit, limit);
}

void draw_scale(AffineMap& map, Draw& draw) {
  if (draw.below(4) != 0) return;
  for (int& s : map.scale) s = static_cast<int>(draw.between(-12, 12));
}

/// M·x, or M·x + o: one coordinate before it is scaled.
std::int64_t coordinate(const AffineMap& map, std::size_t axis, const std::array<int, 3>& x, std::int64_t offset) {
  std::int64_t sum = offset;
  for (std::size_t j = 0; j < 3; ++j) sum += map.m[axis][j] * x[j];
  return sum;
}

Point3 image(const AffineMap& map, const std::array<int, 3>& x) {
  Point3 y;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto sum = static_cast<double>(coordinate(map, i, x, map.offset[i]));
    y[static_cast<int>(i)] = map.scale[i] == 0 ? sum : times_power_of_two(sum, map.scale[i]);
  }
  return y;
}

/// a, b, c, and p, q of a segment or o, d of a ray.
using Representative = std::array<std::array<int, 3>, 5>;

Segment segment_image(const AffineMap& map, const Representative& x, Draw& draw) {
  const Segment s{image(map, x[3]), image(map, x[4])};
  return draw.below(2) == 0 ? s : Segment{s.q, s.p};
}

/// The direction has no offset, and may exceed the range of doubles until it is scaled.
Ray ray_image(const AffineMap& map, const Representative& x, Format format, Draw& draw,
              std::optional<int> direction_scale) {
  std::array<Scaled, 3> d;
  for (std::size_t i = 0; i < 3; ++i) d[i] = {coordinate(map, i, x[4], 0), map.scale[i]};
  return {image(map, x[3]), direction_scale ? scaled(d, *direction_scale) : draw_direction(d, format, draw)};
}

Trial make(Format format, std::uint64_t seed, std::uint64_t k) {
  Draw draw(stream_of("family affine"), seed, k);
  const ClassTurn turn = class_turn_of(k, mantissa_fills(format).size());
  return affine_image(format, draw, turn, mantissa_fills(format)[turn.level]);
}

}  // namespace

AffineMap draw_map(Draw& draw, int bits) {
  const std::int64_t limit = std::int64_t{1} << bits;
  AffineMap map;
  do {
    for (auto& row : map.m) {
      for (std::int64_t& entry : row) entry = draw.between(-limit, limit);
    }
  } while (determinant(map) == 0);
  return map;
}

AffineMap draw_placed_map(Draw& draw, Format format, int bits) {
  AffineMap map = draw_map(draw, bits);
  draw_offset(map, draw, format, bits);
  return map;
}

ClassTurn class_turn_of(std::uint64_t k, std::size_t levels) {
  return {static_cast<ClassId>(1 + k % all_class_count), k / all_class_count % levels};
}

std::uint64_t segment_case(std::uint64_t k) { return k / class_count * all_class_count + k % class_count; }

Extent extent_of(const ClassTurn& turn, const AffineMap& map, std::size_t axis) {
  const Representative& x = class_row(turn.id).points;
  Extent extent{std::numeric_limits<std::int64_t>::max(), std::numeric_limits<std::int64_t>::min()};
  for (std::size_t i = 0; i < (is_ray_class(turn.id) ? 4 : 5); ++i) {
    const std::int64_t y = coordinate(map, axis, x[i], 0);
    extent = {std::min(extent.lo, y), std::max(extent.hi, y)};
  }
  return extent;
}

void stretch(AffineMap& map, std::size_t axis, const Extent& extent, Format format) {
  for (std::int64_t& entry : map.m[axis]) entry *= 2;
  map.offset[axis] = -(extent.lo + extent.hi);
  const auto radius = static_cast<std::uint64_t>(extent.hi - extent.lo);
  map.scale[axis] = largest_exponent(format) + 1 - std::max(1, static_cast<int>(std::bit_width(radius)));
}

AffineMap draw_axis_map(Draw& draw) {
  AffineMap map{};
  const std::uint64_t first = draw.below(3);
  const std::uint64_t second = (first + 1 + draw.below(2)) % 3;
  const std::uint64_t axis[3] = {first, second, 3 - first - second};
  for (std::size_t i = 0; i < 3; ++i) map.m[i][axis[i]] = draw.below(2) == 0 ? 1 : -1;
  for (int& s : map.scale) s = static_cast<int>(draw.between(-12, 12));
  return map;
}

Trial image_of(const ClassTurn& turn, const AffineMap& map, Format format, Draw& draw,
               std::optional<int> direction_scale) {
  const Representative& x = class_row(turn.id).points;
  const Triangle t = in_random_order({image(map, x[0]), image(map, x[1]), image(map, x[2])}, draw);
  const Probe probe = is_ray_class(turn.id) ? Probe(ray_image(map, x, format, draw, direction_scale))
                                            : Probe(segment_image(map, x, draw));
  return {.query = {probe, t}, .format = format, .class_id = turn.id, .level = static_cast<std::uint16_t>(turn.level)};
}

Trial affine_image(Format format, Draw& draw, const ClassTurn& turn, int bits) {
  AffineMap map = draw_placed_map(draw, format, bits);
  draw_scale(map, draw);
  return image_of(turn, map, format, draw);
}

std::span<const int> mantissa_fills(Format format) {
  if (format == Format::binary32) return fills_32;
  return fills_64;
}

/// Every case knows its class by construction.
Family affine_family() {
  return {.name = "affine",
          .stresses = "exact degeneracies of all classes, with growing mantissa fill",
          .population = "exact affine images of the class representatives",
          .axis = "bits of the map's entries",
          .constructs = true,
          .levels = mantissa_fills,
          .make = make};
}

}  // namespace tribunal
