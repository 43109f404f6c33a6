#include "exact/kernels/extended_rational.h"

#include <cmath>
#include <utility>

namespace tribunal {
namespace {

using Denominator = std::optional<Dyadic>;

Dyadic times(const Dyadic& x, const Denominator& d) { return d ? x * *d : x; }

Denominator product(const Denominator& a, const Denominator& b) {
  if (!a) return b;
  return b ? Denominator(*a * *b) : a;
}

Sign order(const Dyadic& a, const Dyadic& b) {
  const Dyadic difference = a - b;
  return sign_of(difference);
}

bool are_equal(const Denominator& a, const Denominator& b) {
  if (!a || !b) return !a && !b;
  return order(*a, *b) == Sign::zero;
}

Dyadic signed_sum(const Dyadic& a, const Dyadic& b, bool minus) { return minus ? a - b : a + b; }

}  // namespace

ExtendedRational::ExtendedRational(double x) {
  if (std::isfinite(x)) {
    num_ = Dyadic(x);
  } else {
    *this = infinity(std::isnan(x) ? Sign::zero : sign_of(x));
  }
}

ExtendedRational::ExtendedRational(Dyadic num, Denominator den) : num_(std::move(num)), den_(std::move(den)) {
  if (sign() == Sign::zero) den_.reset();
}

ExtendedRational ExtendedRational::infinity(Sign sign) {
  ExtendedRational x(value(sign));
  x.finite_ = false;
  return x;
}

mpq_class ExtendedRational::fraction() const {
  const mpq_class num = num_.fraction();
  return den_ ? mpq_class(num / den_->fraction()) : num;
}

ExtendedRational ExtendedRational::operator-() const { return sum(ExtendedRational(), *this, true); }

ExtendedRational ExtendedRational::sum(const ExtendedRational& a, const ExtendedRational& b, bool minus) {
  if (!b.is_finite()) {
    const Sign s = minus ? -b.sign() : b.sign();
    return a.is_finite() || a.sign() == s ? infinity(s) : infinity(Sign::zero);
  }
  if (!a.is_finite()) return a;
  if (are_equal(a.den_, b.den_)) return {signed_sum(a.num_, b.num_, minus), a.den_};
  return {signed_sum(times(a.num_, b.den_), times(b.num_, a.den_), minus), product(a.den_, b.den_)};
}

ExtendedRational operator*(const ExtendedRational& a, const ExtendedRational& b) {
  if (!a.is_finite() || !b.is_finite()) return ExtendedRational::infinity(a.sign() * b.sign());
  return {a.num_ * b.num_, product(a.den_, b.den_)};
}

ExtendedRational operator/(const ExtendedRational& a, const ExtendedRational& b) {
  if (!b.is_finite()) {
    return b.is_nan() || !a.is_finite() ? ExtendedRational::infinity(Sign::zero) : ExtendedRational();
  }
  if (b.sign() == Sign::zero) return ExtendedRational::infinity(a.sign());
  if (!a.is_finite()) return ExtendedRational::infinity(a.sign() * b.sign());
  const bool flip = b.sign() == Sign::negative;
  const Dyadic num = times(a.num_, b.den_), den = times(b.num_, a.den_);
  return {flip ? -num : num, flip ? -den : den};
}

bool operator==(const ExtendedRational& a, const ExtendedRational& b) {
  if (a.is_nan() || b.is_nan()) return false;
  if (!a.is_finite() || !b.is_finite()) return a.is_finite() == b.is_finite() && a.sign() == b.sign();
  return order(times(a.num_, b.den_), times(b.num_, a.den_)) == Sign::zero;
}

bool operator<(const ExtendedRational& a, const ExtendedRational& b) {
  if (a.is_nan() || b.is_nan()) return false;
  if (a.sign() != b.sign()) return a.sign() < b.sign();
  if (!a.is_finite() || !b.is_finite()) {
    if (a.is_finite() == b.is_finite()) return false;
    return a.is_finite() ? b.sign() == Sign::positive : a.sign() == Sign::negative;
  }
  return order(times(a.num_, b.den_), times(b.num_, a.den_)) == Sign::negative;
}

}  // namespace tribunal
