// Degeneracies that are missed by arbitrarily little: a zero coordinate is moved to a power of two.
#include <algorithm>
#include <cmath>

#include "exact/cases/families/affine.h"
#include "exact/cases/families/pair_vectors.h"
#include "exact/cases/families/probe.h"
#include "exact/cases/families/shapes.h"
#include "exact/cases/families/table.h"

namespace tribunal {
namespace {

constexpr int tilts_64[] = {8, 16, 24, 32, 40, 48, 56, 64, 80, 110, 200, 310, 600, 1000, 1500, 2040};
constexpr int tilts_32[] = {8, 16, 24, 32, 40, 48, 56, 64, 80, 110, 180, 240};

constexpr auto levels = by_format<tilts_64, tilts_32>;

/// Entries of M leave room for the difference of two images in the format's integers.
constexpr int bits_of(Format format) { return digits_of(format) - 6; }

/// log2 of the scale of the tilted axis: half of the time 0, or the nearest scale at which both the move 2^(bits −
/// tilt) and the images exist in the format; else any scale at which they do.
int draw_axis_scale(Draw& draw, Format format, int bits, int tilt) {
  const int lo = least_exponent(format) + std::max(0, tilt - bits);
  const int hi = largest_exponent(format) - bits - image_bits;
  const bool none = draw.below(2) == 0;
  const auto any = static_cast<int>(draw.between(lo, hi));
  return none ? std::clamp(0, lo, hi) : any;
}

/// Translates all points along the axis so that the vertex has the coordinate 0, and sets this coordinate to `move`.
void tilt_point(const PairVectors& vectors, std::size_t vertex, int axis, double move) {
  const double origin = (*vectors.v[vertex])[axis];
  for (std::size_t i = 0; i < static_cast<std::size_t>(vectors.points); ++i) (*vectors.v[i])[axis] -= origin;
  (*vectors.v[vertex])[axis] = move;
}

/// Sets one coordinate of a direction to 2^−tilt of the direction's size: a direction cannot be translated.
void tilt_direction(Point3& d, int axis, int tilt, Format format) {
  const double size = std::max({std::fabs(d.x), std::fabs(d.y), std::fabs(d.z)});
  d[axis] = size == 0 ? 0 : in_format(std::ldexp(1.0, std::ilogb(size) - tilt), format);
}

Trial make(Format format, std::uint64_t seed, std::uint64_t k) {
  Draw draw(stream_of("family tilt"), seed, k);
  const ClassTurn turn = class_turn_of(k, levels(format).size());
  const int tilt = levels(format)[turn.level];
  const int bits = static_cast<int>(draw.between(1, bits_of(format)));
  AffineMap map = draw_map(draw, bits);
  const auto axis = static_cast<int>(draw.below(3));
  const int scale = draw_axis_scale(draw, format, bits, tilt);
  map.scale[static_cast<std::size_t>(axis)] = scale;
  Trial trial = image_of(turn, map, format, draw);
  trial.class_id = 0;
  const PairVectors vectors = vectors_of(trial.query);
  const std::uint64_t vertex = draw.below(5);
  const double sign = draw.below(2) == 0 ? 1 : -1;
  if (vertex < static_cast<std::uint64_t>(vectors.points)) {
    tilt_point(vectors, vertex, axis, std::ldexp(sign, bits - tilt + scale));
  } else {
    tilt_direction(*vectors.v[vertex], axis, tilt, format);
  }
  return trial;
}

}  // namespace

/// An exact degeneracy with one vertex moved off it by 2^-level of the size: as near as the exponent range allows, in
/// binary32 too, where a unit in the last place is far.
Family tilt_family() {
  return {
      .name = "tilt",
      .stresses = "degeneracies left by 2^-level of the size, far below a unit in the last place",
      .population = "affine images of the class representatives, one coordinate moved to zero, then to a power of two",
      .axis = "-log2 of the move over the size",
      .constructs = false,
      .levels = levels,
      .make = make};
}

}  // namespace tribunal
