// Neighbours of exact degeneracies.
#include "exact/cases/families/placing.h"
#include "exact/cases/families/shapes.h"
#include "exact/sweep/axes/placed.h"
#include "exact/sweep/axes/table.h"

namespace tribunal {
namespace {

constexpr int steps_64[] = {0, 1, 2, 4, 8, 1 << 4, 1 << 6, 1 << 10, 1 << 14, 1 << 18, 1 << 22, 1 << 26, 1 << 30};
constexpr int steps_32[] = {0, 1, 2, 4, 8, 1 << 4, 1 << 6, 1 << 8, 1 << 10, 1 << 14, 1 << 18, 1 << 21};
constexpr auto steps = by_format<steps_64, steps_32>;

constexpr int farthest(Format format) { return steps(format).back(); }

Trial place(Draw& draw, Format format, int value, std::uint64_t k) {
  const std::span<const int> fills = mantissa_fills(format);
  const AffineMap map = draw_placed_map(draw, format, fills[draw.below(fills.size())]);
  Trial trial = placed_image(class_in_turn(k), map, format, draw);
  move_by_steps(trial, draw, format, value);
  return trial;
}

}  // namespace

StressAxis ulps_axis() {
  return {.name = "ulps",
          .quantity = "distance from an exact degeneracy (units in the last place of one vertex)",
          .population = "exact affine images of all classes, one vertex or end moved by value units in the last place",
          .spacing = Spacing::logarithmic,
          .easiest = farthest,
          .values = steps,
          .stream = stream_of("sweep ulps"),
          .place = place};
}

}  // namespace tribunal
