// Rational numbers with infinities and NaN: IEEE arithmetic without rounding. Published tests divide by zero and rely
// on the result; on this type they run exactly.
#pragma once

#include <gmpxx.h>

#include <memory>

namespace tribunal {

/// A rational number, ±∞, or NaN. x/0 is ∞ with the sign of x, 0/0, 0·∞, ∞ − ∞ and ∞/∞ are NaN, x/∞ is 0. NaN compares
/// false with everything, itself included. There is one zero, without a sign: 1/(−0) is +∞.
/// Laws: conversion from a double is exact, and so are + − × / and comparisons of finite numbers.
class ExtendedRational {
 public:
  ExtendedRational() = default;
  ExtendedRational(int x) : num_(x) {}
  explicit ExtendedRational(double x);

  friend ExtendedRational operator+(const ExtendedRational& a, const ExtendedRational& b);
  friend ExtendedRational operator-(const ExtendedRational& a, const ExtendedRational& b) { return a + -b; }
  friend ExtendedRational operator*(const ExtendedRational& a, const ExtendedRational& b);
  friend ExtendedRational operator/(const ExtendedRational& a, const ExtendedRational& b);
  ExtendedRational operator-() const;

  friend bool operator==(const ExtendedRational& a, const ExtendedRational& b);
  friend bool operator<(const ExtendedRational& a, const ExtendedRational& b);
  friend bool operator!=(const ExtendedRational& a, const ExtendedRational& b) { return !(a == b); }
  friend bool operator>(const ExtendedRational& a, const ExtendedRational& b) { return b < a; }
  friend bool operator<=(const ExtendedRational& a, const ExtendedRational& b) { return a < b || a == b; }
  friend bool operator>=(const ExtendedRational& a, const ExtendedRational& b) { return b <= a; }

  bool is_nan() const { return den_ == 0 && num_ == 0; }
  bool is_finite() const { return den_ != 0; }

  /// The number itself, which must be finite.
  mpq_class fraction() const;

 private:
  ExtendedRational(long num, long den) : num_(num), den_(den) {}
  explicit ExtendedRational(mpq_class x);

  int sign() const;
  static ExtendedRational reduced(long num, long den);

  /// Numerator and denominator, without a common divisor, where both fit a word; the denominator is not negative, and
  /// 0 for what is not finite. Where they do not fit, `big_` is the number and the denominator is 1.
  long num_ = 0;
  long den_ = 1;
  std::shared_ptr<const mpq_class> big_{};
};

}  // namespace tribunal
