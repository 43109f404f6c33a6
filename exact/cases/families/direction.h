// Random scales of geometry and of a ray's direction that are far apart.
#pragma once

#include "exact/cases/families/draw.h"
#include "exact/cases/families/family.h"

namespace tribunal {

/// log2 of the size of the direction over that of the geometry: the level plus or minus some binades, at random.
int draw_ratio(Draw& draw, Format format, int level);

/// log2 of a random scale for a geometry of integers of `bits` bits with a direction 2^ratio times as large: any scale
/// at which the format holds both; or, every other time, one at which a volume, which is two lengths times the
/// direction, is below the least number of the format, or above the largest, by a little or by much.
int draw_scale_beside(Draw& draw, Format format, int bits, int ratio);

}  // namespace tribunal
