// How strong a directed light is. Source: Warn, "Lighting controls for synthetic images", SIGGRAPH 1983.
#pragma once

#include "tracer/scene/scene.h"

namespace tribunal {

/// The share of the light's colour that it sends towards a point: 0 beyond a flap or outside the cone, else the cosine
/// of the angle to the aim, raised to the concentration. 1 for a light without aim. Points behind an aimed light
/// get nothing unless the concentration is 0.
double strength_at(const Light& light, const Point3& point);

}  // namespace tribunal
