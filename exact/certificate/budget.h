// What a trial is made of: whole sets and sampled streams, by budget.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "exact/base/record.h"
#include "exact/certificate/small_scope.h"
#include "exact/trial/fuzz.h"

namespace tribunal {

/// How much is run. `cases_per_class`: sampled cases of each class in each stream that knows the class of its cases,
/// and 328 times as many in each of the other streams. `rounds`: for polygons, how often each stream goes through all
/// pairs of a ring configuration and a place (22 · 26 = 572 cases). `relation_cases`: cases of each stream on which all
/// relations are checked, the first of those that are sampled.
struct Budget {
  std::string name;
  std::uint64_t cases_per_class;
  bool full_scope;  ///< {0..3}³ and the five-point lines too, not only {0,1,2}³; all of the small scope of polygons
  std::uint64_t rounds = 6;
  std::uint64_t relation_cases = 40;

  friend bool operator==(const Budget&, const Budget&) = default;
};

/// quick: with no failure in 280 the pointwise bound is 1.1 %. standard: all sets, 0.3 %. soak: with all streams that
/// know the class of their cases (16 today), 8.1·10⁶ cases a class, for which the simultaneous 95 % bound is 10⁻⁶;
/// hours to days.
inline const std::vector<Budget> budgets{
    {"quick", 280, false, 18, 1000}, {"standard", 1000, true, 108, 10'000}, {"soak", 506'000, true, 10'800, 500'000}};

/// How many cases each stream samples.
std::uint64_t cases_per_stream(const Budget& budget, Operands operands);

/// A set, and how it is run.
struct WholeSet {
  SetDescription about;
  std::function<ScopeResult(const Method&, unsigned threads)> run;
};

/// The sets that the budget runs whole, in order.
std::vector<WholeSet> whole_sets(const Budget& budget, Operands operands);

/// The record "stream" of a sampled stream, without what depends on the method.
Json stream_record(const Stream& stream, std::uint64_t seed, std::uint64_t cases);

/// The record, marked if it is about polygons; records about triangles have no mark.
Json with_operands(Json record, Operands operands);

/// The record "relation" of relation number r on cases of one format with one kind of probe, without what was counted.
Json relation_record(const FuzzPlan& plan, std::size_t r, Format format, bool of_rays);

/// The record "budget": what the budget asks for, in numbers.
Json budget_record(const Budget& budget);
Budget to_budget(const Record& record);

/// The cases on which a trial with this budget and seed checks the relations; without a method.
FuzzPlan relation_plan(const Budget& budget, std::uint64_t seed, Operands operands);

/// What a whole trial with this budget and seed must have in its log, apart from answers: the sets that are run whole,
/// in order; the record "stream" of each sampled stream, in order, without "taken", which depends on the method; and
/// the records "relation", in order, without what was counted.
struct Owed {
  std::vector<SetDescription> sets;
  std::vector<Json> streams;
  std::vector<Json> relations;
};

Owed owed_by(const Budget& budget, std::uint64_t seed, Operands operands);

}  // namespace tribunal
