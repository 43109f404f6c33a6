#include "exact/certificate/certify.h"

#include <algorithm>
#include <cstdio>
#include <map>

#include "exact/certificate/certificate.h"
#include "exact/certificate/small_scope.h"
#include "exact/classes/class_table.h"
#include "exact/harness/counterexample.h"
#include "exact/harness/environment.h"
#include "exact/harness/interrupt.h"
#include "exact/harness/progress.h"
#include "exact/harness/shrink.h"
#include "exact/io/failure.h"
#include "exact/log/sample_row.h"
#include "exact/methods.h"
#include "exact/polygon/shrink.h"

namespace tribunal {
namespace {

constexpr std::size_t shrunk_per_class = 3;

std::vector<Stream> every_stream(OnTriangles) { return all_streams(); }
std::vector<PolygonStream> every_stream(OnPolygons) { return all_polygon_streams(); }

std::uint64_t cases_per_stream(const Budget& b, OnTriangles) { return class_count * b.cases_per_class; }
std::uint64_t cases_per_stream(const Budget& b, OnPolygons) { return shape_count * place_count * b.rounds; }

/// The method on trial first, then naive ones that must fail somewhere.
template <class On>
BasicFuzzPlan<On> sample_plan(const BasicCertifyPlan<On>& plan) {
  BasicFuzzPlan<On> sample;
  sample.methods = {plan.method};
  for (const char* naive : {"sf-float", "sf-double"}) {
    if (plan.method.name != naive) sample.methods.push_back(*find_method(naive));
  }
  sample.streams = plan.streams.empty() ? every_stream(On{}) : plan.streams;
  sample.seed = plan.seed;
  sample.threads = plan.threads;
  sample.cases = sample.streams.size() * cases_per_stream(plan.budget, On{});
  return sample;
}

std::string hex(std::uint64_t x) {
  char text[20];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(x));
  return text;
}

template <class On>
Json set_record(const BasicScopeResult<On>& s) {
  return {{"record", "set"},        {"set", s.name},
          {"size", s.size},         {"judged_by", s.oracles},
          {"classes", s.classes},   {"answers_hash", hex(s.answers_hash)},
          {"complete", s.complete}, {"count", to_array(s.count)}};
}

/// Says of polygons that it is about them; of triangles it goes without saying.
Json with_operands(Json record, Operands operands) {
  if (operands == Operands::polygons) record["operands"] = "polygons";
  return record;
}

template <class On>
Json stream_record(const Method& method, const BasicStream<On>& stream, std::uint64_t cases) {
  const Json record = {{"record", "stream"},
                       {"family", stream.family->name},
                       {"fmt", name_of(stream.format)},
                       {"axis", stream.family->axis},
                       {"population", stream.family->population},
                       {"judged_by", On::oracle_of(*stream.family)},
                       {"aims_at_classes", On::aims(*stream.family)},
                       {"taken", takes(method, stream.format)},
                       {"cases", cases}};
  return with_operands(record, On::operands);
}

template <class C>
void log_counterexample(ChainedLog& log, const C& c) {
  log.add({{"record", "counterexample"}, {"case", from_case(c)}});
}

/// The counterexamples of each class or outcome come in the order of preference; the simplest of the first few, shrunk,
/// is logged.
template <class On>
class Simplest {
 public:
  /// `slot`: of the case before it was shrunk, which shrinking keeps.
  void offer(Slot slot, typename On::Case c) {
    const auto [entry, fresh] = simplest_.try_emplace(slot, c);
    if (!fresh && is_simpler(c.query, entry->second.query)) entry->second = c;
  }
  void log_into(ChainedLog& log) const {
    for (const auto& [slot, c] : simplest_) log_counterexample(log, c);
  }

