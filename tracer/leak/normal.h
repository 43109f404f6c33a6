// Normals of faces, held against the exact ones.
#pragma once

#include <optional>

#include "core/operands.h"

namespace tribunal::leak {

/// The angle in degrees between a vector and (b − a) × (c − a), which is computed exactly and then rounded once.
/// Nothing if the vector is zero or not finite, or does not point to that side of the plane, which is decided exactly.
/// The triangle has an area.
std::optional<double> degrees_from_normal(const Triangle& t, const Point3& v);

}  // namespace tribunal::leak
