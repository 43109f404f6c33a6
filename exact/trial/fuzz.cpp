#include "exact/trial/fuzz.h"

#include <algorithm>
#include <bit>
#include <map>
#include <optional>
#include <tuple>

#include "exact/base/failure.h"
#include "exact/base/fp_environment.h"
#include "exact/base/interrupt.h"
#include "exact/base/parallel.h"
#include "exact/base/progress.h"
#include "exact/cases/family_table.h"
#include "exact/trial/exact_hit.h"
#include "exact/trial/prepared.h"
#include "exact/trial/severity.h"

namespace tribunal {
namespace {

/// Findings of one key stand for each other: method, stream, slot, fault, outcome, severity.
using Key = std::tuple<std::size_t, std::size_t, Slot, Status, Outcome, Severity>;

/// The first finding of each key, by case number.
using FirstFindings = std::map<Key, Finding>;

void keep_first(FirstFindings& kept, const Finding& f) {
  const auto [entry, fresh] =
      kept.try_emplace({f.method, f.stream, slot_of(f.truth), f.answer.status, f.outcome, f.severity}, f);
  if (!fresh && f.k < entry->second.k) entry->second = f;
}

/// Whether an earlier case has been kept that stands for case k.
bool has_earlier(const FirstFindings& kept, const Key& key, std::uint64_t k) {
  const auto entry = kept.find(key);
  return entry != kept.end() && entry->second.k <= k;
}

/// Consecutive cases of one stream: number first_k onwards.
struct Chunk {
  std::size_t stream = 0;
  std::uint64_t first_k = 0;
  std::vector<Trial> trials{};
  std::vector<Truth> truths{};
  std::vector<std::optional<ExactHit>> exact_hits{};  ///< of the cases that are measured; empty if no method needs them
};

/// The chunk and the answers to it keep their memory from one to the next.
struct Worker {
  CountTable counts;
  std::vector<HitErrors> errors;
  unsigned number = 0;
  FirstFindings findings{};
  std::uint64_t wrong = 0, audited = 0;
  Chunk chunk{};
  std::vector<TrianglePair> pairs{};
  std::vector<Answer> answers{};
};

/// Whether the side from which a triangle is crossed matters to one of them.
bool one_faces(const std::vector<Method>& methods) {
  return std::ranges::any_of(methods,
                             [](const Method& m) { return m.tells_side || m.contract.culling != Culling::none; });
}

Truth truth_in(const FuzzPlan& plan, std::size_t stream, std::uint64_t k, const Trial& trial, bool needs_facing,
               Worker& worker) {
  if (plan.operands() == Operands::polygons) return truth_of(trial, k);
  if (is_audited(plan.seed, stream, k)) {
    ++worker.audited;
    return plan.quick ? audited_truth(trial, plan.quick) : audited_by_oracles(trial, plan.formulations);
  }
  if (plan.quick == nullptr) return formulated_truth(trial, k, needs_facing, plan.formulations);
  return needs_facing ? quick_truth_with_facing(trial, plan.quick) : quick_truth(trial, plan.quick);
}

/// Where a ray hits, for the share of the cases of which that is measured.
void add_exact_hits(const FuzzPlan& plan, Chunk& chunk) {
  chunk.exact_hits.clear();
  if (plan.operands() == Operands::polygons || std::ranges::none_of(plan.methods, gives_numbers)) return;
  chunk.exact_hits.resize(chunk.trials.size());
  for (std::size_t i = 0; i < chunk.trials.size(); ++i) {
    const Query& query = chunk.trials[i].query;
    if (!is_measured(plan.seed, chunk.stream, chunk.first_k + i) || !has_numbers(query, chunk.truths[i])) continue;
    chunk.exact_hits[i] = exact_hit(std::get<Ray>(query.probe), query.triangle());
  }
}

void make_chunk(const FuzzPlan& plan, std::size_t stream, std::uint64_t first_k, std::uint64_t end_k, Worker& worker) {
  Chunk& chunk = worker.chunk;
  chunk.stream = stream;
  chunk.first_k = first_k;
  chunk.trials.clear();
  chunk.truths.clear();
  const Stream& source = plan.streams[stream];
  const bool needs_facing = one_faces(plan.methods);
  for (std::uint64_t k = first_k; k < end_k; ++k) {
    chunk.trials.push_back(source.family->make(source.format, plan.seed, k));
    chunk.truths.push_back(truth_in(plan, stream, k, chunk.trials.back(), needs_facing, worker));
  }
  add_exact_hits(plan, chunk);
}

/// A method that leaves its thread in another environment would spoil every answer after its own, oracles included.
void require_intact_rounding(const Method& method) {
  if (has_exact_rounding()) return;
  require_exact_rounding();
  throw Failure(Exit::fp_environment,
                method.name + " changed the floating-point environment of its thread (rounding, or flush to zero)");
}

bool has_bounds(const Trial& trial) { return trial.query.bounds.has_value(); }

/// In one call where the method has a form for that: of triangles, and of probes without bounds.
void ask_all(const Method& method, Operands operands, Worker& worker) {
  const std::vector<Trial>& trials = worker.chunk.trials;
  worker.answers.resize(trials.size());
  const auto& at_once = method.batch ? method.batch : method.ask_each;
  if (operands == Operands::polygons || !at_once || std::ranges::any_of(trials, has_bounds)) {
    std::ranges::transform(trials, worker.answers.begin(), [&](const Trial& t) { return method.ask(t.query); });
    return;
  }
  worker.pairs.resize(trials.size());
  std::ranges::transform(trials, worker.pairs.begin(), [](const Trial& t) { return pair_of(t.query); });
  at_once(worker.pairs, worker.answers);
}

/// The answer, if the method says the same alone; else the fault. Checked where a batch is wrong, and on every 17th
/// case, as prepared forms are: an odd number, since in many families every other case is a ray.
Answer held_against_ask(const Method& method, const Query& query, const Answer& answer) {
  if (is_fault(answer.status)) return answer;
  require_same_when_prepared(method, query);
  if (!method.batch || query.bounds || query.operands() == Operands::polygons) return answer;
  const Answer by_ask = method.ask(query);
  if (is_fault(by_ask.status)) return by_ask;
  const bool same = by_ask.status == answer.status && by_ask.hit == answer.hit;
  return same ? answer : refusal(Status::differs_in_batch);
}

/// What the method gives with right hits. In a loop of its own: the method may leave another environment behind.
void measure_chunk(const FuzzPlan& plan, std::size_t m, Worker& worker) {
  const Method& method = plan.methods[m];
  const Chunk& chunk = worker.chunk;
  if (!gives_numbers(method) || chunk.exact_hits.empty()) return;
  HitErrors& errors = worker.errors[plan.errors_at(m, chunk.stream)];
  for (std::size_t i = 0; i < chunk.trials.size(); ++i) {
    const Answer& answer = worker.answers[i];
    if (!chunk.exact_hits[i] || !answer.hit || judge(method, chunk.truths[i], answer) != Outcome::right) continue;
    const std::optional<HitAt> given = numbers_of(method, chunk.trials[i].query);
    add_numbers(errors, given, *chunk.exact_hits[i], method.contract.format, chunk.first_k + i);
  }
}

/// Where the answer of method m to the chunk's case i is counted.
Count& count_of(std::size_t m, std::size_t i, Worker& worker) {
  const Chunk& chunk = worker.chunk;
  return worker.counts.at({m, chunk.stream, chunk.trials[i].level, slot_of(chunk.trials[i], chunk.truths[i])});
}

/// The counts are tens of megabytes, of which every case needs two or three lines: all of a chunk are fetched at once.
void prefetch(const Count& count) {
  constexpr std::size_t line = 64;
  for (std::size_t at = 0; at < sizeof(Count); at += line) {
    __builtin_prefetch(reinterpret_cast<const char*>(&count) + at, 1);
  }
}

void judge_chunk(const FuzzPlan& plan, std::size_t m, Worker& worker) {
  const Method& method = plan.methods[m];
  const Chunk& chunk = worker.chunk;
  for (std::size_t i = 0; i < chunk.trials.size(); ++i) prefetch(count_of(m, i, worker));
  ask_all(method, plan.operands(), worker);
  require_intact_rounding(method);
  TwinQuota quota{.early = 1};  // of the fifty cases of a chunk
  for (std::size_t i = 0; i < chunk.trials.size(); ++i) {
    const auto& trial = chunk.trials[i];
    const auto& truth = chunk.truths[i];
    Answer answer = worker.answers[i];
    Outcome outcome = judge(method, truth, answer);
    if (i % 17 == 0 || is_wrong(outcome)) {
      answer = held_against_ask(method, trial.query, answer);
      outcome = judge(method, truth, answer);
    }
    Count& count = count_of(m, i, worker);
    count.add(outcome, answer.stage);
    const std::uint64_t k = chunk.first_k + i;
    if (!is_wrong(outcome)) {
      if (plan.watch) plan.watch(worker.number, {m, chunk.stream, k, trial, truth, answer, outcome});
      continue;
    }
    ++worker.wrong;
    const Severity severity = severity_of(trial.query, truth);
    const Cause cause = quota.cause_of(method, trial.query, truth, outcome, severity, k);
    count.add_wrong(severity, cause);
    if (plan.watch) plan.watch(worker.number, {m, chunk.stream, k, trial, truth, answer, outcome, severity, cause});
    if (has_earlier(worker.findings, {m, chunk.stream, slot_of(truth), answer.status, outcome, severity}, k)) continue;
    keep_first(worker.findings, {m, chunk.stream, k, trial, truth, answer, outcome, severity});
  }
}

/// Cases first ≤ g < end of the plan. Streams take turns: case g is number g / streams of stream g mod streams.
void run_cases(const FuzzPlan& plan, std::uint64_t first, std::uint64_t end, Worker& worker) {
  const std::uint64_t n = plan.streams.size();
  const auto number_below = [n](std::uint64_t g, std::uint64_t stream) { return (g + n - 1 - stream) / n; };
  for (std::size_t stream = 0; stream < n; ++stream) {
    make_chunk(plan, stream, number_below(first, stream), number_below(end, stream), worker);
    for (std::size_t m = 0; m < plan.methods.size(); ++m) {
      if (!takes(plan.methods[m], plan.streams[stream].format)) continue;
      judge_chunk(plan, m, worker);
      measure_chunk(plan, m, worker);
    }
  }
}

std::vector<Finding> in_order(const FirstFindings& kept, std::size_t streams) {
  std::vector<Finding> findings;
  for (const auto& [key, finding] : kept) findings.push_back(finding);
  std::ranges::stable_sort(findings, {}, [&](const auto& f) { return f.k * streams + f.stream; });
  return findings;
}

/// One a thread, for all slices: their tables are most of the memory of a run, and are allocated once.
std::vector<Worker> workers_of(const FuzzPlan& plan) {
  const FuzzReport empty = empty_report(plan);
  std::vector<Worker> workers(plan.threads, Worker{.counts = empty.counts, .errors = empty.errors});
  for (unsigned w = 0; w < plan.threads; ++w) workers[w].number = w;
  return workers;
}

/// Has found nothing yet. The rows of the table, empty now, keep their memory.
void forget(Worker& worker, const FuzzReport& empty) {
  worker.counts = empty.counts;
  worker.errors = empty.errors;
  worker.findings.clear();
  worker.wrong = worker.audited = 0;
}

/// Goes on from the report until case `last` or `stop`, by whole blocks.
void run_slice(const FuzzPlan& plan, std::uint64_t last, FuzzReport& report, std::vector<Worker>& workers,
               Progress& progress, const std::function<bool()>& stop) {
  const FuzzReport empty = empty_report(plan);
  for (Worker& w : workers) forget(w, empty);
  const std::uint64_t start = report.cases;
  const auto begin_of = [&](std::size_t block) {
    return std::min(last, start + block * block_size_of(plan.operands()));
  };
  const auto work = [&](std::size_t block, unsigned w) {
    const std::uint64_t wrong_before = workers[w].wrong;
    run_cases(plan, begin_of(block), begin_of(block + 1), workers[w]);
    progress.add(begin_of(block + 1) - begin_of(block), workers[w].wrong - wrong_before);
  };
  const std::uint64_t blocks = (last - start + block_size_of(plan.operands()) - 1) / block_size_of(plan.operands());
  report.cases = begin_of(run_blocks(blocks, plan.threads, work, stop));
  report.run_here += report.cases - start;

  FirstFindings kept;
  for (const auto& f : report.findings) keep_first(kept, f);
  for (const Worker& w : workers) {
    report.counts += w.counts;
    report.audited += w.audited;
    for (std::size_t i = 0; i < report.errors.size(); ++i) report.errors[i] += w.errors[i];
    for (const auto& [key, finding] : w.findings) keep_first(kept, finding);
  }
  report.findings = in_order(kept, plan.streams.size());
}

/// The next case before which a run until the first finding looks whether it has one: after 1, 2, 4, … 64 blocks, then
/// after every 64. So the cases that it runs do not depend on which thread finds something first.
std::uint64_t next_look(const FuzzPlan& plan, std::uint64_t cases) {
  constexpr std::uint64_t most = 64;
  const std::uint64_t blocks = cases / block_size_of(plan.operands());
  const std::uint64_t look = blocks < most ? std::bit_floor(std::max<std::uint64_t>(blocks, 1)) * (blocks > 0 ? 2 : 1)
                                           : (blocks / most + 1) * most;
  return std::min(plan.cases, look * block_size_of(plan.operands()));
}

bool is_look(const FuzzPlan& plan, std::uint64_t cases) { return cases > 0 && next_look(plan, cases - 1) == cases; }

std::size_t most_levels(const FuzzPlan& plan) {
  std::size_t most = 1;
  for (const auto& s : plan.streams) most = std::max(most, s.family->levels(s.format).size());
  return most;
}

}  // namespace

std::uint64_t case_number(const FuzzPlan& plan, const Finding& finding) {
  return finding.k * plan.streams.size() + finding.stream;
}

FuzzReport empty_report(const FuzzPlan& plan) {
  const std::size_t levels = most_levels(plan);
  return {.counts = CountTable(plan.methods.size(), plan.streams.size(), levels, slots_of(plan.operands())),
          .errors = std::vector<HitErrors>(plan.methods.size() * plan.streams.size()),
          .findings = {}};
}

FuzzReport fuzz(const FuzzPlan& plan, FuzzReport so_far, const Checkpoint& checkpoint) {
  constexpr double seconds_between_checkpoints = 60;
  Progress progress(plan.label, "cases", plan.seconds > 0 ? 0 : plan.cases - so_far.cases);
  double saved = progress.elapsed();
  std::vector<Worker> workers = workers_of(plan);
  while (!is_complete(plan, so_far)) {
    const auto is_due = [&] { return checkpoint && progress.elapsed() - saved > seconds_between_checkpoints; };
    const auto stop = [&] { return (plan.seconds > 0 && progress.elapsed() > plan.seconds) || is_due(); };
    run_slice(plan, plan.until_first ? next_look(plan, so_far.cases) : plan.cases, so_far, workers, progress, stop);
    so_far.seconds = progress.elapsed();
    if (plan.until_first && so_far.findings.size() > 1)
      so_far.findings.erase(so_far.findings.begin() + 1, so_far.findings.end());
    const bool kept = is_complete(plan, so_far) && !so_far.findings.empty();  // to shrink them takes its time too
    if (checkpoint && (kept || is_due() || interrupted() != 0)) {
      checkpoint(so_far);
      saved = progress.elapsed();
    }
    if (interrupted() != 0) break;
  }
  return so_far;
}

FuzzReport fuzz(const FuzzPlan& plan) { return fuzz(plan, empty_report(plan), {}); }

ClassBy quick_class_for(const std::vector<Method>& methods, Operands operands) {
  const bool one_is_exact = std::ranges::any_of(methods, [](const Method& m) { return m.contract.exact; });
  return one_is_exact || operands == Operands::polygons ? nullptr : certified_class;
}

std::uint64_t block_size_of(Operands operands) { return operands == Operands::triangles ? 2048 : 256; }

bool is_complete(const FuzzPlan& plan, const FuzzReport& report) {
  const bool found = plan.until_first && !report.findings.empty() && is_look(plan, report.cases);
  return found || report.cases == plan.cases || (plan.seconds > 0 && report.seconds > plan.seconds);
}

std::string name_of(const Stream& s) { return std::string(s.family->name) + " " + std::string(name_of(s.format)); }

std::vector<Stream> streams_of(Operands operands) {
  std::vector<Stream> streams;
  for (const Family& family : families_of(operands)) {
    for (const Format format : {Format::binary64, Format::binary32}) streams.push_back({&family, format});
  }
  return streams;
}

}  // namespace tribunal
