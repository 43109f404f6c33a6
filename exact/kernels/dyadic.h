// Dyadic rationals m·2^e over GMP integers. Every finite binary float is one, and so are sums, differences and
// products of them; the formulas never divide, so this is all of ℚ that the reference kernel needs, without gcds.
#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <cstdlib>
#include <memory>

#include "core/sign.h"

namespace tribunal {

/// The exact number m·2^e. Not normalised: 2·2⁰ and 1·2¹ are the same number. While m fits a few limbs it is kept in
/// the object, and GMP's functions of limbs compute with it; a larger one is an integer of GMP's on the heap.
/// Laws: conversion from a finite double is exact; +, −, × are exact; a double survives the round trip.
class Dyadic {
 public:
  Dyadic() = default;

  /// Exact. x must be finite.
  explicit Dyadic(double x);

  Dyadic(const Dyadic& other) { *this = other; }
  Dyadic(Dyadic&& other) noexcept { *this = std::move(other); }
  Dyadic& operator=(const Dyadic& other) {
    if (this == &other) return *this;
    copy_words(other);
    big_ = other.big_ ? std::make_unique<const mpz_class>(*other.big_) : nullptr;
    return *this;
  }
  Dyadic& operator=(Dyadic&& other) noexcept {
    if (this == &other) return *this;
    copy_words(other);
    big_ = std::move(other.big_);
    return *this;
  }
  ~Dyadic() = default;

  friend Dyadic operator+(const Dyadic& a, const Dyadic& b) { return sum(a, b, false); }
  friend Dyadic operator-(const Dyadic& a, const Dyadic& b) { return sum(a, b, true); }
  friend Dyadic operator*(const Dyadic& a, const Dyadic& b);
  friend Dyadic operator-(const Dyadic& a) { return sum(Dyadic(), a, true); }

  friend Sign sign_of(const Dyadic& a) { return a.big_ ? static_cast<Sign>(sgn(*a.big_)) : sign_of(a.size_); }

  /// The same number as a canonical fraction.
  mpq_class fraction() const;

 private:
  static constexpr int room = 6;  ///< limbs

  /// A GMP integer that borrows the limbs of m.
  class View;

  Dyadic(const mpz_class& m, long e);

  /// a + b, or a − b if `minus`.
  static Dyadic sum(const Dyadic& a, const Dyadic& b, bool minus);

  bool is_zero() const { return sign_of(*this) == Sign::zero; }

  /// Whether m·2^bits, and twice that, fit the object's limbs.
  bool has_room_for(long bits) const { return !big_ && std::abs(size_) + bits / limb_bits + 1 < room; }

  /// Writes |m|·2^bits into cleared limbs, and returns how many it takes.
  int shifted(long bits, mp_limb_t* to) const;

  void copy_words(const Dyadic& other) {
    size_ = other.size_;
    e_ = other.e_;
    std::copy_n(other.limbs_, std::abs(size_), limbs_);
  }

  static constexpr long limb_bits = GMP_NUMB_BITS;

  int size_ = 0;  ///< limbs in use, negative if m is: as in GMP's integers. 0 if m is big.
  long e_ = 0;
  std::unique_ptr<const mpz_class> big_{};  ///< m, if it does not fit the limbs
  mp_limb_t limbs_[room];                   ///< lowest first; those in use, the highest of which is not 0
};

}  // namespace tribunal
