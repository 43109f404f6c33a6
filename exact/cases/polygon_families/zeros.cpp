// Shapes with signed zeros.
#include "exact/cases/polygon_families/aim.h"
#include "exact/cases/polygon_families/table.h"
#include "exact/cases/polygon_families/vectors.h"

namespace tribunal {
namespace {

constexpr int no_levels[] = {0};

std::span<const int> levels(Format) { return no_levels; }

void draw_signs_of_zeros(Draw& draw, Point3& v) {
  for (int axis = 0; axis < 3; ++axis) {
    if (v[axis] == 0) v[axis] = draw.below(2) == 0 ? 0.0 : -0.0;
  }
}

Trial make(Format format, std::uint64_t seed, std::uint64_t k) {
  Draw draw(stream_of("polygon family zeros"), seed, k);
  const Aim aim = draw_aim(k, std::size(no_levels), draw);
  const AffineMap map = draw_axis_map(draw);
  const auto direction_scale = static_cast<int>(draw.between(-12, 12));
  Trial trial = image_of(aim, map, format, draw, direction_scale);
  for (Point3& v : trial.query.polygon().vertices) draw_signs_of_zeros(draw, v);
  for (Point3* v : vectors_of(trial.query.probe)) draw_signs_of_zeros(draw, *v);
  return trial;
}

}  // namespace

/// Shapes under signed axis permutations and moderate powers of two, each zero coordinate with a random sign.
Family polygon_zeros_family() {
  return {.name = "polygon-zeros",
          .stresses = "signed zeros, planes along the axes",
          .population = "axis-aligned images of the shapes with random signs of zero",
          .axis = "(none)",
          .constructs = true,
          .levels = levels,
          .make = make,
          .operands = Operands::polygons};
}

}  // namespace tribunal
