// How a case is placed at a value of a stress axis: families place theirs at their levels by these functions, and
// sweeps at any value.
#pragma once

#include "core/native.h"
#include "exact/cases/families/draw.h"
#include "exact/cases/families/family.h"

namespace tribunal {

/// A triangle of [−1, 1]³ with a height of 2^−aspect of its length, and a segment through a rounded point of it or near
/// it.
SegmentPair place_sliver(Draw& draw, Format format, int aspect);

/// A triangle of [−1, 1]³ and a segment that leaves its plane by 2^−slope of its length.
SegmentPair place_grazing(Draw& draw, Format format, int slope);

/// A triangle of [−2, 2]³ with the origin on it, exactly, and a segment with ends about 2^distance away; half of the
/// segments run through the origin. Coordinates are multiples of 2^−bits, those of the ends times 2^distance.
SegmentPair place_distant(Draw& draw, int bits, int distance);

}  // namespace tribunal
