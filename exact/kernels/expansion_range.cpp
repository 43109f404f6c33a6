#include "exact/kernels/expansion_range.h"

#include <algorithm>
#include <bit>
#include <climits>
#include <cmath>
#include <cstdint>

namespace tribunal::detail {
namespace {

/// The exponents e of numbers 2^e ≤ |x| < 2^(e + 1) that were seen.
struct Exponents {
  int lowest = INT_MAX, highest = INT_MIN;

  void see(double x, int shift) {
    if (x == 0) return;
    const int e = std::ilogb(x) + shift;
    lowest = std::min(lowest, e);
    highest = std::max(highest, e);
  }
  bool any() const { return lowest <= highest; }

  /// The shift that takes the highest just below the range's end.
  int shift_into(const ExpansionRange& range) const { return any() ? range.end - 1 - highest : 0; }
  bool fit(const ExpansionRange& range) const { return !any() || lowest + shift_into(range) >= range.least; }
};

/// By the exponent field, which is 1023 more than the exponent, and 0 for zero and subnormal numbers.
bool is_within(const ExpansionRange& range, double x) {
  const int field = static_cast<int>(std::bit_cast<std::uint64_t>(x) >> 52 & 0x7ff);
  return (range.least + 1023 <= field && field < range.end + 1023) || x == 0;
}

bool is_within(const ExpansionRange& range, const Point3& p) {
  return is_within(range, p.x) && is_within(range, p.y) && is_within(range, p.z);
}

}  // namespace

bool is_within(const ExpansionRange& range, std::initializer_list<const Point3*> points, const Direction* direction) {
  return std::ranges::all_of(points, [&](const Point3* p) { return is_within(range, *p); }) &&
         (direction == nullptr || is_within(range, direction->v));
}

bool bring_within(const ExpansionRange& range, std::initializer_list<Point3*> points, Direction* direction) {
  int shift[3];
  Exponents of_direction;
  for (int axis = 0; axis < 3; ++axis) {
    Exponents on_axis;
    for (const Point3* p : points) on_axis.see((*p)[axis], 0);
    if (!on_axis.fit(range)) return false;
    shift[axis] = on_axis.shift_into(range);
    if (direction != nullptr) of_direction.see(direction->v[axis], shift[axis]);
  }
  if (!of_direction.fit(range)) return false;
  for (int axis = 0; axis < 3; ++axis) {
    for (Point3* p : points) (*p)[axis] = std::ldexp((*p)[axis], shift[axis]);
    if (direction == nullptr) continue;
    direction->v[axis] = std::ldexp(direction->v[axis], shift[axis] + of_direction.shift_into(range));
  }
  return true;
}

}  // namespace tribunal::detail
