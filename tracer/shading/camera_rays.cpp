#include "tracer/shading/camera_rays.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace tribunal {

double power(double x, double e) {
  if (!(e <= 65536) || e != std::floor(e)) return std::pow(x, e);
  double result = 1, square = x;
  for (auto n = static_cast<unsigned>(e); n != 0; n >>= 1, square *= square) {
    if (n & 1) result *= square;
  }
  return result;
}

Point3 normalised_far_from_one(const Point3& v) {
  const double size = std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
  if (!(size > 0)) return v;
  const Point3 tamed(v.x / size, v.y / size, v.z / size);
  return tamed / std::sqrt(glm::dot(tamed, tamed));
}

CameraRays::CameraRays(const Camera& c)
    : eye_(c.eye),
      forward_(normalised(c.look_at - c.eye)),
      pixel_(c.view_height / c.height),
      width_(c.width),
      height_(c.height) {
  right_ = normalised(glm::cross(forward_, normalised(c.up)));
  up_ = glm::cross(right_, forward_);
}

}  // namespace tribunal
