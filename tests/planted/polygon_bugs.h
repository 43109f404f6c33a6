// What the files of planted polygon bugs share.
#pragma once

#include "core/segura_feito_polygon.h"
#include "exact/methods/cgal_kernels.h"
#include "tests/planted/bugs.h"

namespace tribunal::planted {

using PolygonDecision = Answer (*)(const Probe&, const Polygon&);

/// A method that claims to be exact on polygons, and takes no triangles.
Method polygon_method(const char* name, const char* what, PolygonDecision decide);

/// The answer by Segura–Feito on a given kernel.
template <class K>
Answer answer_by(const K& k, const Probe& probe, const Polygon& polygon) {
  return std::visit([&](const auto& p) { return segura_feito(p, cover(polygon, k), k); }, probe);
}

/// The right answer, by Segura–Feito on EPICK.
Answer right(const Probe& probe, const Polygon& polygon);

/// The right answer about another polygon, but for `planar`.
Answer about(const Polygon& other, const Probe& probe, const Polygon& polygon);

/// The polygon of the first `rings` rings.
Polygon first_rings(const Polygon& polygon, std::size_t rings);

/// The planted bugs of each file.
std::vector<Method> covering_bugs();
std::vector<Method> many_bugs();
std::vector<Method> polygon_range_bugs();
std::vector<Method> polygon_ray_bugs();

Method sound_covering();
std::vector<Method> sound_polygon_range();

}  // namespace tribunal::planted
