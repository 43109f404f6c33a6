// How a fuzz run goes, whatever the operands. Included by the files that instantiate it: harness/fuzz.cpp and
// polygon/fuzz.cpp.
#pragma once

#include <algorithm>
#include <map>
#include <tuple>

#include "exact/harness/fp_environment.h"
#include "exact/harness/fuzz.h"
#include "exact/harness/interrupt.h"
#include "exact/harness/parallel.h"
#include "exact/harness/prepared.h"
#include "exact/harness/progress.h"
#include "exact/io/failure.h"

namespace tribunal {
namespace fuzz_detail {

/// The first finding of each method × stream × class or outcome, by case number.
template <class On>
using FirstFindings = std::map<std::tuple<std::size_t, std::size_t, Slot>, BasicFinding<On>>;

template <class On>
void keep_first(FirstFindings<On>& kept, const BasicFinding<On>& f) {
  const auto [entry, fresh] = kept.try_emplace({f.method, f.stream, slot_of(f.truth)}, f);
  if (!fresh && f.k < entry->second.k) entry->second = f;
}

template <class On>
struct Worker {
  CountTable counts;
  FirstFindings<On> findings{};
  std::uint64_t wrong = 0;
  std::vector<typename On::Answer> answers{};
};

/// Consecutive cases of one stream: number first_k onwards.
template <class On>
struct Chunk {
  std::size_t stream;
  std::uint64_t first_k;
  std::vector<typename On::Trial> trials{};
  std::vector<typename On::Truth> truths{};
  std::vector<typename On::Query> queries{};
};

template <class On>
Chunk<On> make_chunk(const BasicFuzzPlan<On>& plan, std::size_t stream, std::uint64_t first_k, std::uint64_t end_k) {
  Chunk<On> chunk{stream, first_k};
  const BasicStream<On>& source = plan.streams[stream];
  for (std::uint64_t k = first_k; k < end_k; ++k) {
    chunk.trials.push_back(source.family->make(source.format, plan.seed, k));
    chunk.truths.push_back(On::truth_of(chunk.trials.back(), k));
    chunk.queries.push_back(chunk.trials.back().query);
  }
  return chunk;
}

/// A method that leaves its thread in another environment would spoil every answer after its own, oracles included.
inline void require_intact_rounding(const Method& method) {
  if (has_exact_rounding()) return;
  require_exact_rounding();
  throw Failure(Exit::fp_environment,
                method.name + " changed the floating-point environment of its thread (rounding, or flush to zero)");
}

template <class Q, class A>
void ask_one_by_one(const Method& method, const std::vector<Q>& queries, std::vector<A>& answers) {
  std::ranges::transform(queries, answers.begin(), [&](const Q& query) { return method.ask(query); });
}

inline void ask_all(const Method& method, const std::vector<PolygonQuery>& queries,
                    std::vector<PolygonAnswer>& answers) {
  ask_one_by_one(method, queries, answers);
}

inline void ask_all(const Method& method, const std::vector<Query>& queries, std::vector<Answer>& answers) {
  if (method.batch) {
    method.batch(queries, answers);
  } else {
    ask_one_by_one(method, queries, answers);
  }
}

inline void require_same_by_ask(const Method&, const PolygonQuery&, const PolygonAnswer&) {}

/// What a batch or a prepared form must never do. Checked where it is wrong, and on every 17th case: an odd number,
/// since in many families every other case is a ray.
inline void require_same_by_ask(const Method& method, const Query& query, const Answer& by_batch) {
  require_same_when_prepared(method, query);
  if (!method.batch) return;
  const Answer by_ask = method.ask(query);
  if (by_ask.status == by_batch.status && by_ask.hit == by_batch.hit) return;
  throw Failure(Exit::disagreement, method.name + " answers otherwise in a batch than alone, on " +
                                        from_case(Case{.id = "batch", .query = query}).dump());
}

template <class On>
void judge_chunk(const BasicFuzzPlan<On>& plan, const Chunk<On>& chunk, std::size_t m, Worker<On>& worker) {
  const Method& method = plan.methods[m];
  worker.answers.resize(chunk.queries.size());
  ask_all(method, chunk.queries, worker.answers);
  require_intact_rounding(method);
  for (std::size_t i = 0; i < chunk.trials.size(); ++i) {
    const auto& trial = chunk.trials[i];
    const auto& truth = chunk.truths[i];
    const auto& answer = worker.answers[i];
    const Judgement judgement = judge(method, truth, answer);
    if (judgement == Judgement::wrong || i % 17 == 0) require_same_by_ask(method, chunk.queries[i], answer);
    worker.counts.at({m, chunk.stream, trial.level, On::slot_of(trial, truth)}).add(judgement, plain(answer).stage);
    if (judgement != Judgement::wrong) continue;
    ++worker.wrong;
    keep_first<On>(worker.findings, {m, chunk.stream, chunk.first_k + i, trial, truth, answer});
  }
}

/// Cases first ≤ g < end of the plan. Streams take turns: case g is number g / streams of stream g mod streams.
template <class On>
void run_cases(const BasicFuzzPlan<On>& plan, std::uint64_t first, std::uint64_t end, Worker<On>& worker) {
  const std::uint64_t n = plan.streams.size();
  const auto number_below = [n](std::uint64_t g, std::uint64_t stream) { return (g + n - 1 - stream) / n; };
  for (std::size_t stream = 0; stream < n; ++stream) {
    const Chunk<On> chunk = make_chunk(plan, stream, number_below(first, stream), number_below(end, stream));
    for (std::size_t m = 0; m < plan.methods.size(); ++m) {
      if (takes(plan.methods[m], plan.streams[stream].format)) judge_chunk(plan, chunk, m, worker);
    }
  }
}

template <class On>
std::vector<BasicFinding<On>> in_order(const FirstFindings<On>& kept, std::size_t streams) {
  std::vector<BasicFinding<On>> findings;
  for (const auto& [key, finding] : kept) findings.push_back(finding);
  std::ranges::stable_sort(findings, {}, [&](const auto& f) { return f.k * streams + f.stream; });
  return findings;
}

/// Goes on from the report until the plan's end or `stop`, by whole blocks.
template <class On>
void run_slice(const BasicFuzzPlan<On>& plan, BasicFuzzReport<On>& report, Progress& progress,
               const std::function<bool()>& stop) {
  std::vector<Worker<On>> workers(plan.threads, Worker<On>{.counts = empty_report(plan).counts});
  const std::uint64_t start = report.cases;
  const auto begin_of = [&](std::size_t block) { return std::min(plan.cases, start + block * On::block_size); };
  const auto work = [&](std::size_t block, unsigned w) {
    const std::uint64_t wrong_before = workers[w].wrong;
    run_cases(plan, begin_of(block), begin_of(block + 1), workers[w]);
    progress.add(begin_of(block + 1) - begin_of(block), workers[w].wrong - wrong_before);
  };
  const std::uint64_t blocks = (plan.cases - start + On::block_size - 1) / On::block_size;
  report.cases = begin_of(run_blocks(blocks, plan.threads, work, stop));
  report.run_here += report.cases - start;

  FirstFindings<On> kept;
  for (const auto& f : report.findings) keep_first<On>(kept, f);
  for (const Worker<On>& w : workers) {
    report.counts += w.counts;
    for (const auto& [key, finding] : w.findings) keep_first<On>(kept, finding);
  }
  report.findings = in_order<On>(kept, plan.streams.size());
}

template <class On>
std::size_t most_levels(const BasicFuzzPlan<On>& plan) {
  std::size_t most = 1;
  for (const auto& s : plan.streams) most = std::max(most, s.family->levels(s.format).size());
  return most;
}

}  // namespace fuzz_detail

template <class On>
BasicFuzzReport<On> empty_report(const BasicFuzzPlan<On>& plan) {
  const std::size_t levels = fuzz_detail::most_levels(plan);
  return {.counts = CountTable(plan.methods.size(), plan.streams.size(), levels, slots_of(On::operands)),
          .findings = {}};
}

template <class On>
BasicFuzzReport<On> fuzz(const BasicFuzzPlan<On>& plan, BasicFuzzReport<On> so_far,
                         const std::type_identity_t<Checkpoint<On>>& checkpoint) {
  constexpr double seconds_between_checkpoints = 60;
  Progress progress("fuzz", "cases", plan.seconds > 0 ? 0 : plan.cases - so_far.cases);
  while (!is_complete(plan, so_far)) {
    const double started = progress.elapsed();
    const auto stop = [&] {
      const double now = progress.elapsed();
      return (plan.seconds > 0 && now > plan.seconds) || (checkpoint && now - started > seconds_between_checkpoints);
    };
    fuzz_detail::run_slice(plan, so_far, progress, stop);
    so_far.seconds = progress.elapsed();
    if (checkpoint && !is_complete(plan, so_far)) checkpoint(so_far);
    if (interrupted() != 0) break;
  }
  return so_far;
}

}  // namespace tribunal
