#include "exact/certificate/certify.h"

#include <algorithm>
#include <cstdio>
#include <map>
#include <set>

#include "exact/base/failure.h"
#include "exact/base/interrupt.h"
#include "exact/base/progress.h"
#include "exact/base/shown.h"
#include "exact/cases/case_blocks.h"
#include "exact/certificate/certificate.h"
#include "exact/certificate/own_cases.h"
#include "exact/methods/methods.h"
#include "exact/record/contract_json.h"
#include "exact/record/counterexample.h"
#include "exact/record/environment.h"
#include "exact/record/errors_json.h"
#include "exact/record/sample_row.h"
#include "exact/relations/relation.h"
#include "exact/shrink/shrink.h"
#include "exact/trial/observe.h"
#include "exact/trial/severity.h"

namespace tribunal {
namespace {

constexpr std::size_t shrunk_per_class = 3;

/// The method on trial first, then naive ones that must fail somewhere.
FuzzPlan sample_plan(const CertifyPlan& plan) {
  FuzzPlan sample;
  sample.methods = {plan.method};
  for (const Method& naive : calibration_beside(plan.method.name)) sample.methods.push_back(naive);
  sample.streams = plan.streams.empty() ? streams_of(plan.operands) : plan.streams;
  sample.seed = plan.seed;
  sample.threads = plan.threads;
  sample.cases = sample.streams.size() * cases_per_stream(plan.budget, plan.operands);
  return sample;
}

std::string hex(std::uint64_t x) {
  char text[20];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(x));
  return text;
}

Json set_record(const ScopeResult& s) {
  return {{"record", "set"},
          {"set", s.name},
          {"probes", s.of_rays ? "ray" : "segment"},
          {"size", s.size},
          {"judged_by", s.oracles},
          {"classes", s.classes},
          {"answers_hash", hex(s.answers_hash)},
          {"complete", s.complete},
          {"count", to_array(s.count)}};
}

void log_counterexample(ChainedLog& log, const Case& c) {
  log.add({{"record", "counterexample"}, {"case", from_case(c)}});
}

/// The counterexamples of each class or outcome come in the order of preference; of the first few, shrunk, the one that
/// ranks first is logged, or the simplest of these.
class Simplest {
 public:
  /// `slot`: of the case before it was shrunk, which shrinking keeps.
  void offer(Slot slot, Case c) {
    const auto [entry, fresh] = simplest_.try_emplace({slot, Record(c.finding, {c.id}).text_or("fault", "")}, c);
    if (!fresh && is_preferable(c, entry->second)) entry->second = c;
  }
  /// Together with other cases.
  void log_into(ChainedLog& log, std::vector<Case> cases) const {
    for (const auto& [key, c] : simplest_) cases.push_back(c);
    sort_by_rank(cases);
    for (const Case& c : cases) log_counterexample(log, c);
  }

 private:
  /// Whether the first is rather to be shown: it ranks before the second, or it is simpler.
  static bool is_preferable(const Case& a, const Case& b) {
    const Rank of_a = rank_of(a), of_b = rank_of(b);
    return of_a != of_b ? of_a < of_b : is_simpler(a.query, b.query);
  }

