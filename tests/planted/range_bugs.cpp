// Bugs that show only where numbers leave the middle of the range: differences that overflow, numbers far apart, the
// ends of the range, probes far longer than the triangle.
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/segura_feito.h"
#include "tests/planted/bugs.h"
#include "tests/planted/range_kernels.h"

namespace tribunal::planted {
namespace {

constexpr double least_normal = std::numeric_limits<double>::min();

template <class K>
Answer by_kernel(const Segment& s, const Triangle& t) {
  return segura_feito(s, t, K{});
}

template <class K>
Answer by_kernel_of_ray(const Ray& r, const Triangle& t) {
  return segura_feito(r, t, K{});
}

std::array<Point3, 5> points_of(const Segment& s, const Triangle& t) { return {t.a, t.b, t.c, s.p, s.q}; }

Answer right(const std::array<Point3, 5>& v) { return planted::right({v[3], v[4]}, {v[0], v[1], v[2]}); }

Answer subnormal_beside_normal(const Segment& s, const Triangle& t) {
  auto v = points_of(s, t);
  for (int axis = 0; axis < 3; ++axis) {
    const bool normal = std::ranges::any_of(v, [&](const Point3& p) { return std::fabs(p[axis]) >= least_normal; });
    for (Point3& p : v) {
      if (normal && std::fabs(p[axis]) < least_normal) p[axis] = 0;
    }
  }
  return right(v);
}

double truncated(double x, int bits) {
  int e = 0;
  return std::ldexp(std::trunc(std::ldexp(std::frexp(x, &e), bits)), e - bits);
}

/// Mantissas lose their last bits where the largest number on an axis is beyond these.
Answer truncated_at_extremes(const Segment& s, const Triangle& t) {
  constexpr double small = 0x1p-900, large = 0x1p900;
  auto v = points_of(s, t);
  for (int axis = 0; axis < 3; ++axis) {
    double most = 0;
    for (const Point3& p : v) most = std::max(most, std::fabs(p[axis]));
    if (most >= small && most <= large) continue;
    for (Point3& p : v) p[axis] = truncated(p[axis], 40);
  }
  return right(v);
}

/// Squares of sizes, as fractions of the largest coordinate, so that nothing overflows.
double squared_length(const Point3& p, const Point3& q, double unit) {
  const Point3 d = q / unit - p / unit;
  return d.x * d.x + d.y * d.y + d.z * d.z;
}

Answer long_probe_lost(const Segment& s, const Triangle& t) {
  constexpr double most_sizes = 1e4;
  double unit = least_normal;
  for (const Point3& p : points_of(s, t)) unit = std::max({unit, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
  const double size = std::max(squared_length(t.a, t.b, unit), squared_length(t.a, t.c, unit));
  if (size > 0 && squared_length(s.p, s.q, unit) > most_sizes * most_sizes * size) return miss();
  return planted::right(s, t);
}

}  // namespace

std::vector<Method> range_bugs() {
  return {
      method("planted-difference-overflow", "differences that overflow are taken for exact: inf - inf decides",
             by_kernel<ExactDifferences<false>>, by_kernel_of_ray<ExactDifferences<false>>),
      method("planted-window-300", "exact numbers of 300 bits: terms more than 300 binades apart are dropped",
             by_kernel<FormulaKernel<Windowed<300>>>, by_kernel_of_ray<FormulaKernel<Windowed<300>>>),
      method("planted-subnormal-beside", "a subnormal beside a normal number is read as zero", subnormal_beside_normal),
      method("planted-truncated", "40 bits of the mantissa beyond 2^900 and below 2^-900", truncated_at_extremes),
      method("planted-long-probe", "probes longer than 10^4 triangle sizes are lost", long_probe_lost),
  };
}

}  // namespace tribunal::planted
