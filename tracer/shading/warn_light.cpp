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

double strength_at(const Light& light, const Point3& point) {
  if (!is_between(light.flaps, point)) return 0;
  if (!light.aim) return 1;
  const double cosine = glm::dot(normalised(point - light.position), normalised(*light.aim - light.position));
  if (cosine < light.cone_cosine) return 0;
  if (light.concentration == 0) return 1;
  return cosine > 0 ? power(cosine, light.concentration) : 0;
}

}  // namespace tribunal
