// Moving a number by units in the last place.
#pragma once

#include <cstdint>

#include "core/method.h"

namespace tribunal {

/// x moved by n units in the last place of its format, across binades and zero; saturates at the largest finite value.
double moved_by_ulps(double x, std::int64_t n, Format format);

}  // namespace tribunal
