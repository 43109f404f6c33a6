// Which coordinates one meets every day.
#pragma once

#include <cmath>

#include "core/query.h"

namespace tribunal {

/// 0, or from a tenth of a millimetre to a hundred kilometres, where a metre is 1. It sorts reports and chooses cases;
/// no answer depends on it.
inline bool is_everyday(double x) { return x == 0 || (std::fabs(x) >= 1e-4 && std::fabs(x) <= 1e5); }

inline bool is_everyday(const Point3& p) { return is_everyday(p.x) && is_everyday(p.y) && is_everyday(p.z); }
inline bool is_everyday(const Segment& s) { return is_everyday(s.p) && is_everyday(s.q); }
inline bool is_everyday(const Ray& r) { return is_everyday(r.o) && is_everyday(r.d.v); }
inline bool is_everyday(const Bounds& b) { return is_everyday(b.tmin) && (std::isinf(b.tmax) || is_everyday(b.tmax)); }
inline bool is_everyday(const Triangle& t) { return is_everyday(t.a) && is_everyday(t.b) && is_everyday(t.c); }

inline bool is_everyday(const PolygonData& polygon) {
  for (const Point3& v : polygon.vertices) {
    if (!is_everyday(v)) return false;
  }
  return true;
}

inline bool is_everyday(const Query& query) {
  const auto everyday = [](const auto& operand) { return is_everyday(operand); };
  return std::visit(everyday, query.probe) && std::visit(everyday, query.target) &&
         (!query.bounds || is_everyday(*query.bounds));
}

}  // namespace tribunal
