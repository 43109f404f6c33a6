// The first stage computes an interval that certainly holds λ = n/d, and answers where both of its ends round to the
// same number.
//
// Bounds. The arms of a volume are sums of two doubles, so exact. A term uᵢ·vⱼ·wₖ then passes five operations on its
// way into det3: two products, the minor's difference and two sums. Each is off by 2⁻¹⁰³ at most, so the volume is off
// by (1 + 2⁻¹⁰³)⁵ − 1 < 2⁻¹⁰⁰ of the sum T of the terms' magnitudes. T is computed in double, from rounded arms, and
// comes out at no less than (1 − 2⁻⁵²)⁸ of what it is: 2⁻⁹⁹·T suffices. With arms below 2¹⁵⁰ nothing overflows; a part
// that underflows is off by 2⁻¹⁰⁷⁴, times at most two arms; that is far below `tiny` = 2⁻⁷⁰⁰.
//
// The quotient. q₁ = n.hi/d.hi rounded is within 2⁻⁵¹ of n/d, so that r = n − q₁·d, which two operations compute to
// within 2·2⁻¹⁰³ of |n| and a little, is at most 2⁻⁵⁰·|n|; q₂ = r.hi/d.hi drops r.lo and d.lo and is rounded: 3·2⁻⁵³
// of |q₂| ≤ 2⁻⁴⁹·|q₁|. Together q₁ + q₂ is within 2⁻⁹⁹ of n/d, relatively.
//
// With |N − n| ≤ e and |D − d| ≤ g, both below 2⁻⁶⁰ of |n| and |d|, N/D is within (e/|n| + g/|d|)·(1 + 2⁻⁵⁸) of n/d,
// relatively. `slack` below is twice that and 2⁻⁹⁷, which also covers its own roundings and those of q₂ ± slack, 2⁻⁵³
// of q₂. Rounding is monotone, so if q₁ + (q₂ − slack) and q₁ + (q₂ + slack) round to one number, then N/D does.
#include "exact/filtered/rounded_parameter.h"

#include <cmath>

#include "core/kernel.h"
#include "exact/filtered/double_double.h"
#include "exact/filtered/hit_fraction.h"
#include "exact/filtered/stages/default_rounding.h"
#include "exact/filtered/term_filter.h"

namespace tribunal {

using namespace detail;

namespace {

/// A signed volume in twice the precision, and a bound of its relative error: 1 or more where nothing is known.
struct CloseVolume {
  DoubleDouble value;
  double error;
};

template <class X>
CloseVolume close_volume(const Triangle& t, const X& x) {
  const Vec3<double> a = lift<double>(t.a), u = arm<double>(a, t.b), v = arm<double>(a, t.c), w = arm<double>(a, x);
  const FilterConstants<double>& range = volume_terms_filter;
  if (!in_range(largest(u, v, w), range)) return {DoubleDouble(), 1};
  const DoubleDouble value = signed_volume<DoubleDouble>(t.a, t.b, t.c, x);
  return {value, (0x1p-99 * expanded(u, v, w).terms + range.tiny) / std::fabs(value.hi)};
}

bool is_close(const CloseVolume& v) { return v.error < 0x1p-60; }

}  // namespace

std::optional<double> filter_rounded_parameter(const Ray& r, const Triangle& t) {
  const CloseVolume n = close_volume(t, r.o), gain = close_volume(t, r.d);
  if (!is_close(n) || !is_close(gain)) return std::nullopt;
  const DoubleDouble d = -gain.value;
  const double q = n.value.hi / d.hi, magnitude = std::fabs(q);
  if (!(magnitude > 0x1p-900 && magnitude < 0x1p900)) return std::nullopt;
  const DoubleDouble rest = n.value - DoubleDouble(q) * d;
  const double correction = rest.hi / d.hi, slack = magnitude * (2 * (n.error + gain.error) + 0x1p-97);
  const double least = q + (correction - slack), greatest = q + (correction + slack);
  if (least != greatest) return std::nullopt;
  return least;
}

double rounded_parameter(const Ray& r, const Triangle& t) {
  const DefaultRounding in_this_scope;
  if (const std::optional<double> certain = filter_rounded_parameter(r, t)) return *certain;
  return rounded(hit_fraction(r, t));
}

}  // namespace tribunal