  std::map<std::pair<Slot, std::string>, Case> simplest_;  ///< by slot × fault, if it is one
};

void offer_from_sets(Simplest& simplest, const Method& method, const std::vector<ScopeResult>& sets) {
  for (const auto& set : sets) {
    for (const auto& query : set.wrong) {
      simplest.offer(slot_of(exact_truth(query)), to_counterexample(method, query, Format::binary32, set.name));
    }
  }
}

void offer_from_sample(Simplest& simplest, const FuzzPlan& plan, const FuzzReport& report) {
  std::map<std::pair<Slot, Status>, std::size_t> offered;
  std::vector<const Finding*> chosen;
  for (const auto& f : report.findings) {
    if (offered[{slot_of(f.truth), f.answer.status}]++ < shrunk_per_class) chosen.push_back(&f);
  }
  Progress progress("shrink", "counterexamples", chosen.size());
  for (const auto* f : chosen) {
    simplest.offer(slot_of(f->truth), to_counterexample(plan, *f));
    progress.add(1);
  }
}

void end_if_interrupted() {
  if (interrupted() != 0) throw Failure(static_cast<Exit>(128 + interrupted()), "interrupted; no certificate written");
}

std::vector<ScopeResult> run_sets(const CertifyPlan& plan) {
  std::vector<ScopeResult> results;
  for (const WholeSet& set : whole_sets(plan.budget, plan.operands))
    results.push_back(set.run(plan.method, plan.threads));
  return results;
}

std::vector<RelationCount> run_relations(const CertifyPlan& plan) {
  FuzzPlan checked = relation_plan(plan.budget, plan.seed, plan.operands);
  checked.methods = {plan.method};
  checked.threads = plan.threads;
  return check_relations(checked, OnFault::count);
}

Json witness_of(const Query& query, Format format) { return from_case({.id = "", .format = format, .query = query}); }

void log_relations(ChainedLog& log, const CertifyPlan& plan, const std::vector<RelationCount>& counts) {
  const FuzzPlan checked = relation_plan(plan.budget, plan.seed, plan.operands);
  for (const RelationCount& c : counts) {
    Json record = relation_record(checked, c.relation, c.format, c.of_rays);
    record["asked"] = c.asked;
    record["broken"] = c.broken;
    record["faults"] = c.faults;
    if (c.broken > 0) {
      record["first"] = c.first;
      for (const Query& query : c.witness) record["witness"].push_back(witness_of(query, c.format));
    }
    log.add(record);
  }
}

/// Of the queries that a broken relation binds to each other at least one is answered wrongly. Those, shrunk; the first
/// witness of each relation will do.
std::vector<Case> counterexamples_to(const CertifyPlan& plan, const std::vector<RelationCount>& counts) {
  std::vector<Case> cases;
  std::set<std::size_t> shown;
  for (const RelationCount& c : counts) {
    if (c.broken == 0 || !shown.insert(c.relation).second) continue;
    const std::string relation(tribunal::relations_of(plan.operands)[c.relation].name);
    for (const Query& query : c.witness) {
      const Truth truth = exact_truth(query);
      if (!is_wrong(judge(plan.method, truth, try_ask(plan.method, query).answer))) continue;
      Case found = to_counterexample(plan.method, query, c.format, "relation " + relation);
      found.id += "-" + relation;
      cases.push_back(found);
      break;
    }
  }
  return cases;
}

void log_streams(ChainedLog& log, const FuzzPlan& plan) {
  const std::uint64_t n = plan.streams.size();
  for (std::uint64_t i = 0; i < n; ++i) {
    Json record = stream_record(plan.streams[i], plan.seed, (plan.cases + n - 1 - i) / n);
    record["taken"] = takes(plan.methods[0], plan.streams[i].format);
    log.add(record);
  }
}

/// Of the method on trial, on each stream that it takes, also where no hit was measured.
void log_errors(ChainedLog& log, const FuzzPlan& plan, const FuzzReport& report) {
  if (!gives_numbers(plan.methods[0]) || plan.operands() == Operands::polygons) return;
  for (std::size_t s = 0; s < plan.streams.size(); ++s) {
    const Stream& stream = plan.streams[s];
    if (!takes(plan.methods[0], stream.format)) continue;
    log.add(errors_record(plan.methods[0].name, std::string(stream.family->name), stream.format,
                          report.errors[plan.errors_at(0, s)]));
  }
}

constexpr const char* missing = "no certificate written";

std::uint64_t asked_in(const OwnCounts<std::string>& block) {
  std::uint64_t asked = 0;
  for (const auto& part : block.parts) asked += total_of(part.row).asked;
  for (const NonfiniteRow& row : block.nonfinite) asked += row.asked;
  return asked;
}

/// Asks the method about the user's own cases and logs what came of it. It is not asked of operands that it does not
/// take.
void log_own_cases(ChainedLog& log, const CertifyPlan& plan) {
  if (plan.own == nullptr) return;
  const Method& method = plan.method;
  OwnCounts<Spool> all;
  const auto work = [&](const Case& c, CasePlace place, OwnCounts<std::string>& block) {
    block.gives_numbers = gives_numbers(method);
    const Truth truth = is_finite(c.query) ? truth_of_own(c.query, place.number) : Truth{};
    const bool asked = takes(method, c.format) || !is_finite(c.query);
    OwnAnswer answer{c, truth, asked ? method.ask(c.query) : refusal(Status::unsupported)};
    answer.number = place.number;
    if (block.gives_numbers) answer.numbers = [&] { return numbers_of(method, c.query); };
    add(block, method, answer);
  };
  Progress progress("your own", "cases", 0);
  for_each_case<OwnCounts<std::string>>(plan.own->reader(), plan.own->path(), {plan.threads, missing}, work,
                                        [&](const OwnCounts<std::string>& block) {
                                          add(all, block);
                                          progress.add(asked_in(block), 0);
                                        });
  log_own_cases(log, method, all);
}

/// Triangles and polygons have separate certificates.
void require_operands(const Case& c, Operands operands, const Where& where) {
  if (c.query.operands() == operands) return;
  if (operands == Operands::triangles) {
    where.key("rings").fail("triangles are certified apart from polygons, expected \"tri\", or --polygons");
  }
  where.key("tri").fail("polygons are certified apart from triangles, expected \"rings\"");
}

}  // namespace

