#include "exact/certificate/certify.h"

#include <algorithm>

#include "exact/classes/class_table.h"
#include "exact/harness/counterexample.h"
#include "exact/harness/interrupt.h"
#include "exact/harness/shrink.h"
#include "exact/io/failure.h"
#include "exact/methods.h"

namespace tribunal {
namespace {

constexpr std::size_t most_counterexamples = 25;

FuzzPlan sample_plan(const CertifyPlan& plan) {
  FuzzPlan sample;
  sample.methods = {plan.method, *find_method("sf-float"), *find_method("sf-double")};
  sample.streams = all_streams();
  sample.seed = plan.seed;
  sample.threads = plan.threads;
  sample.cases = sample.streams.size() * class_count * plan.budget.cases_per_class;
  return sample;
}

std::vector<SampledStratum> strata_of(const FuzzPlan& plan, const FuzzReport& report) {
  std::vector<SampledStratum> strata(plan.streams.size() * class_count);
  report.counts.for_each([&](const Cell& cell, const Count& count) {
    if (cell.method != 0) return;
    SampledStratum& stratum = strata[cell.stream * class_count + cell.class_id - 1U];
    stratum.stream = cell.stream;
    stratum.class_id = cell.class_id;
    stratum.count += count;
  });
  return strata;
}

/// Every class × stream that nothing was judged in, with the reason.
std::vector<Gap> gaps_of(const FuzzPlan& plan, const std::vector<SampledStratum>& strata) {
  const Method& method = plan.methods[0];
  std::vector<Gap> gaps;
  for (std::size_t i = 0; i < plan.streams.size(); ++i) {
    if (takes(method, plan.streams[i].format)) continue;
    gaps.push_back({name_of(plan.streams[i]), "the method computes in binary32; these operands do not fit", true});
  }
  for (const SampledStratum& s : strata) {
    const Stream& stream = plan.streams[s.stream];
    if (!takes(method, stream.format) || s.count.judged() > 0) continue;
    const std::string what = name_of(stream) + " " + class_name(s.class_id);
    if (s.count.asked > 0) {
      gaps.push_back({what, "outside the method's contract: " + method.contract, true});
    } else if (!stream.family->proves_class) {
      gaps.push_back({what, "the family drew no case of this class: it does not aim at classes", true});
    } else {
      gaps.push_back({what, "no case was drawn", false});
    }
  }
  return gaps;
}

/// A sample that cannot make the naive methods fail says nothing about any other.
void require_calibration(Certificate& c) {
  for (std::size_t m = 1; m < c.sample_plan.methods.size(); ++m) {
    if (total_of(c.sampled, m).wrong > 0) continue;
    c.gaps.push_back({"calibration", c.sample_plan.methods[m].name + " was never wrong on this sample", false});
  }
}

Case scope_counterexample(const Method& method, const ScopeResult& scope, const Query& query, std::size_t i) {
  Case c;
  c.format = Format::binary32;
  c.query = shrink(method, query, c.format);
  const Truth truth = exact_truth(c.query);
  c.id = method.name + "-" + class_name(truth.class_id) + "-scope-" + std::to_string(i);
  c.expect = truth.hit();
  c.class_id = truth.class_id;
  c.source = scope.name;
  c.finding = finding_of(method, c.query, truth);
  return c;
}

void add_counterexamples(Certificate& c) {
  const Method& method = c.sample_plan.methods[0];
  for (const ScopeResult& scope : c.proved) {
    for (std::size_t i = 0; i < scope.wrong.size(); ++i) {
      c.counterexamples.push_back(scope_counterexample(method, scope, scope.wrong[i], i));
    }
  }
  for (const Finding& f : c.sampled.findings) {
    if (f.method == 0 && c.counterexamples.size() < most_counterexamples) {
      c.counterexamples.push_back(to_counterexample(c.sample_plan, f));
    }
  }
}

/// Before the run: a mistake in the user's file should not cost minutes.
void require_true_claims(const CertifyPlan& plan) {
  for (const Case& own : plan.cases) {
    const std::string error = mistaken_claim(own, exact_truth(own.query));
    if (!error.empty()) throw Failure(Exit::bad_input, own.id + ": " + error);
  }
}

void judge_own_cases(const CertifyPlan& plan, Certificate& c) {
  for (const Case& own : plan.cases) {
    if (!takes(plan.method, own.format)) continue;
    const Truth truth = exact_truth(own.query);
    const Judgement j = judge(plan.method, truth, plan.method.ask(own.query));
    c.own_cases.add(j);
    if (j != Judgement::wrong) continue;
    Case witness = own;
    witness.expect = truth.hit();
    witness.finding = finding_of(plan.method, own.query, truth);
    c.counterexamples.push_back(witness);
  }
}

Verdict verdict_of(const Certificate& c) {
  const bool wrong_in_scope = std::ranges::any_of(c.proved, [](const ScopeResult& s) { return s.count.wrong > 0; });
  if (wrong_in_scope || total_of(c.sampled, 0).wrong > 0 || c.own_cases.wrong > 0) return Verdict::refuted;
  const bool scope_broken = std::ranges::any_of(c.proved, [](const ScopeResult& s) { return !s.complete; });
  const bool unexplained = std::ranges::any_of(c.gaps, [](const Gap& g) { return !g.explained; });
  return scope_broken || unexplained ? Verdict::incomplete : Verdict::not_refuted;
}

void end_if_interrupted() {
  if (interrupted() != 0) throw Failure(static_cast<Exit>(128 + interrupted()), "interrupted; no certificate written");
}

}  // namespace

Count total_of(const FuzzReport& report, std::size_t method) {
  Count total;
  report.counts.for_each([&](const Cell& cell, const Count& count) {
    if (cell.method == method) total += count;
  });
  return total;
}

Certificate certify(const CertifyPlan& plan) {
  Certificate c{.sample_plan = sample_plan(plan), .proved = {}, .sampled = {0, 0, CountTable({}), {}}};
  require_true_claims(plan);
  c.proved.push_back(pocket_run(plan.method));
  c.proved.push_back(lattice_run(plan.method, 3, plan.threads));
  end_if_interrupted();
  c.sampled = fuzz(c.sample_plan);
  end_if_interrupted();
  c.strata = strata_of(c.sample_plan, c.sampled);
  c.gaps = gaps_of(c.sample_plan, c.strata);
  require_calibration(c);
  add_counterexamples(c);
  judge_own_cases(plan, c);
  c.verdict = verdict_of(c);
  return c;
}

}  // namespace tribunal
