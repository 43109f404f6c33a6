#include "exact/methods/filtered_method.h"

#include <memory>

#include "exact/filtered/batch.h"
#include "exact/filtered/filtered.h"
#include "exact/filtered/filtered_polygon.h"
#include "exact/filtered/rounded_parameter.h"

namespace tribunal {
namespace {

PreparedPolygon prepare(const Polygon& polygon) {
  const auto prepared = std::make_shared<const FilteredPolygon>(polygon);
  return {.segment = [prepared](const Segment& s) { return prepared->meet(s); },
          .ray = [prepared](const Ray& r) { return prepared->meet(r); }};
}

/// The parameter of the hit, where the ray crosses the triangle's plane; nothing for a miss or a coplanar contact.
std::optional<double> parameter_of(const Ray& r, const Triangle& t) {
  const Answer answer = intersect(r, t);
  if (!answer.hit || answer.contact == Contact::coplanar) return std::nullopt;
  return rounded_parameter(r, t);
}

}  // namespace

Method sf_filtered() {
  return {
      .card = {.number = "binary64, then integers",
               .summary = "five signs by a proved filter; fixed-width integers, then GMP, where it abstains",
               .reference = "Segura & Feito 1998, 2001; docs/error-bounds.md"},
      .contract = {.polygons = Polygons::any, .exact = true},
      .stages = {std::begin(deciding_stages), std::end(deciding_stages)},
      .tells_contact = true,
      .on_tree_lanes = true,
      .segment = [](const Segment& s, const Triangle& t) { return intersect(s, t); },
      .ray = [](const Ray& r, const Triangle& t) { return intersect(r, t); },
      .classify = [](const Probe& probe,
                     const Triangle& t) { return std::visit([&](const auto& p) { return classify(p, t); }, probe); },
      .compare_hits = [](const Ray& r, const Triangle& s, const Triangle& t) { return compare_hits(r, s, t); },
      .parameter = parameter_of,
      .batch = [](std::span<const TrianglePair> pairs, std::span<Answer> answers) { intersect(pairs, answers); },
      .polygon = prepare};
}

}  // namespace tribunal
