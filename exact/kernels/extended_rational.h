// Rational numbers with infinities and NaN: IEEE arithmetic without rounding. Published tests divide by zero and rely
// on the result; on this type they run exactly.
#pragma once

#include <gmpxx.h>

#include <optional>

#include "exact/kernels/dyadic.h"

namespace tribunal {

/// A rational number, ±∞, or NaN. x/0 is ∞ with the sign of x, 0/0, 0·∞, ∞ − ∞ and ∞/∞ are NaN, x/∞ is 0. NaN compares
/// false with everything, itself included. There is one zero, without a sign: 1/(−0) is +∞.
/// Laws: conversion from a double is exact, and so are + − × / and comparisons of finite numbers.
/// Fractions are not reduced: published tests divide once or twice, and a gcd for each sum costs more than long
/// numbers.
class ExtendedRational {
 public:
  ExtendedRational() = default;
  ExtendedRational(int x) : num_(static_cast<double>(x)) {}
  explicit ExtendedRational(double x);

  friend ExtendedRational operator+(const ExtendedRational& a, const ExtendedRational& b) { return sum(a, b, false); }
  friend ExtendedRational operator-(const ExtendedRational& a, const ExtendedRational& b) { return sum(a, b, true); }
  friend ExtendedRational operator*(const ExtendedRational& a, const ExtendedRational& b);
  friend ExtendedRational operator/(const ExtendedRational& a, const ExtendedRational& b);
  ExtendedRational operator-() const;

  friend bool operator==(const ExtendedRational& a, const ExtendedRational& b);
  friend bool operator<(const ExtendedRational& a, const ExtendedRational& b);
  friend bool operator!=(const ExtendedRational& a, const ExtendedRational& b) { return !(a == b); }
  friend bool operator>(const ExtendedRational& a, const ExtendedRational& b) { return b < a; }
  friend bool operator<=(const ExtendedRational& a, const ExtendedRational& b) { return a < b || a == b; }
  friend bool operator>=(const ExtendedRational& a, const ExtendedRational& b) { return b <= a; }

  bool is_nan() const { return !finite_ && sign() == Sign::zero; }
  bool is_finite() const { return finite_; }

  /// The number itself, which must be finite.
  mpq_class fraction() const;

 private:
  ExtendedRational(Dyadic num, std::optional<Dyadic> den);

  /// ±∞, or NaN for zero.
  static ExtendedRational infinity(Sign sign);
  static ExtendedRational sum(const ExtendedRational& a, const ExtendedRational& b, bool minus);

  Sign sign() const { return sign_of(num_); }

  Dyadic num_{};                 ///< if not finite, it has the sign of an infinity, and is 0 for NaN
  std::optional<Dyadic> den_{};  ///< positive; none: 1
  bool finite_ = true;
};

}  // namespace tribunal
