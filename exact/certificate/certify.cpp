#include "exact/certificate/certify.h"

#include <algorithm>
#include <cstdio>
#include <map>

#include "exact/certificate/small_scope.h"
#include "exact/harness/counterexample.h"
#include "exact/harness/environment.h"
#include "exact/harness/interrupt.h"
#include "exact/harness/progress.h"
#include "exact/harness/shrink.h"
#include "exact/io/failure.h"
#include "exact/log/sample_row.h"
#include "exact/methods.h"

namespace tribunal {
namespace {

constexpr std::size_t shrunk_per_class = 3;

/// The method on trial first, then naive ones that must fail somewhere.
FuzzPlan sample_plan(const CertifyPlan& plan) {
  FuzzPlan sample;
  sample.methods = {plan.method};
  for (const char* naive : {"sf-float", "sf-double"}) {
    if (plan.method.name != naive) sample.methods.push_back(*find_method(naive));
  }
  sample.streams = plan.streams;
  sample.seed = plan.seed;
  sample.threads = plan.threads;
  sample.cases = sample.streams.size() * class_count * plan.budget.cases_per_class;
  return sample;
}

std::string hex(std::uint64_t x) {
  char text[20];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(x));
  return text;
}

Json set_record(const ScopeResult& s) {
  return {{"record", "set"},        {"set", s.name},
          {"size", s.size},         {"judged_by", s.oracles},
          {"classes", s.classes},   {"answers_hash", hex(s.answers_hash)},
          {"complete", s.complete}, {"count", to_array(s.count)}};
}

Json stream_record(const Method& method, const Stream& stream, std::uint64_t cases) {
  return {{"record", "stream"},
          {"family", stream.family->name},
          {"fmt", name_of(stream.format)},
          {"axis", stream.family->axis},
          {"population", stream.family->population},
          {"judged_by", oracle_of(*stream.family)},
          {"aims_at_classes", stream.family->proves_class},
          {"taken", takes(method, stream.format)},
          {"cases", cases}};
}

void log_counterexample(ChainedLog& log, const Case& c) {
  log.add({{"record", "counterexample"}, {"case", from_case(c)}});
}

/// Each class's counterexamples come in the order of preference; the simplest of the first few, shrunk, is logged.
class SimplestOfClass {
 public:
  void offer(Case c) {
    const auto [entry, fresh] = simplest_.try_emplace(c.class_id, c);
    if (!fresh && is_simpler(c.query, entry->second.query)) entry->second = c;
  }
  void log_into(ChainedLog& log) const {
    for (const auto& [id, c] : simplest_) log_counterexample(log, c);
  }

 private:
  std::map<ClassId, Case> simplest_;
};

void offer_from_sets(SimplestOfClass& simplest, const Method& method, const std::vector<ScopeResult>& sets) {
  for (const ScopeResult& set : sets) {
    for (const Query& query : set.wrong) simplest.offer(to_counterexample(method, query, Format::binary32, set.name));
  }
}

void offer_from_sample(SimplestOfClass& simplest, const FuzzPlan& plan, const FuzzReport& report) {
  std::map<ClassId, std::size_t> offered;
  std::vector<const Finding*> chosen;
  for (const Finding& f : report.findings) {
    if (f.method == 0 && offered[f.truth.class_id]++ < shrunk_per_class) chosen.push_back(&f);
  }
  Progress progress("shrink", "counterexamples", chosen.size());
  for (const Finding* f : chosen) {
    simplest.offer(to_counterexample(plan, *f));
    progress.add(1);
  }
}

void end_if_interrupted() {
  if (interrupted() != 0) throw Failure(static_cast<Exit>(128 + interrupted()), "interrupted; no certificate written");
}

std::vector<ScopeResult> run_sets(const CertifyPlan& plan) {
  std::vector<ScopeResult> sets{pocket_run(plan.method), lattice_run(plan.method, 3, plan.threads)};
  if (plan.budget.full_scope) {
    sets.push_back(line_run(plan.method));
    sets.push_back(lattice_run(plan.method, 4, plan.threads));
  }
  end_if_interrupted();
  return sets;
}

void log_streams(ChainedLog& log, const FuzzPlan& plan) {
  const std::uint64_t n = plan.streams.size();
  for (std::uint64_t i = 0; i < n; ++i) {
    log.add(stream_record(plan.methods[0], plan.streams[i], (plan.cases + n - 1 - i) / n));
  }
}

}  // namespace

std::vector<Truth> truths_of(const std::vector<Case>& cases, const std::string& file) {
  std::vector<Truth> truths;
  for (const Case& own : cases) {
    truths.push_back(exact_truth(own.query));
    const std::string error = mistaken_claim(own, truths.back());
    if (!error.empty()) throw bad_input(file, 0, own.id + ": " + error);
  }
  return truths;
}

void log_plan(ChainedLog& log, const Method& method, const std::string& budget, std::uint64_t seed) {
  Json stages = Json::array();
  for (const Stage s : method.stages) stages.push_back(name_of(s));
  log.add({{"record", "plan"},
           {"method", method.name},
           {"number", method.number},
           {"reference", method.reference},
           {"convention", name_of(method.convention)},
           {"contract", method.contract},
           {"stages", stages},
           {"budget", budget},
           {"seed", seed}});
  Json made_with = {{"record", "environment"}};
  made_with.update(environment());
  log.add(made_with);
}

void log_own_cases(ChainedLog& log, const Method& method, const std::vector<Case>& cases,
                   const std::vector<Truth>& truths, const std::function<Answer(std::size_t)>& answer) {
  for (const Format format : {Format::binary64, Format::binary32}) {
    SampleRow row{.method = method.name, .family = "your own cases", .format = format};
    std::vector<Case> wrong;
    for (std::size_t i = 0; i < cases.size(); ++i) {
      if (cases[i].format != format) continue;
      const Answer given = takes(method, format) ? answer(i) : refusal(Status::unsupported);
      const Judgement j = judge(method, truths[i], given);
      row.counts[truths[i].class_id].add(j, given.stage);
      if (j == Judgement::wrong) wrong.push_back(with_finding(cases[i], method, truths[i], given));
    }
    const std::uint64_t n = total_of(row).asked;
    if (n == 0) continue;
    log.add({{"record", "stream"},
             {"family", row.family},
             {"fmt", name_of(format)},
             {"axis", "(none)"},
             {"population", "the cases of your file, no more"},
             {"judged_by", "class table, rational kernel, Caratheodory, CGAL where defined"},
             {"aims_at_classes", false},
             {"taken", true},
             {"cases", n}});
    log.add(to_record(row));
    for (const Case& c : wrong) log_counterexample(log, c);
  }
}

ChainedLog certify(const CertifyPlan& plan) {
  ChainedLog log;
  log_plan(log, plan.method, plan.budget.name, plan.seed);
  const std::vector<ScopeResult> sets = run_sets(plan);
  for (const ScopeResult& set : sets) log.add(set_record(set));
  const FuzzPlan sample = sample_plan(plan);
  const FuzzReport report = fuzz(sample);
  end_if_interrupted();
  log_streams(log, sample);
  for (const SampleRow& row : rows_of(sample, report)) log.add(to_record(row));
  SimplestOfClass simplest;
  offer_from_sets(simplest, plan.method, sets);
  offer_from_sample(simplest, sample, report);
  simplest.log_into(log);
  log_own_cases(log, plan.method, plan.cases, plan.truths,
                [&](std::size_t i) { return plan.method.ask(plan.cases[i].query); });
  return log;
}

}  // namespace tribunal
