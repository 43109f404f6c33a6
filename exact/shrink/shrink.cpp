#include "exact/shrink/shrink.h"

#include "exact/shrink/shrinker.h"

namespace tribunal {

Query shrink(const Method& method, const Query& query, Format format) {
  const auto simplify = query.operands() == Operands::triangles ? simplify_triangle : simplify_polygon;
  Shrinker shrinker(method, query, format);
  while (simplify(shrinker)) {
  }
  return shrinker.best();
}

bool is_simpler(const Query& a, const Query& b) { return cost_of(a) < cost_of(b); }

}  // namespace tribunal
