#include "tracer/leak/nearness.h"

#include <algorithm>
#include <cmath>

#include "core/vec3.h"
#include "exact/cases/families/ulp.h"
#include "exact/filtered/filtered.h"
#include "exact/kernels/dyadic.h"

namespace tribunal::leak {
namespace {

/// The ray {o + t·d} and the line {a + u·e}, with k = a − o and n = e × d. Their distance is |k·n| / |n|.
template <class N>
struct Lines {
  Vec3<N> d, e, k, n;

  Lines(const Ray& r, const Point3& a, const Point3& b)
      : d(lift<N>(r.d.v)), e(lift<N>(b) - lift<N>(a)), k(lift<N>(a) - lift<N>(r.o)), n(cross(e, d)) {}

  N volume() const { return dot(k, n); }
  N normal_squared() const { return dot(n, n); }
  /// Times |n|², where they come closest: on the line a + u·e, and on the ray.
  N u() const { return -dot(k, cross(d, n)); }
  N t() const { return -dot(k, cross(e, n)); }
};

/// Products of squares below this may have lost digits to underflow; above the other, they may overflow.
constexpr double least_safe = 1e-200, most_safe = 1e200;

bool is_safe(double square) { return square > least_safe && square < most_safe; }

/// Whether the point is certainly far: the rounded distance is beyond eight times the limit, and rounding moves it by
/// less than seven.
bool is_far(const Ray& r, const Point3& p, double limit) {
  const Vec3<double> d = lift<double>(r.d.v), c = cross(lift<double>(p) - lift<double>(r.o), d);
  const double distance = dot(c, c), length = dot(d, d);
  return is_safe(distance) && is_safe(length) && std::sqrt(distance) > 8 * limit * std::sqrt(length);
}

bool is_far(const Ray& r, const Point3& a, const Point3& b, double limit) {
  const Lines<double> lines(r, a, b);
  const double n = lines.normal_squared(), e = dot(lines.e, lines.e), d = dot(lines.d, lines.d),
               k = dot(lines.k, lines.k), volume = lines.volume();
  if (!is_safe(volume * volume) || !is_safe(n) || !is_safe(e * d) || !is_safe(e * d * k)) return false;
  constexpr double rounding = 0x1p-46;  // 128 unit roundoffs of the product of the lengths
  return std::abs(volume) > 8 * limit * std::sqrt(n) + rounding * std::sqrt(e * d * k);
}

bool is_at_most(const Dyadic& a, const Dyadic& b) { return sign_of(a - b) != Sign::positive; }
bool is_no_less_than_zero(const Dyadic& a) { return sign_of(a) != Sign::negative; }

}  // namespace

double Nearness::slack(std::initializer_list<Point3> points) const {
  double most = 0;
  const auto add = [&](const Point3& p) { most = std::max({most, std::abs(p.x), std::abs(p.y), std::abs(p.z)}); };
  add(ray_.o);
  for (const Point3& p : points) add(p);
  return 16 * std::max(moved_by_ulps(most, 1, format_) - most, most - moved_by_ulps(most, -1, format_));
}

bool Nearness::has(const Point3& p) const {
  const double limit = slack({p});
  if (is_far(ray_, p, limit)) return false;
  const Vec3<Dyadic> d = lift<Dyadic>(ray_.d.v), k = lift<Dyadic>(p) - lift<Dyadic>(ray_.o), c = cross(k, d);
  const Dyadic most = Dyadic(limit) * Dyadic(limit) * dot(d, d);
  return is_no_less_than_zero(dot(k, d)) && is_at_most(dot(c, c), most);
}

bool Nearness::has(const Point3& a, const Point3& b) const {
  const double limit = slack({a, b});
  if (is_far(ray_, a, b, limit)) return false;
  const Lines<Dyadic> lines(ray_, a, b);
  const Dyadic n = lines.normal_squared(), volume = lines.volume();
  if (sign_of(n) == Sign::zero) return false;
  if (!is_at_most(volume * volume, Dyadic(limit) * Dyadic(limit) * n)) return false;
  const Dyadic u = lines.u();
  return is_no_less_than_zero(lines.t()) && is_no_less_than_zero(u) && is_at_most(u, n);
}

bool Nearness::source_is_at(const Triangle& t) const {
  const double step = slack({t.a, t.b, t.c});
  const auto is_beside = [&](int axis) {
    const auto [lo, hi] = std::minmax({t.a[axis], t.b[axis], t.c[axis]});
    return ray_.o[axis] < lo - step || ray_.o[axis] > hi + step;
  };
  if (is_beside(0) || is_beside(1) || is_beside(2)) return false;
  for (int signs = 0; signs < 8; ++signs) {
    const Point3 move((signs & 1) != 0 ? step : -step, (signs & 2) != 0 ? step : -step,
                      (signs & 4) != 0 ? step : -step);
    if (hits(Segment{ray_.o, ray_.o + move}, t)) return true;
  }
  return false;
}

}  // namespace tribunal::leak
