// Coordinates of one axis with three magnitudes in a geometric sequence, far from each other.
#pragma once

#include "exact/cases/families/draw.h"
#include "exact/cases/families/family.h"

namespace tribunal {

/// The numbers 0 and ±m·2^low·s, where s is 1, 2^half or 2^(2·half).
struct Ladder {
  double m;
  int low, half;

  double draw_number(Draw& draw) const;
};

/// A ladder with the largest magnitude 2^spread times the least, or half of that if the spread is odd; m has as many
/// bits as the format's range then leaves.
Ladder draw_ladder(Draw& draw, Format format, int spread);

}  // namespace tribunal
