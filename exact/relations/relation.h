// Relations between answers: checks that need no oracle. For an exact method they hold without exception; for the
// others the rate of violations is a figure in itself.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "exact/families/draw.h"
#include "exact/harness/fuzz.h"

namespace tribunal {

/// `same`: both queries have the same answer. `keeps_hit`: if the first is a hit, so is the second.
enum class Promise : std::uint8_t { same, keeps_hit };

struct Relation {
  std::string_view name;
  std::string_view statement;
  Promise promise;
  /// Another query, or nothing where it cannot be formed exactly in the format.
  std::optional<Query> (*transform)(const Query& query, Format format, Draw& draw);
};

/// Adding one is adding a row.
std::span<const Relation> all_relations();

/// How often a method broke a relation, and the first case that shows it.
struct RelationCount {
  std::size_t method, relation;
  std::uint64_t asked = 0, broken = 0;
  std::optional<std::pair<Query, Query>> witness{};
};

/// Every relation on every case of the plan, for every method; one entry for each method × relation. Deterministic
/// for any number of threads.
std::vector<RelationCount> check_relations(const FuzzPlan& plan);

}  // namespace tribunal
