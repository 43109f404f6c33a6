// The levels of a stress axis that counts vertices.
#pragma once

#include <span>

#include "core/format.h"

namespace tribunal {

inline constexpr int vertex_count_levels[] = {3, 4, 6, 8, 16, 64};
inline std::span<const int> vertex_counts(Format) { return vertex_count_levels; }

}  // namespace tribunal
