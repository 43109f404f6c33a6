// Numbers of one axis that lie equal steps apart, far from each other.
#pragma once

#include "exact/cases/families/draw.h"
#include "exact/cases/families/family.h"

namespace tribunal {

/// 0 and ±m·2^low times 1, 2^half and 2^(2·half).
struct Ladder {
  double m;
  int low, half;

  double draw_number(Draw& draw) const;
};

/// The largest 2^spread times the least, or half as much if the spread is odd; m has as many bits as the format's range
/// leaves beside that.
Ladder draw_ladder(Draw& draw, Format format, int spread);

}  // namespace tribunal
