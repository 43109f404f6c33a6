// What the programs share that are about classes.
#pragma once

#include <cmath>
#include <variant>

#include "core/query.h"
#include "exact/classes/class_table.h"
#include "tests/mutation/kill.h"

namespace tribunal::killing {

template <class Each>
void each_class(const Each& each) {
  for (const ClassRow& row : class_table()) each(row);
  for (const ClassRow& row : ray_class_table()) each(row);
}

inline Query query_of(const ClassRow& row) { return {row.representative_probe(), row.representative_triangle()}; }

/// The image under a matrix of small numbers, an offset, and powers of two: of the same class.
inline Query image_of(const Query& q, Draw& draw, int entries, int exponent) {
  const int a = draw.within(1, entries), b = draw.within(-entries, entries), c = draw.within(-entries, entries);
  const auto turned = [&](const Point3& p) {
    return Point3(a * p.x + b * p.y, p.y, c * p.x + p.z * a) * std::ldexp(1.0, exponent);
  };
  const Point3 offset = turned(draw.point(entries));
  const auto at = [&](const Point3& p) { return turned(p) + offset; };
  const Triangle& t = q.triangle();
  const Triangle placed{at(t.a), at(t.b), at(t.c)};
  if (const auto* s = std::get_if<Segment>(&q.probe)) return {Segment{at(s->p), at(s->q)}, placed};
  const Ray& r = std::get<Ray>(q.probe);
  return {Ray{at(r.o), {turned(r.d.v) * std::ldexp(1.0, draw.within(-9, 9))}}, placed};
}

}  // namespace tribunal::killing
