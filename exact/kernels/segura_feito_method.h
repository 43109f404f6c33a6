// Makes a method of the Segura–Feito test on a given kernel.
#pragma once

#include "core/method.h"
#include "core/segura_feito_polygon.h"
#include "exact/classes/class_table.h"

namespace tribunal {

/// What tells one sf-* method from another.
struct KernelDescription {
  const char* number;
  const char* summary;
  Format format;
  bool exact;
};

/// The answer with its class. Where a coplanar contact is a single point, the class says so, and whether the source
/// is that point is itself a query: the source as a segment against the triangle.
template <Kernel K, class P>
Answer classify(const P& probe, const Triangle& t, const K& k) {
  Answer answer = segura_feito(probe, t, k);
  answer.class_id = class_of(probe, t, k);
  if (answer.class_id == 0 || answer.contact != Contact::coplanar) return answer;
  const ClassRow& row = class_row(answer.class_id);
  if (row.intersection != "point") return answer;
  if (row.touches.starts_with("int")) {
    answer.at = At::between;
  } else {
    answer.at = segura_feito(Segment{source(probe), source(probe)}, t, k).hit ? At::source : At::target;
  }
  return answer;
}

/// With the covering prepared.
template <Kernel K>
PreparedPolygon prepare(const Polygon& polygon, const K& k) {
  const Covering c = cover(polygon, k);
  return {.segment = [c, k](const Segment& s) { return segura_feito(s, c, k); },
          .ray = [c, k](const Ray& r) { return segura_feito(r, c, k); }};
}

template <Kernel K>
Method segura_feito_method(const KernelDescription& d, const K& k) {
  return {.card = {.number = d.number, .summary = d.summary, .reference = "Segura & Feito 1998, 2001"},
          .contract = {.polygons = Polygons::any, .format = d.format, .exact = d.exact},
          .tells_contact = true,
          .segment = [k](const Segment& s, const Triangle& t) { return segura_feito(s, t, k); },
          .ray = [k](const Ray& r, const Triangle& t) { return segura_feito(r, t, k); },
          .classify =
              [k](const Probe& probe, const Triangle& t) {
                return std::visit([&](const auto& p) { return classify(p, t, k); }, probe);
              },
          .compare_hits = [k](const Ray& r, const Triangle& s, const Triangle& t) { return k.compare_hits(r, s, t); },
          .polygon = [k](const Polygon& polygon) { return prepare(polygon, k); }};
}

}  // namespace tribunal
