#include "exact/cases/families/ladder.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "exact/cases/families/shapes.h"

namespace tribunal {

double Ladder::draw_number(Draw& draw) const {
  const auto rung = static_cast<int>(draw.between(-3, 3));
  if (rung == 0) return draw.below(2) == 0 ? 0.0 : -0.0;
  return times_power_of_two(rung > 0 ? m : -m, low + half * (std::abs(rung) - 1));
}

Ladder draw_ladder(Draw& draw, Format format, int spread) {
  const int room = largest_exponent(format) - least_exponent(format) - spread;
  const int bits = std::min(digits_of(format), room + 1);
  const std::int64_t m = draw.between(1, (std::int64_t{1} << bits) - 1);
  const auto low = static_cast<int>(draw.between(least_exponent(format), least_exponent(format) + room + 1 - bits));
  return {static_cast<double>(m), low, spread / 2};
}

}  // namespace tribunal
