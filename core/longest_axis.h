// The axis along which a normal is projected.
#pragma once

#include "core/vec3.h"

namespace tribunal {

/// The axis on which v is longest; the first of equals.
template <class N>
Axis longest_axis(const Vec3<N>& v) {
  const N x = v.x < 0 ? N(-v.x) : v.x, y = v.y < 0 ? N(-v.y) : v.y, z = v.z < 0 ? N(-v.z) : v.z;
  if (x >= y && x >= z) return Axis::x;
  return y >= z ? Axis::y : Axis::z;
}

}  // namespace tribunal
