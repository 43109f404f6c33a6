// The parameter of a hit, rounded to the nearest binary64 number. Files that include this need no GMP.
#pragma once

#include <optional>

#include "core/operands.h"

namespace tribunal {

/// λ such that the ray crosses the plane of t at o + λ·d, correctly rounded: the binary64 number nearest to the exact
/// fraction, ties to even; subnormal where λ is, 0 where it is at most 2⁻¹⁰⁷⁵ in magnitude, and ±∞ where it is at least
/// 2¹⁰²⁴ − 2⁹⁷⁰. Throws std::domain_error where the ray is parallel to the plane or t has no area. Operands must be
/// finite. Neither the rounding mode nor flush-to-zero of the calling thread changes a bit. Some 100 ns where numbers
/// of twice the precision suffice, else some microseconds.
double rounded_parameter(const Ray& r, const Triangle& t);

/// The same where numbers of twice the precision suffice, else nothing; the thread must round to nearest. (The first
/// stage of `rounded_parameter`.)
std::optional<double> filter_rounded_parameter(const Ray& r, const Triangle& t);

}  // namespace tribunal
