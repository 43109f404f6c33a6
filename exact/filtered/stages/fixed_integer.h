// Integers of a fixed number of machine words, for exact signs without allocation.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "core/sign.h"

namespace tribunal {

/// An integer modulo 2^(64·Words), read as two's complement. +, − and × are exact as long as the true result lies in
/// [−2^(64·Words−1), 2^(64·Words−1)); intermediate results may wrap around.
template <std::size_t Words>
class FixedInteger {
 public:
  FixedInteger() = default;

  /// x must be an integer in range.
  explicit FixedInteger(double x) {
    constexpr double fits_a_word = 0x1p63;
    if (x > -fits_a_word && x < fits_a_word) {
      const auto word = static_cast<std::int64_t>(x);
      words_.fill(static_cast<std::uint64_t>(word >> 63));
      words_[0] = static_cast<std::uint64_t>(word);
    } else {
      shift_in(x);
    }
  }

  friend FixedInteger operator+(const FixedInteger& a, const FixedInteger& b) {
    FixedInteger sum;
    Wide carry = 0;
    for (std::size_t i = 0; i < Words; ++i) {
      carry += Wide{a.words_[i]} + b.words_[i];
      sum.words_[i] = static_cast<std::uint64_t>(carry);
      carry >>= 64;
    }
    return sum;
  }

  friend FixedInteger operator-(const FixedInteger& a) { return FixedInteger() - a; }

  friend FixedInteger operator-(const FixedInteger& a, const FixedInteger& b) {
    FixedInteger difference;
    std::uint64_t borrow = 0;
    for (std::size_t i = 0; i < Words; ++i) {
      const Wide d = Wide{a.words_[i]} - b.words_[i] - borrow;
      difference.words_[i] = static_cast<std::uint64_t>(d);
      borrow = static_cast<std::uint64_t>(d >> 64) & 1U;
    }
    return difference;
  }

  /// Schoolbook, without the words beyond the modulus.
  friend FixedInteger operator*(const FixedInteger& a, const FixedInteger& b) {
    FixedInteger product;
    for (std::size_t i = 0; i < Words; ++i) {
      Wide carry = 0;
      for (std::size_t j = 0; i + j < Words; ++j) {
        carry += Wide{a.words_[i]} * b.words_[j] + product.words_[i + j];
        product.words_[i + j] = static_cast<std::uint64_t>(carry);
        carry >>= 64;
      }
    }
    return product;
  }

  friend Sign sign_of(const FixedInteger& a) {
    if (static_cast<std::int64_t>(a.words_[Words - 1]) < 0) return Sign::negative;
    std::uint64_t any = 0;
    for (const std::uint64_t w : a.words_) any |= w;
    return any != 0 ? Sign::positive : Sign::zero;
  }

  friend bool operator==(const FixedInteger&, const FixedInteger&) = default;

 private:
  __extension__ using Wide = unsigned __int128;

  void shift_in(double x) {
    const auto pattern = std::bit_cast<std::uint64_t>(x);
    const std::uint64_t significand = (pattern & 0xfffffffffffff) | std::uint64_t{1} << 52;
    const std::size_t shift = (pattern >> 52 & 0x7ff) - 1075;
    const std::size_t word = shift / 64, bit = shift % 64;
    words_[word] = significand << bit;
    if (bit > 11) words_[word + 1] = significand >> (64 - bit);
    if (x < 0) *this = -*this;
  }

  std::array<std::uint64_t, Words> words_{};  ///< lowest first
};

}  // namespace tribunal
