// Makes a method of the Segura–Feito test on a given kernel.
#pragma once

#include "core/method.h"
#include "core/segura_feito_polygon.h"
#include "exact/classes/classify.h"

namespace tribunal {

/// In what the sf-* methods differ, beside their kernels.
struct KernelDescription {
  const char* number;
  const char* summary;
  Format format;
  bool exact;
};

/// The test of a polygon for many probes: its covering is computed once.
template <Kernel K>
PreparedPolygon prepare(const Polygon& polygon, const K& k) {
  const Covering c = cover(polygon, k);
  return {.segment = [c, k](const Segment& s) { return segura_feito(s, c, k); },
          .ray = [c, k](const Ray& r) { return segura_feito(r, c, k); }};
}

template <Kernel K>
Method segura_feito_method(const KernelDescription& d, const K& k) {
  return {.card = {.number = d.number, .summary = d.summary, .reference = "Segura & Feito 1998, 2001"},
          .contract = {.probes = {.bounds = true}, .polygons = Polygons::any, .format = d.format, .exact = d.exact},
          .tells_contact = true,
          .tells_side = d.exact,
          .segment = [k](const Segment& s, const Triangle& t) { return segura_feito(s, t, k); },
          .ray = [k](const Ray& r, const Triangle& t) { return segura_feito(r, t, k); },
          .within = [k](const Ray& r, const Bounds& b, const Triangle& t) { return segura_feito(r, b, t, k); },
          .classify =
              [k](const Probe& probe, const Triangle& t) {
                return std::visit([&](const auto& p) { return classify(p, t, k); }, probe);
              },
          .compare_hits = [k](const Ray& r, const Triangle& s, const Triangle& t) { return k.compare_hits(r, s, t); },
          .polygon = [k](const Polygon& polygon) { return prepare(polygon, k); },
          .native = native_loops([k](const Segment& s, const Triangle& t) { return segura_feito(s, t, k).hit; })};
}

}  // namespace tribunal
