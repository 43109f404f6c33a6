// The reference kernel: the one formula over exact numbers, for every finite input.
#pragma once

#include "core/kernel.h"
#include "exact/kernels/dyadic.h"

namespace tribunal {

/// Exact for all finite binary64 coordinates, subnormals and ±DBL_MAX included. Some microseconds a sign.
using RationalKernel = FormulaKernel<Dyadic>;

static_assert(BoundsKernel<RationalKernel>);

}  // namespace tribunal
