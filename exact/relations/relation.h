// Relations between answers: checks that need no oracle. For an exact method they hold without exception; for the
// others the rate of violations is a measure of its own.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "exact/cases/families/draw.h"
#include "exact/trial/fuzz.h"

namespace tribunal {

/// What a relation says about one query, ready to be checked for any method.
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

/// All relations about these operands. Adding one is adding a row.
std::span<const Relation> relations_of(Operands operands);

/// How often a method broke a relation on cases of one format with one kind of probe, and the first case that shows it.
/// Each case of the plan counts once here at most.
struct RelationCount {
  std::size_t method = 0, relation = 0;
  Format format = Format::binary64;
  bool of_rays = false;
  std::uint64_t asked = 0, broken = 0;
  std::uint64_t faults = 0;                 ///< not in `asked`: the method did something else than answer
  std::vector<Query> witness{};             ///< the queries of the first instance that broke it
  std::uint64_t first = ~std::uint64_t{0};  ///< the number of its case

  /// Counts one instance, which belongs to case g.
  void add(bool holds, std::uint64_t g, const std::vector<Query>& queries) {
    ++asked;
    if (holds) return;
    ++broken;
    keep(g, queries);
  }

  RelationCount& operator+=(const RelationCount& other) {
    asked += other.asked;
    broken += other.broken;
    faults += other.faults;
    if (other.broken > 0) keep(other.first, other.witness);
    return *this;
  }

 private:
  void keep(std::uint64_t g, const std::vector<Query>& queries) {
    if (g >= first) return;
    first = g;
    witness = queries;
  }
};

/// What becomes of a method that does something else than answer: the check ends with its fault, or it is counted.
enum class OnFault : std::uint8_t { end, count };

/// Checks every relation of the plan's operands on every case of the plan (a segment and a triangle also as the ray
/// through it, from p in the direction of q − p, as that rounds), for every method that promises an answer to it; one
/// entry for each method × relation × format × kind of probe, in this order. Deterministic for any number of threads.
std::vector<RelationCount> check_relations(const FuzzPlan& plan, OnFault on_fault = OnFault::end);

/// What the relation says of case g of the plan, or of the ray that is made of its segment, where `of_rays` asks for
/// it. Nothing where the case has no such probe, or the relation says nothing.
std::optional<Instance> instance_of(const FuzzPlan& plan, std::size_t relation, std::uint64_t g, bool of_rays);

}  // namespace tribunal
