// Dyadic rationals m·2^e over GMP integers. Every finite binary float is one, and so are sums, differences and
// products of them; the formulas never divide, so this is all of ℚ that the reference kernel needs, without gcds.
#pragma once

#include <gmpxx.h>

#include <optional>
#include <utility>

#include "core/sign.h"

namespace tribunal {

/// The exact number m·2^e. Not normalised: 2·2⁰ and 1·2¹ are the same number. While m fits a machine word it is kept
/// in one, and an operation that would overflow it goes to GMP instead.
/// Laws: conversion from a finite double is exact; +, −, × are exact; a double survives the round trip.
class Dyadic {
 public:
  Dyadic() = default;

  /// Exact. x must be finite.
  explicit Dyadic(double x);

  friend Dyadic operator+(const Dyadic& a, const Dyadic& b);
  friend Dyadic operator-(const Dyadic& a, const Dyadic& b);
  friend Dyadic operator*(const Dyadic& a, const Dyadic& b);
  friend Dyadic operator-(const Dyadic& a) { return Dyadic() - a; }

  friend Sign sign_of(const Dyadic& a) { return a.big_ ? static_cast<Sign>(sgn(*a.big_)) : sign_of(a.word_); }

  /// The same number as a canonical fraction.
  mpq_class fraction() const;

 private:
  Dyadic(long word, long e) : word_(word), e_(e) {}
  Dyadic(mpz_class m, long e) : big_(std::move(m)), e_(e) {}

  /// m as a GMP integer: itself if it is one, else made in `scratch`.
  const mpz_class& integer(mpz_class& scratch) const;

  /// m·2^(e − lower), for lower ≤ e.
  const mpz_class& aligned_to(long lower, mpz_class& scratch) const;

  long word_ = 0;                 ///< m, unless it is big
  std::optional<mpz_class> big_;  ///< m, if it does not fit a word
  long e_ = 0;
};

}  // namespace tribunal
