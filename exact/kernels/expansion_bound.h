// Signs that an error bound makes certain: the first stage of the adaptive kernel.
// Source: J. R. Shewchuk, "Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates", Discrete
// & Computational Geometry 18, 1997, doi:10.1007/PL00009321, stage A; the constants are derived here, for our formula.
#pragma once

#include <cmath>
#include <optional>

#include "core/operands.h"
#include "core/sign.h"
#include "core/signed_volume.h"

namespace tribunal::detail {

/// A number type that adds where others subtract: the formula on the magnitudes of its operands is then its permanent,
/// the sum of the magnitudes of its monomials.
struct Magnitude {
  double value = 0;

  Magnitude() = default;
  explicit Magnitude(double x) : value(std::fabs(x)) {}

  friend Magnitude operator+(const Magnitude& a, const Magnitude& b) { return Magnitude(a.value + b.value); }
  friend Magnitude operator-(const Magnitude& a, const Magnitude& b) { return Magnitude(a.value + b.value); }
  friend Magnitude operator*(const Magnitude& a, const Magnitude& b) { return Magnitude(a.value * b.value); }
};

inline Vec3<Magnitude> magnitudes(const Vec3<double>& v) { return {Magnitude(v.x), Magnitude(v.y), Magnitude(v.z)}; }

/// A formula in double, with its permanent.
struct Estimate {
  double value, permanent;
};

/// Where bounds allow for products that underflow by 2⁻¹⁰⁷⁵ each: far more, so that no bound is a subnormal number,
/// with which processors are slow.
inline constexpr double far_above_underflow = 0x1p-960;

/// The value's sign, if |value| > operations·u·permanent + underflow, where u = 2⁻⁵³ and `operations` is one more than
/// the most roundings that a monomial goes through. Nothing where something overflows: then the bound is infinite, or
/// no number.
///
/// A monomial that goes through n roundings comes out as itself times a factor within (1 ± u)ⁿ. So value is off by at
/// most ((1 + u)ⁿ − 1)·P, P the exact permanent, and the computed one is at least (1 − u)ⁿ·P. The quotient is below
/// n·u·(1 + 2n·u), and the bound's own rounding adds a factor 1 + 2u: together less than (n + 1)·u for n < 2²⁰. Where
/// products underflow they are off by 2⁻¹⁰⁷⁵ more each; `underflow` is to be twice what that makes of value and
/// permanent.
inline std::optional<Sign> certain(const Estimate& e, int operations, double underflow) {
  if (std::fabs(e.value) > operations * 0x1p-53 * e.permanent + underflow) return sign_of(e.value);
  return std::nullopt;
}

/// n = 8: three differences, two products, and the sums of a minor and of two more minors.
inline constexpr int volume_operations = 9;
/// n = 9: the same and the sum of a point of a ray, whose product stands beside a difference.
inline constexpr int ray_point_volume_operations = 10;
/// n = 4: two differences, a product, a sum.
inline constexpr int area_operations = 5;
/// n = 5: the same of a point of a ray.
inline constexpr int ray_point_area_operations = 6;
/// n = 18: two volumes, their product, a sum.
inline constexpr int order_operations = 19;

inline Estimate volume_of(const Vec3<double>& u, const Vec3<double>& v, const Vec3<double>& w) {
  return {det3(u, v, w), det3(magnitudes(u), magnitudes(v), magnitudes(w)).value};
}

template <class X>
Estimate estimated_volume(const Point3& a, const Point3& b, const Point3& c, const X& x) {
  const Vec3<double> o = lift<double>(a);
  return volume_of(arm<double>(o, b), arm<double>(o, c), arm<double>(o, x));
}

/// Two products of a minor underflow by 2⁻¹⁰⁷⁵ each and are multiplied by a coordinate of u = b − a, three more are
/// added: 2⁻¹⁰⁷⁴·(|u.x| + |u.y| + |u.z|) + 3·2⁻¹⁰⁷⁵.
template <class X>
std::optional<Sign> volume_by_bound(const Point3& a, const Point3& b, const Point3& c, const X& x) {
  const Vec3<double> u = arm<double>(lift<double>(a), b);
  const double underflow =
      far_above_underflow * (std::fabs(u.x) + std::fabs(u.y) + std::fabs(u.z)) + far_above_underflow;
  return certain(estimated_volume(a, b, c, x), volume_operations, underflow);
}

/// The magnitudes of the arm from a to a point of a ray, before they cancel: |o − a| + t·|d| on each axis.
inline Vec3<double> arm_terms(const Point3& a, const RayPoint& x) {
  const Vec3<double> o = arm<double>(lift<double>(a), x.ray.o), d = lift<double>(x.ray.d.v);
  return {std::fabs(o.x) + x.t * std::fabs(d.x), std::fabs(o.y) + x.t * std::fabs(d.y),
          std::fabs(o.z) + x.t * std::fabs(d.z)};
}

/// Where a point of a ray takes part: its arm w has two terms on each axis, and both count as such. Beside the products
/// above, each product t·d underflows by 2⁻¹⁰⁷⁵ and is multiplied by a minor of u and v.
inline std::optional<Sign> volume_by_bound(const Point3& a, const Point3& b, const Point3& c, const RayPoint& x) {
  const Vec3<double> o = lift<double>(a), u = arm<double>(o, b), v = arm<double>(o, c);
  const auto sum = [](const Vec3<double>& m) { return std::fabs(m.x) + std::fabs(m.y) + std::fabs(m.z); };
  const double lengths = (sum(u) + 1) * (sum(v) + 1);
  const Estimate volume{det3(u, v, arm<double>(o, x)),
                        det3(magnitudes(u), magnitudes(v), magnitudes(arm_terms(a, x))).value};
  return certain(volume, ray_point_volume_operations, far_above_underflow * lengths);
}

/// Two products underflow.
template <class X>
std::optional<Sign> area_by_bound(Axis dropped, const Point3& a, const Point3& b, const X& x) {
  const Vec3<double> o = lift<double>(a);
  const Vec2<double> f = project<double>(arm<double>(o, b), dropped), g = project<double>(arm<double>(o, x), dropped);
  const Estimate area{f.u * g.v - f.v * g.u, std::fabs(f.u * g.v) + std::fabs(f.v * g.u)};
  return certain(area, area_operations, far_above_underflow);
}

/// The same of a point of a ray: 2⁻¹⁰⁷⁵ in each t·d, times a coordinate of b − a.
inline std::optional<Sign> area_by_bound(Axis dropped, const Point3& a, const Point3& b, const RayPoint& x) {
  const Vec3<double> o = lift<double>(a);
  const Vec2<double> f = project<double>(arm<double>(o, b), dropped), g = project<double>(arm<double>(o, x), dropped);
  const Vec2<double> terms = project<double>(arm_terms(a, x), dropped);
  const Estimate area{f.u * g.v - f.v * g.u, std::fabs(f.u * terms.v) + std::fabs(f.v * terms.u)};
  return certain(area, ray_point_area_operations, far_above_underflow * (std::fabs(f.u) + std::fabs(f.v) + 1));
}

}  // namespace tribunal::detail
