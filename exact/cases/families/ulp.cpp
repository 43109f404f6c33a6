// Neighbours of exact degeneracies, some units in the last place away.
#include "exact/cases/families/ulp.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "exact/cases/families/affine.h"
#include "exact/cases/families/pair_vectors.h"
#include "exact/cases/families/shapes.h"
#include "exact/cases/families/table.h"

namespace tribunal {
namespace {

constexpr int steps_64[] = {1, 2, 3, 4, 8, 1 << 6, 1 << 10, 1 << 20};
constexpr int steps_32[] = {1, 2, 3, 4, 8, 1 << 6, 1 << 10};

constexpr auto steps = by_format<steps_64, steps_32>;

/// Bit patterns of one sign are ordered like the numbers; reflecting the negative ones orders all of them.
template <class Float, class Int>
Float moved(Float x, std::int64_t n) {
  constexpr Int lowest = std::numeric_limits<Int>::min();
  constexpr Int largest = std::bit_cast<Int>(std::numeric_limits<Float>::max());
  const Int bits = std::bit_cast<Int>(x);
  const Int place = static_cast<Int>(bits < 0 ? lowest - bits : bits);
  const Int goal = static_cast<Int>(std::clamp<std::int64_t>(place + n, -std::int64_t{largest}, largest));
  return std::bit_cast<Float>(static_cast<Int>(goal < 0 ? lowest - goal : goal));
}

Trial make(Format format, std::uint64_t seed, std::uint64_t k) {
  Draw draw(stream_of("family ulp"), seed, k);
  const ClassTurn turn = class_turn_of(k, steps(format).size());
  const int bits = mantissa_fills(format)[draw.below(mantissa_fills(format).size())];
  Trial trial = affine_image(format, draw, turn, bits);
  trial.class_id = 0;
  const std::int64_t step = steps(format)[turn.level];
  Point3& v = *vectors_of(trial.query).v[draw.below(5)];
  const std::uint64_t only_axis = draw.below(6);
  for (int axis = 0; axis < 3; ++axis) {
    const std::int64_t n = draw.below(2) == 0 ? step : -step;
    if (only_axis >= 3 || only_axis == static_cast<std::uint64_t>(axis)) v[axis] = moved_by_ulps(v[axis], n, format);
    if (v[axis] == 0 && draw.below(2) == 0) v[axis] = -0.0;
  }
  return trial;
}

}  // namespace

double moved_by_ulps(double x, std::int64_t n, Format format) {
  if (format == Format::binary64) return moved<double, std::int64_t>(x, n);
  return static_cast<double>(moved<float, std::int32_t>(static_cast<float>(x), n));
}

/// An affine image of a class representative with one coordinate, or all three of one vertex, moved by ±level units in
/// the last place; sometimes a zero gets a minus sign. The class is that of the moved points, which only an oracle can
/// say.
Family ulp_family() {
  return {.name = "ulp",
          .stresses = "near-degeneracy: one vertex some ulps off an exact degeneracy",
          .population = "affine images of the class representatives, one vertex moved by ulps",
          .axis = "units in the last place",
          .constructs = false,
          .levels = steps,
          .make = make};
}

}  // namespace tribunal
