// Exact binomial bounds on an error rate.
// Source: Clopper & Pearson, "The use of confidence or fiducial limits illustrated in the case of the binomial",
// Biometrika 26(4), 1934.
#pragma once

#include <cstdint>

namespace tribunal {

/// Level of every confidence bound: 95 %.
inline constexpr double confidence_alpha = 0.05;

/// The one-sided upper bound at level 1 − alpha on the rate behind `failures` in `n` independent cases. For no
/// failures it is 1 − alpha^(1/n); for n = 0 it is 1: nothing is known.
double upper_bound(std::uint64_t failures, std::uint64_t n, double alpha);

/// The one-sided lower bound; 0 for no failures.
double lower_bound(std::uint64_t failures, std::uint64_t n, double alpha);

}  // namespace tribunal
