#include "exact/certificate/bounds.h"

#include <boost/math/distributions/binomial.hpp>

namespace tribunal {

using Binomial = boost::math::binomial_distribution<double>;

double upper_bound(std::uint64_t failures, std::uint64_t n, double alpha) {
  if (failures >= n) return 1;
  return Binomial::find_upper_bound_on_p(static_cast<double>(n), static_cast<double>(failures), alpha);
}

double lower_bound(std::uint64_t failures, std::uint64_t n, double alpha) {
  if (failures == 0) return 0;
  return Binomial::find_lower_bound_on_p(static_cast<double>(n), static_cast<double>(failures), alpha);
}

std::uint64_t median_rank(std::uint64_t n, double alpha) {
  const Binomial below_median(static_cast<double>(n), 0.5);
  const auto encloses = [&](std::uint64_t k) { return cdf(below_median, static_cast<double>(k - 1)) <= alpha / 2; };
  std::uint64_t rank = 0, too_many = n / 2 + 1;  // 0 or one that encloses; the least that does not, or beyond the last
  while (too_many - rank > 1) {
    const std::uint64_t k = rank + (too_many - rank) / 2;
    (encloses(k) ? rank : too_many) = k;
  }
  return rank;
}

}  // namespace tribunal
