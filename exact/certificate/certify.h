// The certificate: what is proved, what is sampled and what is not covered, kept apart.
#pragma once

#include <string>
#include <vector>

#include "exact/certificate/small_scope.h"
#include "exact/harness/fuzz.h"
#include "exact/io/case_io.h"

namespace tribunal {

/// Level of every confidence bound: 95 %.
inline constexpr double confidence_alpha = 0.05;

/// What is run. `cases_per_class`: sampled cases of each class in each stream that proves classes, and 163 times as
/// many a stream in the others.
struct Budget {
  std::string name;
  std::uint64_t cases_per_class;
};

/// With no failure in 280 the pointwise bound is 1.1 %.
inline const Budget quick_budget{"quick", 280};

struct CertifyPlan {
  Method method;
  Budget budget = quick_budget;
  std::uint64_t seed = 1;
  unsigned threads = 1;
  std::vector<Case> cases{};  ///< the user's own cases, judged and reported with the rest
};

/// One sampled stratum: class × stream. The bounds are about cases of this generator under this seed.
struct SampledStratum {
  std::size_t stream;
  ClassId class_id;
  Count count;
};

/// Something that the certificate does not speak of. `explained`: the reason lies in the contract or the family.
struct Gap {
  std::string what, reason;
  bool explained;
};

enum class Verdict { not_refuted, refuted, incomplete };

struct Certificate {
  FuzzPlan sample_plan;  ///< method under trial first, then the naive ones that calibrate
  std::vector<ScopeResult> proved;
  FuzzReport sampled;
  std::vector<SampledStratum> strata{};
  Count own_cases{};  ///< of the user's file
  std::vector<Gap> gaps{};
  std::vector<Case> counterexamples{};
  Verdict verdict = Verdict::incomplete;
};

/// Cases of all strata of one method of the sample.
Count total_of(const FuzzReport& report, std::size_t method);

/// Runs the whole trial. Deterministic for a plan, whatever the number of threads.
Certificate certify(const CertifyPlan& plan);

Json to_json(const CertifyPlan& plan, const Certificate& c);

/// The same for people.
std::string to_markdown(const CertifyPlan& plan, const Certificate& c);

/// What the terminal shows.
std::string to_summary(const CertifyPlan& plan, const Certificate& c);

}  // namespace tribunal
