// All that can be constructed: ring configuration × kind of place × approach.
#pragma once

#include <cstddef>
#include <span>

#include "exact/polygon/family.h"

namespace tribunal {

/// The 774 that exist: 258 pairs of a configuration and a place that it has, each pierced through, from and to.
std::span<const Known> all_constructions();

/// Index into all_constructions().
std::size_t index_of(const Known& construction);

}  // namespace tribunal
