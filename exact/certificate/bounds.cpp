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

}  // namespace tribunal
