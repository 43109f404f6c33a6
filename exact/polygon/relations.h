// Relations between answers about polygons that must hold: checks without an oracle.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "exact/families/draw.h"
#include "exact/polygon/fuzz.h"
#include "exact/relations/count.h"

namespace tribunal {

/// Turns a query into one whose answer follows from the first's.
struct PolygonRelation {
  std::string_view name;
  std::string_view statement;
  bool planar_only;    ///< of other polygons the covering, so the surface, may change
  bool keeps_contact;  ///< else `hit` alone
  /// Nothing where the change cannot be made exactly.
  std::optional<PolygonQuery> (*change)(const PolygonQuery&, Format, Draw&);
};

std::span<const PolygonRelation> all_polygon_relations();

/// The witness is the first query, by case number, whose change was answered otherwise, and the changed one.
using PolygonRelationCount = BasicRelationCount<PolygonQuery>;

/// Every relation on the plan's cases, by every method of the plan that promises an answer to them. For an exact method
/// none may be broken. Deterministic for any number of threads.
std::vector<PolygonRelationCount> check_relations(const PolygonFuzzPlan& plan);

}  // namespace tribunal
