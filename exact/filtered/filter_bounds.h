// The constants of the filters. Proofs: the Gappa scripts in exact/filtered/proofs; derivation: docs/error-bounds.md.
#pragma once

#include "core/operands.h"

namespace tribunal::detail {

/// A computed volume that exceeds its bound in magnitude has the right sign.
///
/// The bound is K·X·Y·Z + tiny, where X, Y, Z are the largest magnitudes on each axis of the rounded differences.
/// K is counted in units of 2⁻⁵², twice the unit roundoff, so that it holds in every rounding mode, with room for the
/// rounding of the bound itself; `tiny` covers underflow, gradual or flushed, and subnormal operands read as zero;
/// above `huge` the filter abstains, below it nothing overflows. So the caller's floating-point environment cannot
/// make a certain sign wrong.
template <class N>
struct FilterConstants {
  N k, tiny, huge;
};

inline constexpr double rounding = 0x1p-52;  ///< of one operation, relative to its result, in any rounding mode

/// One determinant of rounded differences. Proved: 46 units.
inline constexpr FilterConstants<double> volume_filter{47 * rounding, 0x1p-700, 0x1p150};

/// The constants by which the test of a pair (shared_volumes.h) decides from its five volumes.
///
/// `direction` is used for rays only. A ray reaches the plane at t = distance / |d|, and the underflow error of
/// normal·d is multiplied by t. Where d is below `direction` on all axes the filter abstains; otherwise `tiny` covers
/// this error too.
template <class N>
struct PairConstants : FilterConstants<N> {
  N direction;
};

/// Proved: 168 units, for the edge bc; 104 for the target's side, 46 for others.
template <class P>
inline constexpr PairConstants<double> pair_filter{{170 * rounding, 0x1p-700, 0x1p150}, 0};
template <>
inline constexpr PairConstants<double> pair_filter<Ray>{{170 * rounding, 0x1p-400, 0x1p150}, 0x1p-150};

/// A determinant of two axes: the bound is K·X·Y + tiny. Proved: 8 units.
inline constexpr FilterConstants<double> area_filter{9 * rounding, 0x1p-850, 0x1p150};

/// n₁·d₂ − n₂·d₁ of hit parameters: the bound is K·(X·Y·Z)² + tiny. Proved: 1248 units.
inline constexpr FilterConstants<double> order_filter{1250 * rounding, 0x1p-500, 0x1p100};

/// The bounds by terms (term_filter.h) are K·T + tiny, where T is the sum of the terms' magnitudes. Proved: 8 and 18
/// units (terms.g), and the loss by underflow (terms_range.g).
inline constexpr FilterConstants<double> volume_terms_filter{9 * rounding, 0x1p-700, 0x1p150};
inline constexpr FilterConstants<double> order_terms_filter{21 * rounding, 0x1p-500, 0x1p100};

/// V(o) + t·V(d), the side of a point of a ray (within_filter.h), by terms. t is 0 or within 2^±150. Proved: 10 units
/// (within.g), and the loss by underflow (within_range.g).
inline constexpr FilterConstants<double> side_terms_filter{11 * rounding, 0x1p-500, 0x1p150};

/// The larger; the second if either is NaN.
template <class N>
N larger(const N& a, const N& b) {
  return a > b ? a : b;
}

/// The smaller; the second if either is NaN.
template <class N>
N smaller(const N& a, const N& b) {
  return a < b ? a : b;
}

template <class N>
N magnitude(const N& x) {
  return x < 0 ? N(-x) : x;
}

template <>
inline double magnitude(const double& x) {
  return __builtin_fabs(x);
}

template <class N>
N larger_magnitude(const N& a, const N& b) {
  return larger(magnitude(a), magnitude(b));
}

/// 1 or −1.
template <class N>
N unit_with_sign_of(const N& x) {
  return x < 0 ? N(-1.0) : N(1.0);
}

template <>
inline double unit_with_sign_of(const double& x) {
  return __builtin_copysign(1.0, x);
}

/// The largest magnitude on each axis of two or more vectors. A NaN may go unseen: volumes that depend on it are NaN
/// too.
template <class N>
Vec3<N> largest(const Vec3<N>& a, const Vec3<N>& b) {
  return {larger_magnitude(a.x, b.x), larger_magnitude(a.y, b.y), larger_magnitude(a.z, b.z)};
}

template <class N, class... V>
Vec3<N> largest(const Vec3<N>& a, const Vec3<N>& b, const V&... rest) {
  return largest(a, largest(b, rest...));
}

/// Whether no intermediate result overflows.
template <class N>
auto in_range(const Vec3<N>& m, const FilterConstants<N>& c) {
  return larger(larger(m.x, m.y), m.z) < c.huge;
}

template <class N>
N volume_bound(const Vec3<N>& m, const FilterConstants<N>& c) {
  return c.k * m.x * m.y * m.z + c.tiny;
}

}  // namespace tribunal::detail
