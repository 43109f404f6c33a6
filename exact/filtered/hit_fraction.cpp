#include "exact/filtered/hit_fraction.h"

#include <stdexcept>

#include "core/kernel.h"
#include "exact/filtered/stages/default_rounding.h"
#include "exact/kernels/dyadic.h"

namespace tribunal {

mpq_class hit_fraction(const Ray& r, const Triangle& t) {
  const DefaultRounding in_this_scope;
  const HitParameter<Dyadic> hit = hit_parameter<Dyadic>(r, t);
  if (sign_of(hit.den) == Sign::zero) throw std::domain_error("hit_fraction: the ray does not cross the plane");
  return hit.num.fraction() / hit.den.fraction();
}

}  // namespace tribunal
