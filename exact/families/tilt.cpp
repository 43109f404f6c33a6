// Degeneracies left by as little as one likes: a zero coordinate moved to a power of two.
#include <cmath>

#include "exact/classes/class_table.h"
#include "exact/families/affine.h"
#include "exact/families/shapes.h"
#include "exact/families/table.h"

namespace tribunal {
namespace {

constexpr int tilts[] = {8, 16, 24, 32, 40, 48, 56, 64, 80, 110};

std::span<const int> levels(Format) { return tilts; }

/// Entries of M leave room for the difference of two images in the format's integers.
constexpr int bits_of(Format format) { return digits_of(format) - 6; }

Trial make(Format format, std::uint64_t seed, std::uint64_t k) {
  Draw draw(15, seed, k);
  const std::size_t level = k / class_count % std::size(tilts);
  const int bits = static_cast<int>(draw.between(1, bits_of(format)));
  Trial trial = image_of(static_cast<ClassId>(1 + k % class_count), draw_map(draw, bits), format, level, draw);
  trial.class_id = 0;
  Segment& s = std::get<Segment>(trial.query.probe);
  Triangle& t = trial.query.triangle;
  Point3* const all[] = {&t.a, &t.b, &t.c, &s.p, &s.q};
  const std::uint64_t vertex = draw.below(5);
  const int axis = static_cast<int>(draw.below(3));
  const double origin = (*all[vertex])[axis];
  for (Point3* p : all) (*p)[axis] -= origin;
  (*all[vertex])[axis] = std::ldexp(draw.below(2) == 0 ? 1 : -1, bits - tilts[level]);
  return trial;
}

}  // namespace

/// An exact degeneracy with one vertex moved off it by 2^-level of the size: as near as the exponent range allows, in
/// binary32 too, where a unit in the last place is far.
Family tilt_family() {
  return {.name = "tilt",
          .stresses = "degeneracies left by 2^-level of the size, far below a unit in the last place",
          .population = "affine images of the class representatives, one zero coordinate moved to a power of two",
          .axis = "-log2 of the move over the size",
          .proves_class = false,
          .levels = levels,
          .make = make};
}

}  // namespace tribunal
