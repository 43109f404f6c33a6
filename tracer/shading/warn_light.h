// How strong a directed light is. Source: Warn, "Lighting controls for synthetic images", SIGGRAPH 1983.
#pragma once

#include "tracer/scene/scene.h"

namespace tribunal {

/// A light with what is computed once for all points that it shines on.
class WarnLight {
 public:
  explicit WarnLight(const Light& light);

  /// The share of the light's colour that it sends towards a point: 0 beyond a flap or outside the cone, else the
  /// cosine of the angle to the aim, raised to the concentration. 1 for a light without aim. Points behind an aimed
  /// light get nothing unless the concentration is 0. `to_light` is the unit vector from the point.
  double strength_at(const Point3& point, const Point3& to_light) const;

  const Light& light() const { return *light_; }

 private:
  const Light* light_;
  Point3 axis_{};  ///< the unit vector towards the aim
};

}  // namespace tribunal
