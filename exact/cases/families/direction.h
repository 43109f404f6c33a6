// Geometry and a ray's direction at scales of their own.
#pragma once

#include "exact/cases/families/draw.h"
#include "exact/cases/families/family.h"

namespace tribunal {

/// log2 of direction over geometry: the level, give or take a few binades.
int draw_ratio(Draw& draw, Format format, int level);

/// Of a geometry of integers of `bits` bits, beside a direction 2^ratio times as large: any scale for which both
/// exist; or, every other time, one at which a volume, two lengths times the direction, is below the least number of
/// the format, or above the largest, by a little or by much.
int draw_scale_beside(Draw& draw, Format format, int bits, int ratio);

}  // namespace tribunal
