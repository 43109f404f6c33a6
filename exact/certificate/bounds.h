// Exact binomial bounds on an error rate, and on a median.
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

/// The greatest k for which the k-th least and the k-th greatest of n independent samples enclose the median of what
/// they are drawn from with probability at least 1 − alpha, whatever that is: P(B(n, 1/2) < k) ≤ alpha / 2. 0 where
/// even the extremes do not.
std::uint64_t median_rank(std::uint64_t n, double alpha);

}  // namespace tribunal
