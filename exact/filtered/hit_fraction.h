// The parameter of a hit as an exact fraction.
#pragma once

#include <gmpxx.h>

#include "core/operands.h"

namespace tribunal {

/// λ such that the ray crosses the plane of t at o + λ·d, in lowest terms. Throws std::domain_error where the ray is
/// parallel to the plane or t has no area. Operands must be finite. Some microseconds.
mpq_class hit_fraction(const Ray& r, const Triangle& t);

/// The binary64 number nearest to x, ties to even: subnormal where it must be, and ±∞ from 2¹⁰²⁴ − 2⁹⁷⁰ on. By integer
/// division, so in any rounding mode and with flush-to-zero. What rounds to zero becomes +0. x must be canonical.
double rounded(const mpq_class& x);

}  // namespace tribunal
