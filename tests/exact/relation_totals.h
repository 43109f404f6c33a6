// Counts of relations without regard to format and probe, which tests of the relations themselves do not need.
#pragma once

#include <vector>

#include "exact/relations/relation.h"

namespace tribunal::testing {

/// One entry for each method × relation.
inline std::vector<RelationCount> totals_of(const std::vector<RelationCount>& counts) {
  std::vector<RelationCount> totals;
  for (const RelationCount& c : counts) {
    const bool same = !totals.empty() && totals.back().method == c.method && totals.back().relation == c.relation;
    if (!same) totals.push_back({.method = c.method, .relation = c.relation});
    totals.back() += c;
  }
  return totals;
}

inline std::vector<RelationCount> relation_totals(const FuzzPlan& plan) { return totals_of(check_relations(plan)); }

}  // namespace tribunal::testing
