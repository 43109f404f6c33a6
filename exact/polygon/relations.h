// Relations between answers about polygons that must hold: checks without an oracle.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "exact/families/draw.h"
#include "exact/polygon/fuzz.h"

namespace tribunal {

/// Turns a query into one whose answer follows from the first's.
struct PolygonRelation {
  std::string_view name;
  bool planar_only;    ///< of other polygons the covering, so the surface, may change
  bool keeps_contact;  ///< else `hit` alone
  /// Nothing where the change cannot be made exactly.
  std::optional<PolygonQuery> (*change)(const PolygonQuery&, Format, Draw&);
};

std::span<const PolygonRelation> all_polygon_relations();

struct PolygonRelationCount {
  std::size_t method, relation;
  std::uint64_t asked = 0, broken = 0;
  std::optional<PolygonQuery> witness{};  ///< the first query, by case number, whose change was answered otherwise
};

/// Every relation on the plan's cases, by every method of the plan. For an exact method none may be broken.
std::vector<PolygonRelationCount> check_relations(const PolygonFuzzPlan& plan);

}  // namespace tribunal
