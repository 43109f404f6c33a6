// Doubles in the lanes of a vector register, as a number type for the formula templates. Included by files that are
// compiled for one instruction set each; the namespace keeps their instantiations apart.
// Source of the vector operations: Google Highway.
#pragma once

#include <hwy/highway.h>

#include <cstddef>
#include <cstdint>
#include <cstring>

#include "exact/filtered/filter_bounds.h"

namespace tribunal::HWY_NAMESPACE {

using namespace detail;

namespace hn = hwy::HWY_NAMESPACE;

using Tag = hn::ScalableTag<double>;
using Vector = hn::Vec<Tag>;

inline constexpr Tag tag;

/// The bits of a mask, bit i for lane i, and the mask of up to eight bits.
template <class D>
HWY_INLINE unsigned bits_of(D d, hn::Mask<D> mask) {
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(d, mask, bytes);
  return bytes[0];
}

template <class D>
HWY_INLINE hn::Mask<D> mask_of(D d, std::uint64_t bits) {
  return hn::LoadMaskBits(d, reinterpret_cast<const std::uint8_t*>(&bits));
}

/// One truth value a lane.
struct LaneMask {
  hn::Mask<Tag> mask;

  friend LaneMask operator&(const LaneMask& a, const LaneMask& b) { return {hn::And(a.mask, b.mask)}; }
  friend LaneMask operator|(const LaneMask& a, const LaneMask& b) { return {hn::Or(a.mask, b.mask)}; }

  /// Bit i for lane i.
  unsigned bits() const { return bits_of(tag, mask); }
};

/// A product that is not rounded yet: it is rounded by itself, or together with the sum that it enters where the target
/// has a fused multiply-add.
struct LaneProduct {
  Vector a, b;
};

struct Lanes {
  Vector v;

  Lanes(Vector x) : v(x) {}
  Lanes(const LaneProduct& p) : v(hn::Mul(p.a, p.b)) {}
  explicit Lanes(double x) : v(hn::Set(tag, x)) {}

  static Lanes load(const double* x) { return hn::LoadU(tag, x); }

  friend Lanes operator+(const Lanes& a, const Lanes& b) { return hn::Add(a.v, b.v); }
  friend Lanes operator-(const Lanes& a, const Lanes& b) { return hn::Sub(a.v, b.v); }
  friend Lanes operator-(const Lanes& a) { return hn::Neg(a.v); }
  friend LaneProduct operator*(const Lanes& a, const Lanes& b) { return {a.v, b.v}; }
  friend LaneMask operator>(const Lanes& a, const Lanes& b) { return {hn::Gt(a.v, b.v)}; }
  friend LaneMask operator<(const Lanes& a, const Lanes& b) { return {hn::Lt(a.v, b.v)}; }
  friend LaneMask operator>=(const Lanes& a, const Lanes& b) { return {hn::Ge(a.v, b.v)}; }
  friend LaneMask operator<=(const Lanes& a, const Lanes& b) { return {hn::Le(a.v, b.v)}; }
  friend Lanes operator/(const Lanes& a, const Lanes& b) { return hn::Div(a.v, b.v); }

  // These return the second operand if either is NaN: x86's own instructions do, Highway's scalar functions do not.
#if HWY_TARGET == HWY_SCALAR
  friend Lanes larger(const Lanes& a, const Lanes& b) { return Vector(a.v.raw > b.v.raw ? a.v.raw : b.v.raw); }
  friend Lanes smaller(const Lanes& a, const Lanes& b) { return Vector(a.v.raw < b.v.raw ? a.v.raw : b.v.raw); }
#else
  friend Lanes larger(const Lanes& a, const Lanes& b) { return hn::Max(a.v, b.v); }
  friend Lanes smaller(const Lanes& a, const Lanes& b) { return hn::Min(a.v, b.v); }
#endif
  friend Lanes magnitude(const Lanes& a) { return hn::Abs(a.v); }
  friend Lanes unit_with_sign_of(const Lanes& a) { return hn::CopySign(hn::Set(tag, 1.0), a.v); }

#if HWY_TARGET <= HWY_AVX3
  /// One instruction: the operand of larger magnitude, with its sign cleared.
  friend Lanes larger_magnitude(const Lanes& a, const Lanes& b) {
    constexpr int larger_without_sign = 0b1011;
    return Vector{_mm512_range_pd(a.v.raw, b.v.raw, larger_without_sign)};
  }
#endif
};

inline Lanes operator+(const LaneProduct& p, const Lanes& a) { return hn::MulAdd(p.a, p.b, a.v); }
inline Lanes operator+(const Lanes& a, const LaneProduct& p) { return p + a; }
inline Lanes operator+(const LaneProduct& p, const LaneProduct& q) { return p + Lanes(q); }
inline Lanes operator-(const LaneProduct& p, const LaneProduct& q) { return hn::MulSub(p.a, p.b, Lanes(q).v); }

/// A filter's constants in every lane.
inline FilterConstants<Lanes> in_lanes(const FilterConstants<double>& c) {
  return {Lanes(c.k), Lanes(c.tiny), Lanes(c.huge)};
}

inline PairConstants<Lanes> in_lanes(const PairConstants<double>& c) {
  return {in_lanes(static_cast<const FilterConstants<double>&>(c)), Lanes(c.direction)};
}

inline Vec3<Lanes> load(const double* const* columns, std::size_t i) {
  return {Lanes::load(columns[0] + i), Lanes::load(columns[1] + i), Lanes::load(columns[2] + i)};
}

inline Vec3<Lanes> broadcast(const double* const* columns) {
  return {Lanes(*columns[0]), Lanes(*columns[1]), Lanes(*columns[2])};
}

/// Writes one byte a lane, 0 or 1, from the bits of a mask.
inline void store_bytes(unsigned bits, std::uint8_t* bytes) {
  constexpr std::uint64_t ones = 0x0101010101010101, diagonal = 0x8040201008040201, sevens = 0x7f7f7f7f7f7f7f7f;
  const std::uint64_t spread = ((((bits * ones) & diagonal) + sevens) >> 7) & ones;
  std::memcpy(bytes, &spread, hn::Lanes(tag));
}

}  // namespace tribunal::HWY_NAMESPACE
