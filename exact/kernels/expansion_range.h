// Where expansions neither underflow nor overflow, and how operands get there.
#pragma once

#include <initializer_list>

#include "core/operands.h"

namespace tribunal::detail {

/// Coordinates x that are zero, or 2^least ≤ |x| < 2^end.
struct ExpansionRange {
  int least, end;
};

/// In this range every operation of the formula of volumes on expansions is exact.
///
/// No underflow. A double of magnitude at least 2⁻³⁰⁵ is a multiple of 2⁻³⁵⁷. So is each term of an exact sum of two of
/// them: rounding to nearest takes a multiple of a power of two to one, as long as that is a double, and the error is a
/// difference of two. So all terms of a difference are multiples of 2⁻³⁵⁷, all terms that arise when two of these are
/// multiplied multiples of 2⁻⁷¹⁴, and of three 2⁻¹⁰⁷¹, above the least double 2⁻¹⁰⁷⁴.
///
/// No overflow. Let A(e) be the sum of the magnitudes of an expansion's terms. An exact sum or product raises it by a
/// factor below 1 + 2⁻⁵¹ over what real numbers give, and no chain here is longer than 2⁹ of them, so A(e ± f) <
/// 2·(A(e) + A(f)) and A(e·f) < 2·A(e)·A(f), whatever happens in between included. Coordinates below 2³³⁰ give
/// differences with A < 2³³², products of two 2⁶⁶⁵, minors 2⁶⁶⁷, products of three 2¹⁰⁰⁰, volumes 2¹⁰⁰⁴. Halving a
/// factor multiplies it by 2²⁷ + 1, and factors are below 2⁶⁶⁷.
inline constexpr ExpansionRange volume_range{-305, 330};

/// The same for the order of two hits: products of two volumes, of degree 6. All terms are multiples of 2⁻¹⁷⁸, products
/// of six of 2⁻¹⁰⁶⁸. Coordinates below 2¹⁶⁰ give differences with A < 2¹⁶², volumes 2⁴⁹⁴, their products 2⁹⁸⁹, the
/// result 2⁹⁹². Chains are longer, up to 2²⁴ operations, each of which raises A by a factor below 1 + 2⁻⁵¹ still.
inline constexpr ExpansionRange order_range{-126, 160};

/// Whether all coordinates are in the range.
bool is_within(const ExpansionRange& range, std::initializer_list<const Point3*> points, const Direction* direction);

/// Multiplies each axis by its own power of two, and the direction, if any, by another one on top, so that all
/// coordinates are in the range: exact, and no sign of a volume, an area or an order of hits changes. False, and
/// nothing done, where some axis, or the direction, spans more binades than the range. Coordinates must be finite.
bool bring_within(const ExpansionRange& range, std::initializer_list<Point3*> points, Direction* direction);

}  // namespace tribunal::detail
