// Where a ray hits a triangle, as exact fractions.
#pragma once

#include "core/operands.h"
#include "exact/kernels/dyadic.h"

namespace tribunal {

/// num / den, den ≠ 0.
struct ExactRatio {
  Dyadic num, den;
};

/// Where a ray crosses the plane of a triangle, exactly: the parameter, and the weights of b and c.
struct ExactHit {
  ExactRatio t, b, c;
};

/// t = (a − o)·n / d·n for the normal n; the weight of b is det(d, c − o, a − o), of c det(d, a − o, b − o), each over
/// d·n, the sum of the three. The ray must not be parallel to the plane.
ExactHit exact_hit(const Ray& ray, const Triangle& triangle);

}  // namespace tribunal
