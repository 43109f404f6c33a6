#include "exact/trial/prepared.h"

#include "exact/base/failure.h"
#include "exact/cases/case_line.h"

namespace tribunal {
namespace {

Answer by_prepared_triangle(const PreparedTriangle& t, const Segment& s) { return t.segment(s); }
Answer by_prepared_triangle(const PreparedTriangle& t, const Ray& r) { return t.ray(r); }

void require_same(const Method& method, const Query& query, const Answer& prepared, const char* what) {
  const Answer plain = method.ask(query);
  if (plain.status == prepared.status && plain.hit == prepared.hit) return;
  throw Failure(Exit::disagreement, method.name + " answers otherwise with a prepared " + what + " than without, on " +
                                        case_line("prepared", query));
}

}  // namespace

void require_same_when_prepared(const Method& method, const Query& query) {
  if (!is_finite(query) || query.bounds || query.operands() != Operands::triangles) return;
  if (method.prepare_triangle) {
    const PreparedTriangle t = method.prepare_triangle(query.triangle());
    const auto ask = [&](const auto& probe) { return by_prepared_triangle(t, probe); };
    require_same(method, query, std::visit(ask, query.probe), "triangle");
  }
  const auto* ray = std::get_if<Ray>(&query.probe);
  if (method.prepare_ray && ray != nullptr) {
    require_same(method, query, method.prepare_ray(*ray)(query.triangle()), "ray");
  }
}

}  // namespace tribunal
