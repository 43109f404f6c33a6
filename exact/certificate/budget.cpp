#include "exact/certificate/budget.h"

#include <algorithm>

#include "exact/base/sha256.h"
#include "exact/cases/case_io.h"
#include "exact/classes/class_table.h"
#include "exact/record/sample_row.h"
#include "exact/relations/relation.h"

namespace tribunal {
namespace {

std::vector<WholeSet> sets_of_triangles(const Budget& budget) {
  using M = const Method&;
  std::vector<WholeSet> sets = {
      {pocket_set(), [](M m, unsigned) { return pocket_run(m); }},
      {lattice_set(3), [](M m, unsigned threads) { return lattice_run(m, 3, threads); }},
      {ray_pocket_set(), [](M m, unsigned) { return ray_pocket_run(m); }},
      {ray_lattice_set(false), [](M m, unsigned threads) { return ray_lattice_run(m, false, threads); }}};
  if (!budget.full_scope) return sets;
  sets.push_back({line_set(), [](M m, unsigned) { return line_run(m); }});
  sets.push_back({lattice_set(4), [](M m, unsigned threads) { return lattice_run(m, 4, threads); }});
  sets.push_back({ray_lattice_set(true), [](M m, unsigned threads) { return ray_lattice_run(m, true, threads); }});
  return sets;
}

std::vector<WholeSet> sets_of_polygons(const Budget& budget) {
  using M = const Method&;
  const int most = budget.full_scope ? 6 : 5;
  std::vector<WholeSet> sets = {
      {rings_set(4), [](M m, unsigned) { return pocket_of_rings_run(m); }},
      {rings_set(most), [most](M m, unsigned threads) { return rings_run(m, most, threads); }},
      {ray_rings_set(most), [most](M m, unsigned threads) { return ray_rings_run(m, most, threads); }},
      {holes_set(3), [](M m, unsigned threads) { return holes_run(m, 3, threads); }},
      {two_holes_set(), [](M m, unsigned threads) { return two_holes_run(m, threads); }}};
  if (!budget.full_scope) return sets;
  sets.push_back({holes_set(4), [](M m, unsigned threads) { return holes_run(m, 4, threads); }});
  sets.push_back({centred_rings_set(), [](M m, unsigned threads) { return centred_rings_run(m, threads); }});
  return sets;
}

/// A digest of the stream's first cases, by which a log shows that they were made from the seed that it names.
std::string digest_of(const Stream& stream, std::uint64_t seed) {
  std::string first;
  for (std::uint64_t k = 0; k < 16; ++k)
    first += from_case({.id = "", .query = stream.family->make(stream.format, seed, k).query}).dump();
  return sha256(first);
}

}  // namespace

std::uint64_t cases_per_stream(const Budget& b, Operands operands) {
  return operands == Operands::triangles ? all_class_count * b.cases_per_class : shape_count * place_count * b.rounds;
}

std::vector<WholeSet> whole_sets(const Budget& budget, Operands operands) {
  return operands == Operands::triangles ? sets_of_triangles(budget) : sets_of_polygons(budget);
}

Json stream_record(const Stream& stream, std::uint64_t seed, std::uint64_t cases) {
  const Json record = {{"record", "stream"},
                       {"family", stream.family->name},
                       {"fmt", name_of(stream.format)},
                       {"axis", stream.family->axis},
                       {"population", stream.family->population},
                       {"judged_by", oracle_of(*stream.family)},
                       {"aims_at_classes", stream.family->constructs},
                       {"first_cases", digest_of(stream, seed)},
                       {"cases", cases}};
  return with_operands(record, stream.family->operands);
}

Json with_operands(Json record, Operands operands) {
  if (operands == Operands::polygons) record["operands"] = "polygons";
  return record;
}

Json budget_record(const Budget& b) {
  return {{"record", "budget"},         {"budget", b.name},   {"cases_per_class", b.cases_per_class},
          {"full_scope", b.full_scope}, {"rounds", b.rounds}, {"relation_cases", b.relation_cases}};
}

/// Older logs have no relations, and do not say how many cases these are checked on. The numbers are so small that no
/// product of the plan overflows.
Budget to_budget(const Record& record) {
  constexpr std::uint64_t most = std::uint64_t{1} << 32;
  record.keys({"record", "budget", "cases_per_class", "full_scope", "rounds", "relation_cases"});
  return {record.text("budget"), record.count("cases_per_class", most), record.truth("full_scope"),
          record.count("rounds", most), record.count_or("relation_cases", 0, most)};
}

FuzzPlan relation_plan(const Budget& budget, std::uint64_t seed, Operands operands) {
  FuzzPlan plan{.methods = {}, .streams = streams_of(operands), .seed = seed};
  plan.cases = plan.streams.size() * budget.relation_cases;
  return plan;
}

Json relation_record(const FuzzPlan& plan, std::size_t r, Format format, bool of_rays) {
  const Relation& relation = relations_of(plan.operands())[r];
  const auto streams = std::ranges::count(plan.streams, format, &Stream::format);
  const Json record = {{"record", "relation"},
                       {"relation", relation.name},
                       {"statement", relation.statement},
                       {"fmt", name_of(format)},
                       {"probes", of_rays ? "ray" : "segment"},
                       {"cases", static_cast<std::uint64_t>(streams) * (plan.cases / plan.streams.size())}};
  return with_operands(record, plan.operands());
}

Owed owed_by(const Budget& budget, std::uint64_t seed, Operands operands) {
  Owed owed;
  for (const WholeSet& set : whole_sets(budget, operands)) owed.sets.push_back(set.about);
  for (const Stream& stream : streams_of(operands)) {
    owed.streams.push_back(stream_record(stream, seed, cases_per_stream(budget, operands)));
  }
  const FuzzPlan plan = relation_plan(budget, seed, operands);
  for (std::size_t r = 0; r < relations_of(operands).size(); ++r) {
    for (const Format format : {Format::binary64, Format::binary32}) {
      for (const bool rays : {false, true}) owed.relations.push_back(relation_record(plan, r, format, rays));
    }
  }
  return owed;
}

}  // namespace tribunal
