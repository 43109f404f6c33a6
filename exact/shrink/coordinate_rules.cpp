#include "exact/shrink/coordinate_rules.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "exact/kernels/dyadic.h"

namespace tribunal {
namespace {

bool representable(double x, Format format) { return std::isfinite(x) && is_exact_in(x, format); }

}  // namespace

int significand_bits(double x) {
  if (x == 0) return 0;
  int exponent = 0;
  auto m = static_cast<std::uint64_t>(std::ldexp(std::frexp(std::fabs(x), &exponent), 53));
  while ((m & 1) == 0) m >>= 1;
  return 64 - __builtin_clzll(m);
}

void CoordinateCost::add(double x) {
  bits += significand_bits(x);
  exponents += x == 0 ? 0 : std::abs(std::ilogb(x));
  negatives += std::signbit(x);
}

bool translate_exactly(std::span<Point3* const> points, int axis, double by, Format format) {
  for (Point3* p : points) {
    double& x = (*p)[axis];
    const double moved = x - by;
    if (!representable(moved, format) || sign_of(Dyadic(x) - Dyadic(by) - Dyadic(moved)) != Sign::zero) return false;
    x = moved;
  }
  return true;
}

bool scale_exactly(std::span<Point3* const> points, int axis, Format format) {
  int largest = 0;
  bool any = false;
  for (const Point3* p : points) {
    if ((*p)[axis] == 0) continue;
    const int e = std::ilogb((*p)[axis]);
    largest = any ? std::max(largest, e) : e;
    any = true;
  }
  if (!any || largest == 0) return false;
  for (Point3* p : points) {
    const double scaled = std::ldexp((*p)[axis], -largest);
    if (!representable(scaled, format) || std::ldexp(scaled, largest) != (*p)[axis]) return false;
    (*p)[axis] = scaled;
  }
  return true;
}

bool replace_value(std::span<Point3* const> points, int axis, double value, double by, Format format) {
  if (by == value && !std::signbit(value)) return false;
  for (Point3* p : points) {
    if ((*p)[axis] == value) (*p)[axis] = by;
  }
  return representable(by, format);
}

std::vector<double> distinct_values(std::span<Point3* const> points, int axis) {
  std::vector<double> values;
  for (const Point3* p : points) values.push_back((*p)[axis]);
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return values;
}

std::vector<double> simpler_values(double value) {
  std::vector<double> values{0.0, 1.0, -1.0};
  const int bits = significand_bits(value);
  for (int keep = 1; keep < bits; ++keep) {
    const int drop = std::ilogb(value) + 1 - keep;
    values.push_back(std::ldexp(std::nearbyint(std::ldexp(value, -drop)), drop));
  }
  return values;
}

}  // namespace tribunal
