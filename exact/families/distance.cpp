// Segments far longer or shorter than the triangle.
#include <cmath>

#include "exact/families/shapes.h"
#include "exact/families/table.h"

namespace tribunal {
namespace {

constexpr int distances_64[] = {-50, -25, 0, 25, 50};
constexpr int distances_32[] = {-20, -10, 0, 10, 20};

constexpr auto levels = by_format<distances_64, distances_32>;

Trial make(Format format, std::uint64_t seed, std::uint64_t k) {
  Draw draw(9, seed, k);
  const std::size_t level = k % levels(format).size();
  const Triangle t = draw_triangle(draw, format);
  const Point3 x = draw_in_plane(draw, format, t);
  const Point3 n = std::ldexp(1.0, levels(format)[level]) * draw_point(draw, format);
  return shuffled(unclassified(format, level, through(x, n, n), t), draw);
}

}  // namespace

/// Segments whose ends are 2^level triangle sizes away.
Family distance_family() {
  return {.name = "distance",
          .stresses = "segments far longer or far shorter than the triangle",
          .population = "random triangles in [-1,1]^3, segment ends 2^level away",
          .axis = "log2 of distance over size",
          .proves_class = false,
          .levels = levels,
          .make = make};
}

}  // namespace tribunal