void require_sound(const Rereadable& cases, Operands operands, unsigned threads) {
  struct Nothing {};
  const auto work = [&](const Case& c, CasePlace place, Nothing&) {
    require_operands(c, operands, {cases.path(), place.line});
    if (!is_finite(c.query)) return;
    const std::string error = mistaken_claim(c, truth_of_own(c.query, place.number));
    if (!error.empty()) throw bad_input(cases.path(), place.line, shown(c.id) + ": " + error);
  };
  for_each_case<Nothing>(cases.reader(), cases.path(), {threads, missing}, work, [](const Nothing&) {});
}

std::vector<Method> calibration_beside(const std::string& method) {
  std::vector<Method> naive;
  for (const Method& m : methods_with(Role::calibration)) {
    if (m.name != method) naive.push_back(m);
  }
  return naive;
}

void log_plan(ChainedLog& log, const Method& method, Operands operands, const std::string& budget, std::uint64_t seed,
              const std::vector<std::string>& command) {
  Json stages = Json::array();
  for (const Stage s : method.stages) stages.push_back(name_of(s));
  Json plan = {{"record", "plan"},
               {"method", method.name},
               {"number", method.card.number},
               {"reference", method.card.reference},
               {"terms", from_contract(method.contract)},
               {"stages", stages},
               {"budget", budget},
               {"seed", seed},
               {"version", log_version}};
  if (!command.empty()) plan["command"] = command;
  log.add(with_operands(plan, operands));
  Json made_with = {{"record", "environment"}};
  made_with.update(environment());
  log.add(made_with);
}

ChainedLog certify(const CertifyPlan& plan) {
  ChainedLog log;
  log_plan(log, plan.method, plan.operands, plan.budget.name, plan.seed);
  log.add(budget_record(plan.budget));
  const std::vector<ScopeResult> sets = run_sets(plan);
  end_if_interrupted();
  for (const ScopeResult& set : sets) log.add(set_record(set));
  const std::vector<RelationCount> relations = run_relations(plan);
  end_if_interrupted();
  log_relations(log, plan, relations);
  const FuzzPlan sample = sample_plan(plan);
  FuzzReport report = fuzz(sample);
  end_if_interrupted();
  std::erase_if(report.findings, [](const Finding& f) { return f.method != 0; });
  ask_again(sample, report);
  log_streams(log, sample);
  for (const SampleRow& row : rows_of(sample, report)) log.add(to_record(row));
  log_errors(log, sample, report);
  Simplest simplest;
  offer_from_sets(simplest, plan.method, sets);
  offer_from_sample(simplest, sample, report);
  simplest.log_into(log, counterexamples_to(plan, relations));
  log_own_cases(log, plan);
  return log;
}

}  // namespace tribunal
