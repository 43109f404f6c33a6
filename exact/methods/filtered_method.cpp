#include "exact/methods/filtered_method.h"

#include <array>
#include <memory>
#include <utility>
#include <vector>

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

/// The pairs by columns, as the batch takes them.
NativeRun batch_of(std::span<const SegmentPair> pairs) {
  std::array<std::vector<double>, 15> columns;
  for (const SegmentPair& pair : pairs) {
    std::size_t column = 0;
    for (const Point3& v : {pair.segment.p, pair.segment.q, pair.triangle.a, pair.triangle.b, pair.triangle.c}) {
      for (int axis = 0; axis < 3; ++axis) columns[column++].push_back(v[axis]);
    }
  }
  return [columns = std::move(columns)](std::span<std::uint8_t> hit, std::size_t) {
    const auto points = [&](std::size_t v) {
      return PointColumns{columns[3 * v], columns[3 * v + 1], columns[3 * v + 2]};
    };
    hits(SegmentColumns{points(0), points(1)}, TriangleColumns{points(2), points(3), points(4)}, hit);
  };
}

NativeLoops loops() {
  NativeLoops native = native_loops([](const Segment& s, const Triangle& t) { return hits(s, t); });
  native.batch = batch_of;
  return native;
}

}  // namespace

Method sf_filtered() {
  return {
      .card = {.number = "binary64, then integers",
               .summary = "five signs by a proved filter; fixed-width integers, then GMP, where it abstains",
               .reference = "Segura & Feito 1998, 2001; docs/error-bounds.md"},
      .contract = {.probes = {.bounds = true}, .polygons = Polygons::any, .exact = true},
      .stages = {std::begin(deciding_stages), std::end(deciding_stages)},
      .tells_contact = true,
      .tells_side = true,
      .on_tree_lanes = true,
      .segment = [](const Segment& s, const Triangle& t) { return intersect(s, t); },
      .ray = [](const Ray& r, const Triangle& t) { return intersect(r, t); },
      .within = [](const Ray& r, const Bounds& b, const Triangle& t) { return intersect(r, b, t); },
      .classify = [](const Probe& probe,
                     const Triangle& t) { return std::visit([&](const auto& p) { return classify(p, t); }, probe); },
      .compare_hits = [](const Ray& r, const Triangle& s, const Triangle& t) { return compare_hits(r, s, t); },
      .parameter = parameter_of,
      .batch = [](std::span<const TrianglePair> pairs, std::span<Answer> answers) { intersect(pairs, answers); },
      .polygon = prepare,
      .native = loops()};
}

}  // namespace tribunal