 private:
  std::map<Slot, typename On::Case> simplest_;
};

template <class On>
void offer_from_sets(Simplest<On>& simplest, const Method& method, const std::vector<BasicScopeResult<On>>& sets) {
  for (const auto& set : sets) {
    for (const auto& query : set.wrong) {
      simplest.offer(slot_of(exact_truth(query)), to_counterexample<On>(method, query, Format::binary32, set.name));
    }
  }
}

template <class On>
void offer_from_sample(Simplest<On>& simplest, const BasicFuzzPlan<On>& plan, const BasicFuzzReport<On>& report) {
  std::map<Slot, std::size_t> offered;
  std::vector<const BasicFinding<On>*> chosen;
  for (const auto& f : report.findings) {
    if (f.method == 0 && offered[slot_of(f.truth)]++ < shrunk_per_class) chosen.push_back(&f);
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
  std::vector<ScopeResult> sets{pocket_run(plan.method), lattice_run(plan.method, 3, plan.threads)};
  if (plan.budget.full_scope) {
    sets.push_back(line_run(plan.method));
    sets.push_back(lattice_run(plan.method, 4, plan.threads));
  }
  return sets;
}

std::vector<PolygonScopeResult> run_sets(const PolygonCertifyPlan& plan) {
  std::vector<PolygonScopeResult> sets{pocket_of_rings_run(plan.method)};
  sets.push_back(rings_run(plan.method, plan.budget.full_scope ? 6 : 5, plan.threads));
  if (plan.budget.full_scope) {
    sets.push_back(holes_run(plan.method, plan.threads));
    sets.push_back(centred_rings_run(plan.method, plan.threads));
  }
  return sets;
}

template <class On>
void log_streams(ChainedLog& log, const BasicFuzzPlan<On>& plan) {
  const std::uint64_t n = plan.streams.size();
  for (std::uint64_t i = 0; i < n; ++i) {
    log.add(stream_record(plan.methods[0], plan.streams[i], (plan.cases + n - 1 - i) / n));
  }
}

template <class T, class C>
std::vector<T> truths_of_all(const std::vector<C>& cases, const std::string& file) {
  std::vector<T> truths;
  for (const C& own : cases) {
    truths.push_back(exact_truth(own.query));
    const std::string error = mistaken_claim(own, truths.back());
    if (!error.empty()) throw bad_input(file, 0, own.id + ": " + error);
  }
  return truths;
}

const char* oracles_of_own_cases(Operands operands) {
  return operands == Operands::polygons ? polygon_oracles
                                        : "class table, rational kernel, Caratheodory, CGAL where defined";
}

}  // namespace

std::vector<Truth> truths_of(const std::vector<Case>& cases, const std::string& file) {
  return truths_of_all<Truth>(cases, file);
}

std::vector<PolygonTruth> truths_of(const std::vector<PolygonCase>& cases, const std::string& file) {
  return truths_of_all<PolygonTruth>(cases, file);
}

void log_plan(ChainedLog& log, const Method& method, Operands operands, const std::string& budget, std::uint64_t seed) {
  Json stages = Json::array();
  for (const Stage s : method.stages) stages.push_back(name_of(s));
  const Json plan = {{"record", "plan"},
                     {"method", method.name},
                     {"number", method.number},
                     {"reference", method.reference},
                     {"convention", name_of(method.convention)},
                     {"contract", method.contract},
                     {"stages", stages},
                     {"budget", budget},
                     {"seed", seed}};
  log.add(with_operands(plan, operands));
  Json made_with = {{"record", "environment"}};
  made_with.update(environment());
  log.add(made_with);
}

template <class On>
void log_own_cases(ChainedLog& log, const Method& method, const std::vector<typename On::Case>& cases,
                   const std::vector<typename On::Truth>& truths,
                   const std::function<typename On::Answer(std::size_t)>& answer) {
  for (const Format format : {Format::binary64, Format::binary32}) {
    SampleRow row{.method = method.name, .family = own_cases, .format = format};
    std::vector<typename On::Case> wrong;
    for (std::size_t i = 0; i < cases.size(); ++i) {
      if (cases[i].format != format) continue;
      typename On::Answer given{refusal(Status::unsupported)};
      if (takes(method, format)) given = answer(i);
      const Judgement j = judge(method, truths[i], given);
      row.counts[slot_of(truths[i])].add(j, plain(given).stage);
      if (j == Judgement::wrong) wrong.push_back(with_finding(cases[i], method, truths[i], given));
    }
    const std::uint64_t n = total_of(row).asked;
    if (n == 0) continue;
    const Json stream = {{"record", "stream"},
                         {"family", row.family},
                         {"fmt", name_of(format)},
                         {"axis", "(none)"},
                         {"population", "the cases of your file, no more"},
                         {"judged_by", oracles_of_own_cases(On::operands)},
                         {"aims_at_classes", false},
                         {"taken", true},
                         {"cases", n}};
    log.add(with_operands(stream, On::operands));
    log.add(to_record(row));
    for (const auto& c : wrong) log_counterexample(log, c);
  }
}

template void log_own_cases<OnTriangles>(ChainedLog&, const Method&, const std::vector<Case>&,
                                         const std::vector<Truth>&, const std::function<Answer(std::size_t)>&);
template void log_own_cases<OnPolygons>(ChainedLog&, const Method&, const std::vector<PolygonCase>&,
                                        const std::vector<PolygonTruth>&,
                                        const std::function<PolygonAnswer(std::size_t)>&);

template <class On>
ChainedLog certify(const BasicCertifyPlan<On>& plan) {
  ChainedLog log;
  log_plan(log, plan.method, On::operands, plan.budget.name, plan.seed);
  const std::vector<BasicScopeResult<On>> sets = run_sets(plan);
  end_if_interrupted();
  for (const auto& set : sets) log.add(set_record(set));
  const BasicFuzzPlan<On> sample = sample_plan(plan);
  const BasicFuzzReport<On> report = fuzz(sample);
  end_if_interrupted();
  log_streams(log, sample);
  for (const SampleRow& row : rows_of(sample, report)) log.add(to_record(row));
  Simplest<On> simplest;
  offer_from_sets(simplest, plan.method, sets);
  offer_from_sample(simplest, sample, report);
  simplest.log_into(log);
  log_own_cases<On>(log, plan.method, plan.cases, plan.truths,
                    [&](std::size_t i) { return plan.method.ask(plan.cases[i].query); });
  return log;
}

template ChainedLog certify(const CertifyPlan& plan);
template ChainedLog certify(const PolygonCertifyPlan& plan);

}  // namespace tribunal
