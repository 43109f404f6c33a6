// Small parts that families are made of: random points, rounding, combinations.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>

#include "exact/cases/families/draw.h"
#include "exact/cases/families/family.h"

namespace tribunal {

constexpr int digits_of(Format format) { return format == Format::binary32 ? 24 : 53; }

/// The exponents of the least subnormal number and of the largest binade: every number of the format is a multiple of
/// the first power of two and less than twice the second.
constexpr int least_exponent(Format format) { return format == Format::binary32 ? -149 : -1074; }
constexpr int largest_exponent(Format format) { return format == Format::binary32 ? 127 : 1023; }

/// The levels of a stress axis in each format.
template <auto& wide, auto& narrow>
std::span<const int> by_format(Format format) {
  if (format == Format::binary32) return narrow;
  return wide;
}

/// Bits of integer coordinates, or of the entries of a map, that leave room for sums of a few of them.
inline constexpr int lattice_bits_64[] = {4, 12, 20, 30, 40, 48};
inline constexpr int lattice_bits_32[] = {4, 8, 12, 16, 19};
inline constexpr auto lattice_bits = by_format<lattice_bits_64, lattice_bits_32>;

/// One of the levels, or, every other time, any number from the first to the last.
inline int draw_near_levels(Draw& draw, std::span<const int> levels) {
  const bool exactly = draw.below(2) == 0;
  if (exactly) return levels[draw.below(levels.size())];
  return static_cast<int>(draw.between(levels.front(), levels.back()));
}

/// x·2^e, what std::ldexp gives: without a call where 2^e is a normal number, since one product rounds once as well.
inline double times_power_of_two(double x, int e) {
  if (e < -1022 || e > 1023) return std::ldexp(x, e);
  return x * std::bit_cast<double>(static_cast<std::uint64_t>(e + 1023) << 52);
}

/// Uniform in [−1, 1] with a full significand of the format.
inline double draw_real(Draw& draw, Format format) {
  const int digits = digits_of(format);
  const std::int64_t limit = std::int64_t{1} << digits;
  return static_cast<double>(draw.between(-limit, limit)) / static_cast<double>(limit);
}

inline Point3 draw_point(Draw& draw, Format format) {
  Point3 p;
  for (int axis = 0; axis < 3; ++axis) p[axis] = draw_real(draw, format);
  return p;
}

inline Triangle draw_triangle(Draw& draw, Format format) {
  Triangle t;
  t.a = draw_point(draw, format);
  t.b = draw_point(draw, format);
  t.c = draw_point(draw, format);
  return t;
}

/// Integer coordinates of up to `bits` bits, all multiples of `step`.
inline Point3 draw_lattice_point(Draw& draw, int bits, int step) {
  const std::int64_t limit = (std::int64_t{1} << bits) / step;
  Point3 p;
  for (int axis = 0; axis < 3; ++axis) p[axis] = static_cast<double>(step * draw.between(-limit, limit));
  return p;
}

/// A point of the triangle's plane with barycentric coordinates in about [−0.25, 1.25], rounded, so only near the
/// plane; inside or outside the triangle.
inline Point3 draw_in_plane(Draw& draw, Format format, const Triangle& t) {
  const double u = 0.5 + 0.75 * draw_real(draw, format);
  const double v = 0.5 + 0.75 * draw_real(draw, format);
  return in_format(t.a + u * (t.b - t.a) + v * (t.c - t.a), format);
}

/// The segment from x + v to x − w, rounded, so only nearly through x.
inline Segment through(const Point3& x, const Point3& v, const Point3& w) { return {x + v, x - w}; }

/// The segment through x exactly, where x ± v are integers that the format holds.
inline Segment through_exactly(const Point3& x, const Point3& v) { return {x + v, x - v}; }

}  // namespace tribunal
