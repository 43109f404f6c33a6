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

std::uint64_t cases_per_stream(const Budget& b, OnTriangles) { return all_class_count * b.cases_per_class; }
std::uint64_t cases_per_stream(const Budget& b, OnPolygons) { return shape_count * place_count * b.rounds; }

/// The method on trial first, then naive ones that must fail somewhere.
template <class On>
BasicFuzzPlan<On> sample_plan(const BasicCertifyPlan<On>& plan) {
  BasicFuzzPlan<On> sample;
  sample.methods = {plan.method};
  for (const Method& naive : calibration_beside(plan.method.name)) sample.methods.push_back(naive);
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

/// Says of polygons that it is about them; of triangles it goes without saying.
Json with_operands(Json record, Operands operands) {
  if (operands == Operands::polygons) record["operands"] = "polygons";
  return record;
}

Json case_of(const Trial& t) { return from_case(Case{.id = "", .query = t.query}); }
Json case_of(const PolygonTrial& t) { return from_case(PolygonCase{.id = "", .query = t.query}); }

/// A digest of the stream's first cases, so that a log tells whether the seed that it names made them.
template <class On>
std::string digest_of(const BasicStream<On>& stream, std::uint64_t seed) {
  std::string first;
  for (std::uint64_t k = 0; k < 16; ++k) first += case_of(stream.family->make(stream.format, seed, k)).dump();
  return sha256(first);
}

/// All but what depends on the method.
template <class On>
Json stream_record(const BasicStream<On>& stream, std::uint64_t seed, std::uint64_t cases) {
  const Json record = {{"record", "stream"},
                       {"family", stream.family->name},
                       {"fmt", name_of(stream.format)},
                       {"axis", stream.family->axis},
                       {"population", stream.family->population},
                       {"judged_by", On::oracle_of(*stream.family)},
                       {"aims_at_classes", On::aims(*stream.family)},
                       {"first_cases", digest_of(stream, seed)},
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
    const auto [entry, fresh] = simplest_.try_emplace({slot, c.finding.value("fault", "")}, c);
    if (!fresh && is_simpler(c.query, entry->second.query)) entry->second = c;
  }
  void log_into(ChainedLog& log) const {
    for (const auto& [key, c] : simplest_) log_counterexample(log, c);
  }

 private:
  std::map<std::pair<Slot, std::string>, typename On::Case> simplest_;  ///< by slot × fault, if it is one
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
  std::map<std::pair<Slot, Status>, std::size_t> offered;
  std::vector<const BasicFinding<On>*> chosen;
  for (const auto& f : report.findings) {
    if (f.method == 0 && offered[{slot_of(f.truth), plain(f.answer).status}]++ < shrunk_per_class) chosen.push_back(&f);
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

/// A set, and how it is run.
template <class On>
struct WholeSet {
  SetDescription about;
  std::function<BasicScopeResult<On>(const Method&, unsigned threads)> run;
};

std::vector<WholeSet<OnTriangles>> whole_sets(const Budget& budget, OnTriangles) {
  using M = const Method&;
  std::vector<WholeSet<OnTriangles>> sets = {
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

std::vector<WholeSet<OnPolygons>> whole_sets(const Budget& budget, OnPolygons) {
  using M = const Method&;
  const int most = budget.full_scope ? 6 : 5;
  std::vector<WholeSet<OnPolygons>> sets = {
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

template <class On>
std::vector<BasicScopeResult<On>> run_sets(const BasicCertifyPlan<On>& plan) {
  std::vector<BasicScopeResult<On>> results;
  for (const WholeSet<On>& set : whole_sets(plan.budget, On{})) results.push_back(set.run(plan.method, plan.threads));
  return results;
}

template <class On>
Owed owed_on(const Budget& budget, std::uint64_t seed) {
  Owed owed;
  for (const WholeSet<On>& set : whole_sets(budget, On{})) owed.sets.push_back(set.about);
  for (const auto& stream : every_stream(On{})) {
    owed.streams.push_back(stream_record(stream, seed, cases_per_stream(budget, On{})));
  }
  return owed;
}

template <class On>
void log_streams(ChainedLog& log, const BasicFuzzPlan<On>& plan) {
  const std::uint64_t n = plan.streams.size();
  for (std::uint64_t i = 0; i < n; ++i) {
    Json record = stream_record(plan.streams[i], plan.seed, (plan.cases + n - 1 - i) / n);
    record["taken"] = takes(plan.methods[0], plan.streams[i].format);
    log.add(record);
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

std::vector<Method> calibration_beside(const std::string& method) {
  std::vector<Method> naive;
  for (const char* name : {"sf-float", "sf-double"}) {
    if (method != name) naive.push_back(*find_method(name));
  }
  return naive;
}

Json budget_record(const Budget& b) {
  return {{"record", "budget"},
          {"budget", b.name},
          {"cases_per_class", b.cases_per_class},
          {"full_scope", b.full_scope},
          {"rounds", b.rounds}};
}

Budget to_budget(const Json& record, const Where& where) {
  return {string_of(record, "budget", where), number_of(record, "cases_per_class", where),
          truth_value_of(record, "full_scope", where), number_of(record, "rounds", where)};
}

Owed owed_by(const Budget& budget, std::uint64_t seed, Operands operands) {
  return operands == Operands::polygons ? owed_on<OnPolygons>(budget, seed) : owed_on<OnTriangles>(budget, seed);
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
      if (j == Judgement::wrong) wrong.push_back(with_steady_finding(cases[i], method, truths[i], given));
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
  log.add(budget_record(plan.budget));
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
