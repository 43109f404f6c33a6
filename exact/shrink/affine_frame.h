// How the points of a query about a triangle depend on each other, so that they can move together without leaving their
// class.
#pragma once

#include <optional>
#include <vector>

#include "core/format.h"
#include "core/query.h"

namespace tribunal {

/// Rounds a frame coordinate; `unit` is the spacing of the values allowed.
using FrameRounding = double (*)(double x, double unit);

/// The query with its affinely independent points (the first of a, b, c, source, target that are) rounded to `bits`
/// significant bits of the largest on each axis, and the others placed where the same affine combinations put them.
/// Nothing if that is not exact in the format, or if the combinations have denominators beyond 2¹⁰.
std::optional<Query> in_smaller_frame(const Query& query, Format format, int bits, FrameRounding round);

}  // namespace tribunal
