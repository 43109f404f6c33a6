// The parameter of a hit as an exact fraction.
#pragma once

#include <gmpxx.h>

#include "core/query.h"

namespace tribunal {

/// λ such that the ray crosses the plane of t at o + λ·d, in lowest terms. Throws std::domain_error where the ray is
/// parallel to the plane or t has no area. Operands must be finite. Some microseconds.
mpq_class hit_fraction(const Ray& r, const Triangle& t);

}  // namespace tribunal
