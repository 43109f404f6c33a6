// A static filter before the exact volume, with its constant or its guards spoilt. The sound constant for the volume of
// rounded differences, 5.107e-15·max|x|·max|y|·max|z|, is that of core's error analysis; a filter that cannot decide
// goes to EPICK.
#include <algorithm>
#include <cmath>

#include "core/segura_feito.h"
#include "exact/methods/cgal_kernels.h"
#include "tests/planted/bugs.h"

namespace tribunal::planted {
namespace {

constexpr double sound_constant = 5.107e-15;

struct Filter {
  double constant = sound_constant;
  bool underflow_guard = true, overflow_guard = true;
};

double largest(double o, double b, double c, double x) {
  return std::max({std::fabs(b - o), std::fabs(c - o), std::fabs(x - o)});
}

/// Products of three differences within these neither overflow nor lose more to underflow than the bound has to spare.
constexpr double smallest_safe = 0x1p-320, largest_safe = 0x1p338;

struct FilteredKernel : EpickKernel {
  Filter filter;

  explicit FilteredKernel(const Filter& f) : filter(f) {}

  /// Certain unless |volume| < bound: a NaN compares false, so the overflow guard is not for speed.
  Sign orient3d(const Point3& a, const Point3& b, const Point3& c, const Point3& x) const {
    const double mx = largest(a.x, b.x, c.x, x.x), my = largest(a.y, b.y, c.y, x.y), mz = largest(a.z, b.z, c.z, x.z);
    const double least = std::min({mx, my, mz}), most = std::max({mx, my, mz});
    const bool unsafe =
        (filter.underflow_guard && !(least > smallest_safe)) || (filter.overflow_guard && !(most < largest_safe));
    const double volume = signed_volume<double>(a, b, c, x);
    if (unsafe || std::fabs(volume) < filter.constant * mx * my * mz) return EpickKernel::orient3d(a, b, c, x);
    return sign_of(volume);
  }

  Sign orient3d(const Point3& a, const Point3& b, const Point3& c, const Direction& d) const {
    return EpickKernel::orient3d(a, b, c, d);
  }
};

Method filtered(const char* name, const char* what, const Filter& filter) {
  return method(name, what, [kernel = FilteredKernel(filter)](const Segment& s, const Triangle& t) {
    return segura_feito(s, t, kernel);
  });
}

}  // namespace

std::vector<Method> filter_bugs() {
  return {
      filtered("planted-filter-16", "filter constant 16 times too small", {.constant = sound_constant / 16}),
      filtered("planted-filter-64", "filter constant 64 times too small", {.constant = sound_constant / 64}),
      filtered("planted-filter-0", "filter constant 0", {.constant = 0}),
      filtered("planted-long-double", "bounds for long double on double: 2^11 times too small",
               {.constant = sound_constant / 2048}),
      filtered("planted-no-underflow", "no underflow guard", {.underflow_guard = false}),
      filtered("planted-no-overflow", "no overflow guard: a NaN compares false, so it is certain",
               {.overflow_guard = false}),
  };
}

Method sound_filter() { return filtered("sound-filter", "static filter, then EPICK", {}); }

}  // namespace tribunal::planted
