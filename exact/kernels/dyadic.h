// Dyadic rationals m·2^e over GMP integers. Every finite binary float is one, and so are sums, differences and
// products of them; the formulas never divide, so this is all of ℚ that the reference kernel needs, without gcds.
#pragma once

#include <gmpxx.h>

#include "core/sign.h"

namespace tribunal {

/// The exact number m·2^e. Not normalised: 2·2⁰ and 1·2¹ are the same number.
/// Laws: conversion from a finite double is exact; +, −, × are exact; a double survives the round trip.
class Dyadic {
 public:
  Dyadic() = default;

  /// Exact. x must be finite.
  explicit Dyadic(double x);

  friend Dyadic operator+(const Dyadic& a, const Dyadic& b);
  friend Dyadic operator-(const Dyadic& a, const Dyadic& b);
  friend Dyadic operator*(const Dyadic& a, const Dyadic& b) { return Dyadic(a.m_ * b.m_, a.e_ + b.e_); }
  friend Dyadic operator-(const Dyadic& a) { return Dyadic(-a.m_, a.e_); }

  friend Sign sign_of(const Dyadic& a) { return static_cast<Sign>(sgn(a.m_)); }

  /// The same number as a canonical fraction.
  mpq_class fraction() const;

 private:
  Dyadic(mpz_class m, long e) : m_(std::move(m)), e_(e) {}

  mpz_class m_;
  long e_ = 0;
};

}  // namespace tribunal
