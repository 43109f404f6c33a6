#include "tracer/shading/warn_light.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "tracer/shading/camera_rays.h"

namespace tribunal {
namespace {

bool is_between(const Flaps& flaps, const Point3& p) {
  for (int i = 0; i < 3; ++i) {
    if (p[i] < flaps.lo[i] || p[i] > flaps.hi[i]) return false;
  }
  return true;
}

}  // namespace

WarnLight::WarnLight(const Light& light) : light_(&light) {
  if (light.aim) axis_ = normalised(*light.aim - light.position);
}

double WarnLight::strength_at(const Point3& point, const Point3& to_light) const {
  if (!is_between(light_->flaps, point)) return 0;
  if (!light_->aim) return 1;
  const double cosine = glm::dot(-to_light, axis_);
  if (cosine < light_->cone_cosine) return 0;
  if (light_->concentration == 0) return 1;
  return cosine > 0 ? power(cosine, light_->concentration) : 0;
}

}  // namespace tribunal
