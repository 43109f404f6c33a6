// From pixels to primary rays.
#pragma once

#include <cmath>
#include <glm/geometric.hpp>

#include "tracer/scene/scene.h"

namespace tribunal {

/// One ray through the centre of each pixel, pixel (0,0) at the upper left. The direction is
/// forward + x·right + y·up with orthonormal vectors, not normalised. For a camera along an axis and dyadic view_height
/// / height all of this is exact, so that scenes can put vertices and edges exactly under rays.
class CameraRays {
 public:
  explicit CameraRays(const Camera& c);
  Ray through(int column, int row) const {
    const double x = 0.5 * pixel_ * (2 * column + 1 - width_);
    const double y = 0.5 * pixel_ * (height_ - 1 - 2 * row);
    return {eye_, {forward_ + x * right_ + y * up_}};
  }

  const Point3& forward() const { return forward_; }
  const Point3& right() const { return right_; }
  const Point3& up() const { return up_; }

 private:
  Point3 eye_, forward_, right_, up_;
  double pixel_;  ///< side of a pixel at unit distance
  int width_, height_;
};

/// x to the power e, for x ≥ 0, e ≥ 0. Whole exponents take multiplications alone, so that the result does not depend
/// on the math library.
double power(double x, double e);

/// `normalised` for vectors of which the squared length overflows or underflows.
Point3 normalised_far_from_one(const Point3& v);

/// v / |v|, without overflow or underflow on the way; the zero vector stays.
inline Point3 normalised(const Point3& v) {
  const double square = glm::dot(v, v);
  return square > 0x1p-900 && square < 0x1p900 ? v / std::sqrt(square) : normalised_far_from_one(v);
}

}  // namespace tribunal
