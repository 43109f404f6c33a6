// The five vectors of a probe and a triangle, to be changed in place.
#pragma once

#include <array>
#include <variant>

#include "core/query.h"

namespace tribunal {

/// a, b, c, source, target; the first `points` are points. A ray's target is a direction: it does not translate.
struct PairVectors {
  std::array<Point3*, 5> v;
  int points;
};

inline PairVectors vectors_of(Probe& probe, Triangle& t) {
  if (auto* s = std::get_if<Segment>(&probe)) return {{&t.a, &t.b, &t.c, &s->p, &s->q}, 5};
  Ray& r = std::get<Ray>(probe);
  return {{&t.a, &t.b, &t.c, &r.o, &r.d.v}, 4};
}

/// The target must be a triangle.
inline PairVectors vectors_of(Query& query) { return vectors_of(query.probe, query.triangle()); }

}  // namespace tribunal
