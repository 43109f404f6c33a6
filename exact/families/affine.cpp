#include "exact/families/affine.h"

#include <algorithm>
#include <cmath>

#include "exact/classes/class_table.h"
#include "exact/families/shapes.h"
#include "exact/families/table.h"

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

/// Within what 7·2^bits leaves of the format's integers.
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

Point3 image(const AffineMap& map, const std::array<int, 3>& x) {
  double y[3];
  for (std::size_t i = 0; i < 3; ++i) {
    std::int64_t sum = map.offset[i];
    for (std::size_t j = 0; j < 3; ++j) sum += map.m[i][j] * x[j];
    y[i] = map.scale[i] == 0 ? static_cast<double>(sum) : std::ldexp(static_cast<double>(sum), map.scale[i]);
  }
  return {y[0], y[1], y[2]};
}

Trial make(Format format, std::uint64_t seed, std::uint64_t k) {
  Draw draw(1, seed, k);
  const auto fills = mantissa_fills(format);
  const std::size_t level = k / class_count % fills.size();
  return affine_image(format, draw, k, fills[level], level);
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

Trial image_of(ClassId id, const AffineMap& map, Format format, std::size_t level, Draw& draw) {
  const auto& x = class_row(id).points;
  const Triangle t{image(map, x[0]), image(map, x[1]), image(map, x[2])};
  const Segment s{image(map, x[3]), image(map, x[4])};
  return shuffled({.query = {s, t}, .format = format, .class_id = id, .level = static_cast<std::uint16_t>(level)},
                  draw);
}

Trial affine_image(Format format, Draw& draw, std::uint64_t k, int bits, std::size_t level) {
  AffineMap map = draw_map(draw, bits);
  draw_offset(map, draw, format, bits);
  draw_scale(map, draw);
  return image_of(static_cast<ClassId>(1 + k % class_count), map, format, level, draw);
}

std::span<const int> mantissa_fills(Format format) {
  if (format == Format::binary32) return fills_32;
  return fills_64;
}

/// Case k is an image of class k mod 163, at level (k / 163) mod (number of levels): the construction is the oracle.
Family affine_family() {
  return {.name = "affine",
          .stresses = "exact degeneracies of all 163 classes, with growing mantissa fill",
          .population = "exact affine images of the class representatives",
          .axis = "bits of the map's entries",
          .proves_class = true,
          .levels = mantissa_fills,
          .make = make};
}

}  // namespace tribunal
