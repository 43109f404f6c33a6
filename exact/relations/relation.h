// Relations between answers: checks that need no oracle. For an exact method they hold without exception; for the
// others the rate of violations is a figure in itself.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "exact/families/draw.h"
#include "exact/relations/count.h"

namespace tribunal {

/// What a relation says of one query, ready to be held against any method.
struct Instance {
  std::vector<Query> queries;  ///< those that the method is asked: the witness, if it does not hold
  /// Nothing where the method does not take the queries, or the relation says nothing about its answer.
  std::function<std::optional<bool>(const Method&)> holds;
};

struct Relation {
  std::string_view name;
  std::string_view statement;
  /// Nothing where the relation does not speak of the query, or its other queries cannot be formed exactly in the
  /// format.
  std::optional<Instance> (*of)(const Query& query, Format format, Draw& draw);
};

/// Adding one is adding a row.
std::span<const Relation> all_relations();

using RelationCount = BasicRelationCount<Query>;

/// Every relation on every case of the plan and on the ray through it (from p in the direction of q − p, as that
/// rounds), for every method; one entry for each method × relation. Deterministic for any number of threads.
std::vector<RelationCount> check_relations(const FuzzPlan& plan);

}  // namespace tribunal
