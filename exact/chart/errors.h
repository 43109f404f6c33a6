// How far off the numbers are that methods give with a hit, on the populations of a chart.
#pragma once

#include <cstdint>
#include <vector>

#include "exact/chart/populations.h"

namespace tribunal {

/// The errors of each method in the list, in its order, on rays through the segments of the population's first cases
/// of a format: from p in the direction of q − p, as that rounds. Judged by the oracles; every right hit is measured.
std::vector<HitErrors> errors_on(const Population& population, Format format, std::uint64_t seed, std::uint64_t cases,
                                 const std::vector<Method>& methods);

}  // namespace tribunal
