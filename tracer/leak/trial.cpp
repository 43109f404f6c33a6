#include "tracer/leak/trial.h"

#include <algorithm>
#include <mutex>
#include <numeric>

#include "exact/base/interrupt.h"
#include "exact/base/parallel.h"
#include "exact/base/progress.h"

namespace tribunal::leak {
namespace {

constexpr std::uint64_t block_size = 512;

/// Rays first, first + 1, … with all that is known of them; those that start on the surface are left out.
struct Block {
  std::vector<std::uint64_t> k{};
  std::vector<AimedRay> aimed{};
  std::vector<AskedRay> asked{};
  std::vector<RayTruth> truths{};
  std::uint64_t skipped = 0;

  std::size_t size() const { return k.size(); }
};

Block block_of(const Surface& surface, const LeakPlan& plan, std::uint64_t first) {
  Block block;
  std::vector<std::uint32_t> every(plan.every_face ? surface.face_count() : 0), met;
  std::iota(every.begin(), every.end(), 0u);
  for (std::uint64_t k = first; k < std::min(first + block_size, plan.count()); ++k) {
    const std::optional<AimedRay> aimed = plan.given.empty() ? aimed_ray(surface, plan.seed, k) : plan.given[k];
    if (aimed) surface.boxes().candidates(BoxProbe(aimed->ray), met);
    RayTruth truth = aimed ? truth_of(surface, *aimed, met) : RayTruth{.on_surface = true};
    if (truth.on_surface) {
      ++block.skipped;
      continue;
    }
    block.k.push_back(k);
    block.aimed.push_back(*aimed);
    block.asked.push_back({k, aimed->ray, plan.every_face ? every : met});
    block.truths.push_back(std::move(truth));
  }
  return block;
}

void keep_lowest(std::vector<LeakFinding>& findings, std::size_t keep) {
  std::ranges::sort(findings, {}, &LeakFinding::k);
  if (findings.size() > keep) findings.erase(findings.begin() + static_cast<std::ptrdiff_t>(keep), findings.end());
}

/// What one block adds to a subject's report: `spots` are faces, and whether they leaked.
struct Part {
  LeakTally tally{};
  std::vector<LeakFinding> findings{};
  std::vector<std::pair<std::uint32_t, bool>> spots{};
  double worst_ulps = 0, worst_degrees = 0;
  std::map<std::string, std::uint64_t> faults{};

  void add(std::uint64_t k, const AimedRay& aimed, const Verdict& v) {
    AimTally& t = tally[aimed.aim];
    ++t.rays;
    t.parity_judged += v.parity_judged;
    worst_ulps = std::max(worst_ulps, v.ulps);
    worst_degrees = std::max(worst_degrees, v.degrees);
    if (!v.fault.empty()) ++faults[v.fault];
    for (const Outcome o : all_outcomes) {
      t.with[static_cast<std::size_t>(o)] += v.outcomes.has(o);
      if (!v.outcomes.has(o) || !is_error(o)) continue;
      findings.push_back({k, aimed, o, *v.shown_by(o), v.fault});
      if (o != Outcome::lost) spots.emplace_back(*v.shown_by(o), o == Outcome::leak);
    }
  }
};

void add(SubjectReport& report, const Part& part, std::size_t keep) {
  report.tally += part.tally;
  report.worst_ulps = std::max(report.worst_ulps, part.worst_ulps);
  report.worst_degrees = std::max(report.worst_degrees, part.worst_degrees);
  for (const auto& [fault, count] : part.faults) report.faults[fault] += count;
  for (const auto& [face, leaked] : part.spots) ++(leaked ? report.leaks_at : report.errors_at)[face];
  for (const LeakFinding& f : part.findings) {
    std::vector<LeakFinding>& kept = report.findings[f.outcome];
    kept.push_back(f);
    keep_lowest(kept, keep);
  }
}

Part part_of(const Surface& surface, const Subject& subject, const Block& block) {
  std::vector<Testimony> said(block.size());
  subject.ask(block.asked, said);
  Part part;
  for (std::size_t i = 0; i < block.size(); ++i) {
    part.add(block.k[i], block.aimed[i], judge(surface, subject, block.aimed[i], block.truths[i], said[i]));
  }
  return part;
}

bool meets_boundary(const RayTruth& truth) {
  return std::ranges::any_of(truth.crossed, [](const Crossed& c) { return c.contact != Contact::interior; });
}

void count(LeakReport& report, const Block& block) {
  report.rays += block.size();
  report.skipped += block.skipped;
  for (const RayTruth& truth : block.truths) {
    report.inside += truth.inside;
    report.exactly += meets_boundary(truth);
  }
}

LeakReport empty_report(const Surface& surface, std::size_t subjects) {
  LeakReport report{.subjects = std::vector<SubjectReport>(subjects)};
  for (SubjectReport& s : report.subjects) {
    s.leaks_at.resize(surface.face_count());
    s.errors_at.resize(surface.face_count());
  }
  return report;
}

}  // namespace

LeakReport run_leak_trial(const Surface& surface, const std::vector<Subject>& subjects, const LeakPlan& plan) {
  LeakReport report = empty_report(surface, subjects.size());
  std::mutex guard;
  Progress progress("leak " + std::string(name_of(surface.format())), "rays", plan.count());
  const std::size_t blocks = (plan.count() + block_size - 1) / block_size;
  const std::size_t done = run_blocks(blocks, plan.threads, [&](std::size_t b, unsigned) {
    const Block block = block_of(surface, plan, b * block_size);
    std::vector<Part> parts;
    for (const Subject& s : subjects) parts.push_back(part_of(surface, s, block));
    progress.add(block.size() + block.skipped);
    const std::scoped_lock lock(guard);
    count(report, block);
    for (std::size_t i = 0; i < parts.size(); ++i) add(report.subjects[i], parts[i], plan.keep);
  });
  report.complete = done == blocks;
  report.signal = report.complete ? 0 : interrupted();
  return report;
}

}  // namespace tribunal::leak
