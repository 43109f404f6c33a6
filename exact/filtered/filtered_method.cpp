#include "exact/filtered/filtered_method.h"

#include <memory>

#include "exact/filtered/batch.h"
#include "exact/filtered/filtered.h"
#include "exact/filtered/filtered_polygon.h"

namespace tribunal {
namespace {

PreparedPolygon prepare(const Polygon& polygon) {
  const auto prepared = std::make_shared<const FilteredPolygon>(polygon);
  return {.segment = [prepared](const Segment& s) { return prepared->meet(s); },
          .ray = [prepared](const Ray& r) { return prepared->meet(r); }};
}

}  // namespace

Method sf_filtered() {
  return {
      .name = "sf-filtered",
      .number = "binary64, then integers",
      .contract = "segment, ray; any triangle or polygon",
      .summary = "five signs by a proved filter; fixed-width integers, then GMP, where it abstains",
      .reference = "Segura & Feito 1998, 2001; docs/error-bounds.md",
      .convention = Convention::closed,
      .format = Format::binary64,
      .exact = true,
      .stages = {Stage::filter, Stage::expansion, Stage::exact},
      .segment = [](const Segment& s, const Triangle& t) { return intersect(s, t); },
      .ray = [](const Ray& r, const Triangle& t) { return intersect(r, t); },
      .classify = [](const Probe& probe,
                     const Triangle& t) { return std::visit([&](const auto& p) { return classify(p, t); }, probe); },
      .compare_hits = [](const Ray& r, const Triangle& s, const Triangle& t) { return compare_hits(r, s, t); },
      .batch = [](std::span<const TrianglePair> pairs, std::span<Answer> answers) { intersect(pairs, answers); },
      .polygon = prepare};
}

}  // namespace tribunal
