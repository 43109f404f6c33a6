// The two vectors of a probe, to be changed in place.
#pragma once

#include <array>
#include <variant>

#include "core/query.h"

namespace tribunal {

/// Source and target. A ray's target is a direction.
inline std::array<Point3*, 2> vectors_of(Probe& probe) {
  if (auto* s = std::get_if<Segment>(&probe)) return {&s->p, &s->q};
  Ray& r = std::get<Ray>(probe);
  return {&r.o, &r.d.v};
}

}  // namespace tribunal
