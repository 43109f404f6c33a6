#include "exact/filtered/stages/integer_image.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace tribunal {
namespace {

constexpr int none = -5000;  ///< below every exponent

std::uint64_t without_sign(double x) { return std::bit_cast<std::uint64_t>(x) << 1; }

/// The least e with |x| < 2^e, where `pattern` is the bit pattern of x without its sign; `none` for zero.
int top_of(std::uint64_t pattern) {
  const auto field = static_cast<int>(pattern >> 53);
  if (field != 0) return field - 1022;
  return pattern == 0 ? none : static_cast<int>(std::bit_width(pattern)) - 1075;
}

double power_of_two(int e) { return std::bit_cast<double>(static_cast<std::uint64_t>(e + 1023) << 52); }

/// Sets x to x·2^shift if that is an integer, else returns false. The result must be below 2¹⁰⁰⁰.
bool scale_any(double& x, int shift) {
  const std::uint64_t pattern = without_sign(x);
  const auto field = static_cast<int>(pattern >> 53);
  const std::uint64_t fraction = pattern << 11 >> 12;
  const std::uint64_t significand = field == 0 ? fraction : fraction | std::uint64_t{1} << 52;
  const int e = std::max(field, 1) - 1075 + shift;
  if (significand == 0) return true;
  if (e + std::countr_zero(significand) < 0) return false;
  const double magnitude = static_cast<double>(static_cast<std::int64_t>(significand)) * power_of_two(e);
  x = std::signbit(x) ? -magnitude : magnitude;
  return true;
}

/// The same by the factor 2^shift, which must be a normal number: the product is exact, unless it is no integer.
/// Whether it is below one, or zero, is read from its bits: where subnormals are read as zero, a comparison would take
/// a subnormal product for zero.
bool scale(double& x, double factor) {
  constexpr double integers_from_here = 0x1p53;
  const double y = x * factor;
  const bool below_one = without_sign(y) < without_sign(1.0) && without_sign(x) != 0;
  const bool is_integer = std::fabs(y) >= integers_from_here || static_cast<double>(static_cast<std::int64_t>(y)) == y;
  x = y;
  return is_integer && !below_one;
}

/// Scales one coordinate of all the points. Returns whether all results are integers.
bool scale_axis(std::initializer_list<Point3*> points, int axis, int shift) {
  bool fits = true;
  if (std::abs(shift) <= 1022) {
    const double factor = power_of_two(shift);
    for (Point3* p : points) fits &= scale((*p)[axis], factor);
  } else {
    for (Point3* p : points) fits &= scale_any((*p)[axis], shift);
  }
  return fits;
}

}  // namespace

bool move_to_grid(std::initializer_list<Point3*> points, Direction* direction, int bits) {
  int top[3];
  int longest = none;  // of the direction, after the axes have been scaled
  for (int axis = 0; axis < 3; ++axis) {
    std::uint64_t largest = 0;
    for (const Point3* p : points) largest = std::max(largest, without_sign((*p)[axis]));
    top[axis] = top_of(largest);
    if (direction == nullptr) continue;
    const int heading = top_of(without_sign(direction->v[axis]));
    if (top[axis] == none) top[axis] = heading;  // the points lie in a coordinate plane: any power will do
    if (heading != none) longest = std::max(longest, heading - top[axis]);
  }
  for (int axis = 0; axis < 3; ++axis) {
    if (top[axis] == none) continue;
    if (!scale_axis(points, axis, bits - top[axis])) return false;
    if (direction != nullptr && longest != none && !scale_any(direction->v[axis], bits - top[axis] - longest))
      return false;
  }
  return true;
}

}  // namespace tribunal
