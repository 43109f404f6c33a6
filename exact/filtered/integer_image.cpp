#include "exact/filtered/integer_image.h"

#include <algorithm>
#include <bit>
#include <cstdint>

namespace tribunal {
namespace {

constexpr int none = -5000;  ///< below every exponent

/// ±significand · 2^exponent.
struct Parts {
  std::uint64_t significand;
  int exponent;
  bool negative;

  explicit Parts(double x) {
    const auto pattern = std::bit_cast<std::uint64_t>(x);
    const auto field = static_cast<int>(pattern >> 52 & 0x7ff);
    significand = (pattern & 0xfffffffffffff) | (field == 0 ? 0 : std::uint64_t{1} << 52);
    exponent = std::max(field, 1) - 1075;
    negative = pattern >> 63 != 0;
  }

  /// Of the binade above; zero has none.
  int top() const { return significand == 0 ? none : exponent + static_cast<int>(std::bit_width(significand)); }
};

double power_of_two(int e) { return std::bit_cast<double>(static_cast<std::uint64_t>(e + 1023) << 52); }

/// x·2^shift, if that is an integer: no other operation than the exact scaling of a normal number.
bool scale(double& x, int shift) {
  const Parts parts(x);
  if (parts.significand == 0) {
    x = 0;
    return true;
  }
  const int e = parts.exponent + shift;
  if (e + std::countr_zero(parts.significand) < 0) return false;
  const auto magnitude = static_cast<double>(static_cast<std::int64_t>(parts.significand)) * power_of_two(e);
  x = parts.negative ? -magnitude : magnitude;
  return true;
}

}  // namespace

bool move_to_grid(std::initializer_list<Point3*> points, Direction* direction, int bits) {
  int top[3] = {none, none, none};
  int longest = none;  // of the direction, after the axes have been scaled
  for (int axis = 0; axis < 3; ++axis) {
    for (const Point3* p : points) top[axis] = std::max(top[axis], Parts((*p)[axis]).top());
    if (direction == nullptr) continue;
    const int heading = Parts(direction->v[axis]).top();
    if (top[axis] == none) top[axis] = heading;  // the points lie in a coordinate plane: any power will do
    if (heading != none) longest = std::max(longest, heading - top[axis]);
  }
  bool fits = true;
  for (int axis = 0; axis < 3; ++axis) {
    for (Point3* p : points) fits = fits && scale((*p)[axis], bits - top[axis]);
    if (direction != nullptr) fits = fits && scale(direction->v[axis], bits - top[axis] - longest);
  }
  return fits;
}

}  // namespace tribunal
