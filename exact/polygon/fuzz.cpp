#include "exact/polygon/fuzz.h"

#include <algorithm>
#include <set>

#include "exact/harness/parallel.h"
#include "exact/harness/progress.h"

namespace tribunal {
namespace {

constexpr std::uint64_t block_size = 256;

using FindingKey = std::tuple<std::size_t, std::size_t, Contact, bool>;
using FirstFindings = std::map<FindingKey, PolygonFinding>;

void keep_first(FirstFindings& kept, const PolygonFinding& f) {
  const auto [entry, fresh] = kept.try_emplace({f.method, f.stream, f.truth.contact, f.truth.planar}, f);
  if (!fresh && f.k < entry->second.k) entry->second = f;
}

struct Worker {
  std::map<PolygonCell, Count> counts{};
  PolygonCoverage coverage{};
  FirstFindings findings{};
  std::uint64_t wrong = 0;
};

/// Case g of the plan: streams take turns.
void run_case(const PolygonFuzzPlan& plan, std::uint64_t g, Worker& worker) {
  const std::size_t stream = g % plan.streams.size();
  const std::uint64_t k = g / plan.streams.size();
  const PolygonStream& source = plan.streams[stream];
  const PolygonTrial trial = source.family->make(source.format, plan.seed, k);
  const PolygonTruth truth = truth_of(trial);
  if (trial.known) ++worker.coverage[{trial.known->shape, trial.known->place, trial.known->approach}];
  for (std::size_t m = 0; m < plan.methods.size(); ++m) {
    const Method& method = plan.methods[m];
    if (!takes(method, source.format)) continue;
    const PolygonAnswer given = method.ask(trial.query);
    const Judgement judgement = judge(method, truth, given);
    worker.counts[{m, stream, trial.level, truth.contact, truth.planar}].add(judgement, given.answer.stage);
    if (judgement != Judgement::wrong) continue;
    ++worker.wrong;
    keep_first(worker.findings, {m, stream, k, trial, truth});
  }
}

std::vector<PolygonFinding> in_order(const FirstFindings& kept, std::size_t streams) {
  std::vector<PolygonFinding> findings;
  for (const auto& [key, finding] : kept) findings.push_back(finding);
  std::ranges::stable_sort(findings, {}, [&](const PolygonFinding& f) { return f.k * streams + f.stream; });
  return findings;
}

}  // namespace

std::vector<PolygonStream> all_polygon_streams() {
  std::vector<PolygonStream> streams;
  for (const PolygonFamily& family : all_polygon_families()) {
    for (const Format format : {Format::binary64, Format::binary32}) streams.push_back({&family, format});
  }
  return streams;
}

PolygonFuzzReport fuzz(const PolygonFuzzPlan& plan) {
  std::vector<Worker> workers(plan.threads);
  const std::uint64_t blocks = (plan.cases + block_size - 1) / block_size;
  Progress progress("fuzz", "cases", plan.seconds > 0 ? 0 : plan.cases);
  const auto work = [&](std::size_t block, unsigned w) {
    const std::uint64_t end = std::min(plan.cases, (block + 1) * block_size);
    const std::uint64_t wrong_before = workers[w].wrong;
    for (std::uint64_t g = block * block_size; g < end; ++g) run_case(plan, g, workers[w]);
    progress.add(end - block * block_size, workers[w].wrong - wrong_before);
  };
  const auto stop = [&] { return plan.seconds > 0 && progress.elapsed() > plan.seconds; };
  const std::size_t done = run_blocks(blocks, plan.threads, work, stop);

  PolygonFuzzReport report{.cases = std::min(plan.cases, done * block_size), .seconds = progress.elapsed()};
  FirstFindings kept;
  for (const Worker& w : workers) {
    for (const auto& [cell, count] : w.counts) report.counts[cell] += count;
    for (const auto& [known, n] : w.coverage) report.coverage[known] += n;
    for (const auto& [key, finding] : w.findings) keep_first(kept, finding);
  }
  report.findings = in_order(kept, plan.streams.size());
  return report;
}

std::string describe(const PolygonCoverage& coverage) {
  std::set<std::size_t> shapes;
  std::set<std::pair<PolygonPlace, Approach>> places;
  std::set<std::pair<std::size_t, PolygonPlace>> pairs;
  for (const auto& [known, n] : coverage) {
    const auto& [shape, place, approach] = known;
    shapes.insert(shape);
    places.insert({place, approach});
    pairs.insert({shape, place});
  }
  std::size_t possible = 0;
  for (const Shape& shape : all_shapes()) {
    for (const auto& points : places_of(shape)) possible += !points.empty();
  }
  const auto of = [](std::size_t n, std::size_t all) { return std::to_string(n) + " of " + std::to_string(all); };
  return "ring configurations " + of(shapes.size(), shape_count) + ", places × approaches " +
         of(places.size(), place_count * approach_count) + ", configurations × places " + of(pairs.size(), possible);
}

}  // namespace tribunal
