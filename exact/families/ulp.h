// Neighbours of exact degeneracies, some units in the last place away.
#pragma once

#include "exact/families/family.h"

namespace tribunal {

/// An affine image of class k mod 163 with one coordinate, or all three of one vertex, moved by ±level units in the
/// last place; sometimes a zero gets a minus sign. The class is that of the moved points: an oracle must say it.
Family ulp_family();

/// x moved by n units in the last place of its format, across binades and zero; saturates at the largest finite value.
double moved_by_ulps(double x, std::int64_t n, Format format);

}  // namespace tribunal
