#include "exact/families/affine.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "exact/classes/class_table.h"

namespace tribunal {
namespace {

constexpr int fills_64[] = {0, 8, 16, 17, 20, 30, 40, 50};
constexpr int fills_32[] = {0, 4, 7, 8, 12, 16, 21};

using Row = std::array<std::int64_t, 3>;

struct AffineMap {
  std::array<Row, 3> m;
  Row offset;
  std::array<int, 3> scale;  ///< power of two of each axis
};

/// The determinant modulo 2⁶⁴. Nonzero there implies nonzero; the converse fails for one matrix in about 2⁶⁴.
std::uint64_t determinant(const std::array<Row, 3>& m) {
  const auto u = [&](std::size_t i, std::size_t j) { return static_cast<std::uint64_t>(m[i][j]); };
  return u(0, 0) * (u(1, 1) * u(2, 2) - u(1, 2) * u(2, 1)) + u(0, 1) * (u(1, 2) * u(2, 0) - u(1, 0) * u(2, 2)) +
         u(0, 2) * (u(1, 0) * u(2, 1) - u(1, 1) * u(2, 0));
}

std::array<Row, 3> draw_matrix(Draw& draw, int bits) {
  const std::int64_t limit = std::int64_t{1} << bits;
  std::array<Row, 3> m;
  do {
    for (Row& row : m) {
      for (std::int64_t& entry : row) entry = draw.between(-limit, limit);
    }
  } while (determinant(m) == 0);
  return m;
}

/// |M·x| ≤ 7·2^bits, since the coordinates of a representative sum to at most 7. With |offset| at most what that
/// leaves of 2^digits, every coordinate of the image is an integer that the format holds.
Row draw_offset(Draw& draw, Format format, int bits) {
  if (draw.below(2) == 0) return {0, 0, 0};
  const int digits = format == Format::binary32 ? 24 : 53;
  const std::int64_t room = (std::int64_t{1} << digits) - 7 * (std::int64_t{1} << bits);
  const std::int64_t limit = std::min(room, std::int64_t{1} << (digits - 1));
  Row offset;
  for (std::int64_t& o : offset) o = draw.between(-limit, limit);
  return offset;
}

std::array<int, 3> draw_scale(Draw& draw) {
  if (draw.below(4) != 0) return {0, 0, 0};
  std::array<int, 3> scale;
  for (int& s : scale) s = static_cast<int>(draw.between(-12, 12));
  return scale;
}

Point3 image(const AffineMap& map, const std::array<int, 3>& x) {
  double y[3];
  for (std::size_t i = 0; i < 3; ++i) {
    std::int64_t sum = map.offset[i];
    for (std::size_t j = 0; j < 3; ++j) sum += map.m[i][j] * x[j];
    y[i] = std::ldexp(static_cast<double>(sum), map.scale[i]);
  }
  return {y[0], y[1], y[2]};
}

Trial make(Format format, std::uint64_t seed, std::uint64_t k) {
  Draw draw(1, seed, k);
  return affine_image(format, draw, k);
}

}  // namespace

std::span<const int> mantissa_fills(Format format) {
  if (format == Format::binary32) return fills_32;
  return fills_64;
}

Trial affine_image(Format format, Draw& draw, std::uint64_t k) {
  const auto fills = mantissa_fills(format);
  const auto id = static_cast<ClassId>(1 + k % class_count);
  const auto level = static_cast<std::uint16_t>(k / class_count % fills.size());
  const int bits = fills[level];
  AffineMap map;
  map.m = draw_matrix(draw, bits);
  map.offset = draw_offset(draw, format, bits);
  map.scale = draw_scale(draw);
  const auto& x = class_row(id).points;
  const std::uint64_t first = draw.below(3);
  const std::uint64_t second = (first + 1 + draw.below(2)) % 3;
  const std::uint64_t source = draw.below(2);
  const Triangle t{image(map, x[first]), image(map, x[second]), image(map, x[3 - first - second])};
  const Segment s{image(map, x[3 + source]), image(map, x[4 - source])};
  return {.query = {s, t}, .format = format, .class_id = id, .level = level};
}

Family affine_family() {
  return {.name = "affine",
          .stresses = "exact degeneracies of all 163 classes, with growing mantissa fill",
          .population = "exact affine images of the class representatives",
          .axis = "bits of the map's entries",
          .levels = mantissa_fills,
          .make = make};
}

}  // namespace tribunal
