// Class representatives with signed zeros.
#include "exact/cases/families/affine.h"
#include "exact/cases/families/pair_vectors.h"
#include "exact/cases/families/table.h"

namespace tribunal {
namespace {

constexpr int no_levels[] = {0};

std::span<const int> levels(Format) { return no_levels; }

Trial make(Format format, std::uint64_t seed, std::uint64_t k) {
  Draw draw(stream_of("family zeros"), seed, k);
  const AffineMap map = draw_axis_map(draw);
  Trial trial = image_of(class_turn_of(k, 1), map, format, draw, static_cast<int>(draw.between(-12, 12)));
  for (Point3* v : vectors_of(trial.query).v) {
    for (int i = 0; i < 3; ++i) {
      if ((*v)[i] == 0) (*v)[i] = draw.below(2) == 0 ? 0.0 : -0.0;
    }
  }
  return trial;
}

}  // namespace

/// Class representatives under signed axis permutations and moderate powers of two, each zero coordinate with a random
/// sign.
Family zeros_family() {
  return {.name = "zeros",
          .stresses = "signed zeros",
          .population = "axis-aligned images of the class representatives with random signs of zero",
          .axis = "(none)",
          .constructs = true,
          .levels = levels,
          .make = make};
}

}  // namespace tribunal
