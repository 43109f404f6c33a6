// Bounds aimed at where a ray hits.
#pragma once

#include "exact/cases/families/draw.h"
#include "exact/cases/families/family.h"

namespace tribunal {

/// A parameter t at which something happens between the ray and the triangle, as the format rounds it: where the ray
/// crosses the plane; or, if it is parallel to the plane, where it is nearest to a vertex, as double rounds that. A NaN
/// where d = 0. It may be negative or infinite.
double draw_parameter(const Ray& r, const Triangle& t, Format format, Draw& draw);

}  // namespace tribunal
