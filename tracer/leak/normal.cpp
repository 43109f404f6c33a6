#include "tracer/leak/normal.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "exact/kernels/dyadic.h"

namespace tribunal::leak {
namespace {

/// Divided by its largest coordinate, so that squares neither overflow nor underflow.
Vec3<double> scaled(const Point3& v) {
  const double most = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  return {v.x / most, v.y / most, v.z / most};
}

Vec3<double> scaled(const Vec3<Dyadic>& v) {
  const mpq_class x = v.x.fraction(), y = v.y.fraction(), z = v.z.fraction();
  const mpq_class most = std::max({mpq_class(abs(x)), mpq_class(abs(y)), mpq_class(abs(z))});
  return {mpq_class(x / most).get_d(), mpq_class(y / most).get_d(), mpq_class(z / most).get_d()};
}

template <class N>
N dot(const Vec3<N>& u, const Vec3<N>& v) {
  return u.x * v.x + u.y * v.y + u.z * v.z;
}

template <class N>
Vec3<N> cross(const Vec3<N>& u, const Vec3<N>& v) {
  return {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
}

}  // namespace

std::optional<double> degrees_from_normal(const Triangle& t, const Point3& v) {
  if (!is_finite(v)) return std::nullopt;
  const Vec3<Dyadic> a = lift<Dyadic>(t.a), n = cross(lift<Dyadic>(t.b) - a, lift<Dyadic>(t.c) - a);
  if (sign_of(dot(n, lift<Dyadic>(v))) != Sign::positive) return std::nullopt;
  const Vec3<double> exact = scaled(n), given = scaled(v), sine = cross(exact, given);
  return std::atan2(std::sqrt(dot(sine, sine)), dot(exact, given)) * 180 / std::numbers::pi;
}

}  // namespace tribunal::leak
