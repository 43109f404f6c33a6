// The five vectors of a query, to be changed in place.
#pragma once

#include <array>
#include <variant>

#include "core/query.h"

namespace tribunal {

/// a, b, c, source, target; the first `points` are points. A ray's target is a direction: it does not translate.
struct QueryVectors {
  std::array<Point3*, 5> v;
  int points;
};

inline QueryVectors vectors_of(Query& query) {
  Triangle& t = query.triangle;
  if (auto* s = std::get_if<Segment>(&query.probe)) return {{&t.a, &t.b, &t.c, &s->p, &s->q}, 5};
  Ray& r = std::get<Ray>(query.probe);
  return {{&t.a, &t.b, &t.c, &r.o, &r.d.v}, 4};
}

}  // namespace tribunal
