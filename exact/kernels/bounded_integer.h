// Integers whose types say how many bits they have, so that no operation can overflow.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "core/sign.h"

namespace tribunal {

/// An integer of magnitude below 2^Bits. A product has the bits of both factors, a sum one more than the longer of its
/// terms: the compiler adds up what others prove. Kept in one word, in two, or in as many as the bits take.
template <int Bits>
class BoundedInteger {
 public:
  static constexpr std::size_t words = Bits / 64 + 1;  // with a bit for the sign
  using Word = std::uint64_t;
  using Words = std::array<Word, words>;  ///< two's complement, lowest first
  __extension__ using Pair = __int128;
  using Value = std::conditional_t<words == 1, std::int64_t, std::conditional_t<words == 2, Pair, Words>>;

  BoundedInteger() = default;
  explicit constexpr BoundedInteger(const Value& v) : value_(v) {}

  /// x must be an integer of magnitude below 2^Bits.
  explicit BoundedInteger(double x) {
    if constexpr (words <= 2) {
      value_ = static_cast<Value>(x);
    } else {
      value_ = words_of(x);
    }
  }

  const Value& value() const { return value_; }

  /// The number in `to` words, at least as many as it has.
  template <std::size_t to>
  std::array<Word, to> in_words() const {
    static_assert(to >= words);
    std::array<Word, to> w;
    if constexpr (words > 2) {
      std::copy_n(value_.begin(), words, w.begin());
    } else {
      w[0] = static_cast<Word>(value_);
      if constexpr (words == 2) w[1] = static_cast<Word>(value_ >> 64);
    }
    const Word sign = static_cast<std::int64_t>(w[words - 1]) < 0 ? ~Word{0} : 0;
    for (std::size_t i = words; i < to; ++i) w[i] = sign;
    return w;
  }

  friend Sign sign_of(const BoundedInteger& a) {
    if constexpr (words <= 2) {
      return sign_of(a.value_);
    } else {
      if (static_cast<std::int64_t>(a.value_[words - 1]) < 0) return Sign::negative;
      Word any = 0;
      for (const Word w : a.value_) any |= w;
      return any != 0 ? Sign::positive : Sign::zero;
    }
  }

 private:
  /// The significand at its place, negated if x is negative.
  static Words words_of(double x) {
    const auto pattern = std::bit_cast<Word>(x);
    const auto field = static_cast<int>(pattern >> 52 & 0x7ff);
    const Word significand = (pattern & 0xfffffffffffff) | (field == 0 ? 0 : Word{1} << 52);
    const int shift = field - 1075;
    Words w{};
    if (shift <= 0) {
      w[0] = shift <= -64 ? 0 : significand >> -shift;
    } else {
      const auto whole = static_cast<std::size_t>(shift / 64);
      const int rest = shift % 64;
      w[whole] = significand << rest;
      if (rest > 11) w[whole + 1] = significand >> (64 - rest);
    }
    if (x >= 0) return w;
    Word carry = 1;
    for (Word& v : w) {
      v = ~v + carry;
      carry &= static_cast<Word>(v == 0);
    }
    return w;
  }

  Value value_;
};

namespace bounded_detail {

__extension__ using Unsigned = unsigned __int128;
using Word = std::uint64_t;

/// a + b, or a − b.
template <bool minus, std::size_t n>
std::array<Word, n> sum(const std::array<Word, n>& a, const std::array<Word, n>& b) {
  std::array<Word, n> r;
  Unsigned carry = minus ? 1 : 0;
  for (std::size_t i = 0; i < n; ++i) {
    carry += Unsigned{a[i]} + (minus ? ~b[i] : b[i]);
    r[i] = static_cast<Word>(carry);
    carry >>= 64;
  }
  return r;
}

/// Subtracts b·2^(64·m) from r if `sign` is that of a negative number.
template <std::size_t m, std::size_t n>
void correct(std::array<Word, m + n>& r, const std::array<Word, n>& b, Word sign) {
  const Word mask = static_cast<std::int64_t>(sign) < 0 ? ~Word{0} : 0;
  Unsigned borrow = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const Unsigned d = Unsigned{r[m + i]} - (b[i] & mask) - borrow;
    r[m + i] = static_cast<Word>(d);
    borrow = d >> 64 & 1;
  }
}

/// Read as numbers without signs, a negative a is too large by 2^(64·m), which makes the product too large by
/// b·2^(64·m); and the same of b.
template <std::size_t m, std::size_t n>
std::array<Word, m + n> product(const std::array<Word, m>& a, const std::array<Word, n>& b) {
  std::array<Word, m + n> r{};
  for (std::size_t i = 0; i < m; ++i) {
    Unsigned carry = 0;
    for (std::size_t j = 0; j < n; ++j) {
      carry += Unsigned{a[i]} * b[j] + r[i + j];
      r[i + j] = static_cast<Word>(carry);
      carry >>= 64;
    }
    r[i + n] = static_cast<Word>(carry);
  }
  correct<m, n>(r, b, a[m - 1]);
  correct<n, m>(r, a, b[n - 1]);
  return r;
}

template <bool minus, int A, int B>
BoundedInteger<std::max(A, B) + 1> sum(const BoundedInteger<A>& a, const BoundedInteger<B>& b) {
  using Sum = BoundedInteger<std::max(A, B) + 1>;
  if constexpr (Sum::words <= 2) {
    const typename Sum::Value x = a.value(), y = b.value();
    return Sum(minus ? x - y : x + y);
  } else {
    return Sum(sum<minus>(a.template in_words<Sum::words>(), b.template in_words<Sum::words>()));
  }
}

}  // namespace bounded_detail

template <int A, int B>
auto operator+(const BoundedInteger<A>& a, const BoundedInteger<B>& b) {
  return bounded_detail::sum<false>(a, b);
}

template <int A, int B>
auto operator-(const BoundedInteger<A>& a, const BoundedInteger<B>& b) {
  return bounded_detail::sum<true>(a, b);
}

template <int A, int B>
BoundedInteger<A + B> operator*(const BoundedInteger<A>& a, const BoundedInteger<B>& b) {
  using Product = BoundedInteger<A + B>;
  if constexpr (Product::words <= 2) {
    return Product(static_cast<typename Product::Value>(a.value()) * b.value());
  } else {
    constexpr std::size_t m = BoundedInteger<A>::words, n = BoundedInteger<B>::words;
    const auto all = bounded_detail::product(a.template in_words<m>(), b.template in_words<n>());
    typename Product::Words r;
    std::copy_n(all.begin(), r.size(), r.begin());
    return Product(r);
  }
}

}  // namespace tribunal
