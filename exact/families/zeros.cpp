// Class representatives with signed zeros.
#include "exact/classes/class_table.h"
#include "exact/families/affine.h"
#include "exact/families/shapes.h"
#include "exact/families/table.h"

namespace tribunal {
namespace {

constexpr int no_levels[] = {0};

std::span<const int> levels(Format) { return no_levels; }

Trial make(Format format, std::uint64_t seed, std::uint64_t k) {
  Draw draw(5, seed, k);
  AffineMap map{};
  const std::uint64_t first = draw.below(3);
  const std::uint64_t second = (first + 1 + draw.below(2)) % 3;
  const std::uint64_t axis[3] = {first, second, 3 - first - second};
  for (std::size_t i = 0; i < 3; ++i) map.m[i][axis[i]] = draw.below(2) == 0 ? 1 : -1;
  Trial trial = image_of(static_cast<ClassId>(1 + k % class_count), map, format, 0, draw);
  Segment& s = std::get<Segment>(trial.query.probe);
  Triangle& t = trial.query.triangle;
  for (Point3* v : {&t.a, &t.b, &t.c, &s.p, &s.q}) {
    for (int i = 0; i < 3; ++i) {
      if ((*v)[i] == 0) (*v)[i] = draw.below(2) == 0 ? 0.0 : -0.0;
    }
  }
  return trial;
}

}  // namespace

/// Class representatives under signed axis permutations, each zero coordinate with a random sign.
Family zeros_family() {
  return {.name = "zeros",
          .stresses = "signed zeros",
          .population = "axis-aligned images of the class representatives with random signs of zero",
          .axis = "(none)",
          .proves_class = true,
          .levels = levels,
          .make = make};
}

}  // namespace tribunal
