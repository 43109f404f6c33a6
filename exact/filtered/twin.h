// Pairs of numbers that one operation computes at once: by vector instructions where they are doubles.
#pragma once

#include <cstdint>

#include "exact/filtered/filter_bounds.h"

namespace tribunal::detail {

/// Two numbers with +, −, × for each by itself. A result may be of another type (a product yet to be fused with a sum).
template <class N>
struct Twin {
  N first, second;

  template <class M>
  friend auto operator+(const Twin& a, const Twin<M>& b) {
    return Twin<decltype(a.first + b.first)>{a.first + b.first, a.second + b.second};
  }
  template <class M>
  friend auto operator-(const Twin& a, const Twin<M>& b) {
    return Twin<decltype(a.first - b.first)>{a.first - b.first, a.second - b.second};
  }
  template <class M>
  friend auto operator*(const Twin& a, const Twin<M>& b) {
    return Twin<decltype(a.first * b.first)>{a.first * b.first, a.second * b.second};
  }
};

template <class N>
Twin<N> swapped(const Twin<N>& a) {
  return {a.second, a.first};
}

template <class N>
Twin<N> larger_magnitude(const Twin<N>& a, const Twin<N>& b) {
  return {larger_magnitude(a.first, b.first), larger_magnitude(a.second, b.second)};
}

/// Whether both |a| exceed their bounds. False for NaN.
template <class N>
bool both_beyond(const Twin<N>& a, const Twin<N>& bound) {
  return magnitude(a.first) > bound.first && magnitude(a.second) > bound.second;
}

/// Bits 0 and 1: whether each is negative.
template <class N>
unsigned negative_bits(const Twin<N>& a) {
  return (a.first < 0 ? 1U : 0U) | (a.second < 0 ? 2U : 0U);
}

/// Whether both are negative, or neither is. It needs no branch for each.
template <class N>
bool same_sign(const Twin<N>& a) {
  return (0b1001U >> negative_bits(a) & 1U) != 0;
}

template <class N>
Twin<N> magnitude(const Twin<N>& a) {
  return {magnitude(a.first), magnitude(a.second)};
}

template <class N>
Twin<N> larger(const Twin<N>& a, const Twin<N>& b) {
  return {larger(a.first, b.first), larger(a.second, b.second)};
}

template <class N>
Twin<N> smaller(const Twin<N>& a, const Twin<N>& b) {
  return {smaller(a.first, b.first), smaller(a.second, b.second)};
}

template <class N>
N first(const Twin<N>& a) {
  return a.first;
}

template <class N>
N second(const Twin<N>& a) {
  return a.second;
}

#if defined(__GNUC__)

/// The same in one register.
template <>
struct Twin<double> {
  using Lanes = double __attribute__((vector_size(16)));
  using Bits = long long __attribute__((vector_size(16)));

  explicit Twin(Lanes v) : lanes(v) {}
  Twin(double a, double b) : lanes{a, b} {}

  friend Twin operator+(const Twin& a, const Twin& b) { return Twin(a.lanes + b.lanes); }
  friend Twin operator-(const Twin& a, const Twin& b) { return Twin(a.lanes - b.lanes); }
  friend Twin operator*(const Twin& a, const Twin& b) { return Twin(a.lanes * b.lanes); }
  friend Twin swapped(const Twin& a) { return {a.lanes[1], a.lanes[0]}; }
  friend Twin larger_magnitude(const Twin& a, const Twin& b) {
    const Lanes x = magnitude(a.lanes), y = magnitude(b.lanes);
    return Twin(x > y ? x : y);
  }
  friend Twin magnitude(const Twin& a) { return Twin(magnitude(a.lanes)); }
  friend Twin larger(const Twin& a, const Twin& b) { return Twin(a.lanes > b.lanes ? a.lanes : b.lanes); }
  friend Twin smaller(const Twin& a, const Twin& b) { return Twin(a.lanes < b.lanes ? a.lanes : b.lanes); }
  friend bool both_beyond(const Twin& a, const Twin& bound) {
    return sign_bits(reinterpret_cast<Lanes>(magnitude(a.lanes) > bound.lanes)) == 3;
  }
  friend unsigned negative_bits(const Twin& a) { return sign_bits(a.lanes); }
  friend double first(const Twin& a) { return a.lanes[0]; }
  friend double second(const Twin& a) { return a.lanes[1]; }

 private:
  static Lanes magnitude(Lanes x) {
    constexpr Bits all_but_sign = {INT64_MAX, INT64_MAX};
    return reinterpret_cast<Lanes>(reinterpret_cast<Bits>(x) & all_but_sign);
  }
  static unsigned sign_bits(Lanes x) {
#if defined(__SSE2__)
    return static_cast<unsigned>(__builtin_ia32_movmskpd(x));
#else
    const Bits bits = reinterpret_cast<Bits>(x);
    return (bits[0] < 0 ? 1U : 0U) | (bits[1] < 0 ? 2U : 0U);
#endif
  }

  Lanes lanes;
};

#endif

template <class N>
Twin<N> twice(const N& a) {
  return {a, a};
}

template <class N>
Vec3<Twin<N>> beside(const Vec3<N>& a, const Vec3<N>& b) {
  return {Twin<N>{a.x, b.x}, Twin<N>{a.y, b.y}, Twin<N>{a.z, b.z}};
}

template <class N>
Vec3<Twin<N>> swapped(const Vec3<Twin<N>>& a) {
  return {swapped(a.x), swapped(a.y), swapped(a.z)};
}

}  // namespace tribunal::detail
