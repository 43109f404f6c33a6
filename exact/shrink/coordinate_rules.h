// The shrinking rules that look at coordinates only, not at the points that they belong to.
#pragma once

#include <span>
#include <vector>

#include "core/format.h"

namespace tribunal {

/// Significant bits of |x|; 0 for 0.
int significand_bits(double x);

/// How simple coordinates are: fewer bits in all, then exponents nearer to 0, then fewer minus signs.
struct CoordinateCost {
  int bits = 0, exponents = 0, negatives = 0;
  auto operator<=>(const CoordinateCost&) const = default;

  void add(double x);
};

// Each rule changes the points in place and returns whether it did so exactly in the format; if not, the points must
// not be used.

/// Subtracts `by` on the axis.
bool translate_exactly(std::span<Point3* const> points, int axis, double by, Format format);

/// Divides by the power of two that brings the largest coordinate on the axis to [1, 2); false if it is there already.
bool scale_exactly(std::span<Point3* const> points, int axis, Format format);

/// Sets every coordinate of this value on the axis to another; false if it is the same.
bool replace_value(std::span<Point3* const> points, int axis, double value, double by, Format format);

/// The values on the axis, ascending, each once.
std::vector<double> distinct_values(std::span<Point3* const> points, int axis);

/// What may stand for a value, simplest first: 0, ±1, then ever more of its significand bits.
std::vector<double> simpler_values(double value);

}  // namespace tribunal
