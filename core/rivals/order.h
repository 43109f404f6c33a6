// The lexicographic order of points: the same for every triangle that has them.
#pragma once

#include "core/vec3.h"

namespace tribunal::published {

template <class N>
bool precedes(const Vec3<N>& a, const Vec3<N>& b) {
  if (a.x != b.x) return a.x < b.x;
  if (a.y != b.y) return a.y < b.y;
  return a.z < b.z;
}

}  // namespace tribunal::published
