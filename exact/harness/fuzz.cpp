#include "exact/harness/fuzz.h"

#include <algorithm>

#include "exact/classes/class_table.h"
#include "exact/harness/fp_environment.h"
#include "exact/harness/parallel.h"
#include "exact/harness/progress.h"
#include "exact/io/failure.h"

namespace tribunal {
namespace {

constexpr std::uint64_t block_size = 2048;

std::size_t most_levels(const FuzzPlan& plan) {
  std::size_t most = 1;
  for (const Stream& s : plan.streams) most = std::max(most, s.family->levels(s.format).size());
  return most;
}

/// The first finding of each method × stream × class, by case number.
using FindingKey = std::tuple<std::size_t, std::size_t, ClassId>;
using FirstFindings = std::map<FindingKey, Finding>;

void keep_first(FirstFindings& kept, const Finding& f) {
  const auto [entry, fresh] = kept.try_emplace({f.method, f.stream, f.truth.class_id}, f);
  if (!fresh && f.k < entry->second.k) entry->second = f;
}

struct Worker {
  CountTable counts;
  FirstFindings findings;
  std::uint64_t wrong = 0;
};

/// A method that leaves its thread in another environment would spoil every answer after its own, oracles included.
void require_intact_rounding(const Method& method) {
  if (rounding_is_intact()) return;
  require_exact_rounding();
  throw Failure(Exit::fp_environment,
                method.name + " changed the floating-point environment of its thread (rounding, or flush to zero)");
}

/// Case g of the plan: streams take turns.
void run_case(const FuzzPlan& plan, std::uint64_t g, Worker& worker) {
  const std::size_t stream = g % plan.streams.size();
  const std::uint64_t k = g / plan.streams.size();
  const Stream& source = plan.streams[stream];
  const Trial trial = source.family->make(source.format, plan.seed, k);
  const Truth truth = truth_of(trial);
  for (std::size_t m = 0; m < plan.methods.size(); ++m) {
    const Method& method = plan.methods[m];
    if (!takes(method, source.format)) continue;
    const Answer answer = method.ask(trial.query);
    require_intact_rounding(method);
    const Judgement judgement = judge(method, truth, answer);
    worker.counts.at({m, stream, trial.level, truth.class_id}).add(judgement);
    if (judgement != Judgement::wrong) continue;
    ++worker.wrong;
    keep_first(worker.findings, {m, stream, k, trial, truth, answer});
  }
}

std::vector<Finding> in_order(const FirstFindings& kept, std::size_t streams) {
  std::vector<Finding> findings;
  for (const auto& [key, finding] : kept) findings.push_back(finding);
  std::ranges::stable_sort(findings, {}, [&](const Finding& f) { return f.k * streams + f.stream; });
  return findings;
}

}  // namespace

CountTable::CountTable(const FuzzPlan& plan)
    : methods_(plan.methods.size()),
      streams_(plan.streams.size()),
      levels_(most_levels(plan)),
      counts_(methods_ * streams_ * levels_ * class_count) {}

std::size_t CountTable::index(const Cell& c) const {
  return ((c.method * streams_ + c.stream) * levels_ + c.level) * class_count + c.class_id - 1U;
}

CountTable& CountTable::operator+=(const CountTable& other) {
  for (std::size_t i = 0; i < counts_.size(); ++i) counts_[i] += other.counts_[i];
  return *this;
}

void CountTable::for_each(const std::function<void(const Cell&, const Count&)>& visit) const {
  for (std::size_t i = 0; i < counts_.size(); ++i) {
    const std::size_t row = i / class_count;
    visit(
        {row / levels_ / streams_, row / levels_ % streams_, row % levels_, static_cast<ClassId>(i % class_count + 1)},
        counts_[i]);
  }
}

FuzzReport fuzz(const FuzzPlan& plan) {
  std::vector<Worker> workers(plan.threads, Worker{CountTable(plan), {}, 0});
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

  FuzzReport report{std::min(plan.cases, done * block_size), progress.elapsed(), CountTable(plan), {}};
  FirstFindings kept;
  for (const Worker& w : workers) {
    report.counts += w.counts;
    for (const auto& [key, finding] : w.findings) keep_first(kept, finding);
  }
  report.findings = in_order(kept, plan.streams.size());
  return report;
}

std::string name_of(const Stream& s) { return std::string(s.family->name) + " " + std::string(name_of(s.format)); }

std::vector<Stream> all_streams() {
  std::vector<Stream> streams;
  for (const Family& family : all_families()) {
    for (const Format format : {Format::binary64, Format::binary32}) streams.push_back({&family, format});
  }
  return streams;
}

}  // namespace tribunal
