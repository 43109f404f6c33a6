// Runs a trial and logs it; the certificate is made from the log.
#pragma once

#include <string>
#include <vector>

#include "exact/harness/fuzz.h"
#include "exact/io/case_io.h"
#include "exact/log/chain.h"

namespace tribunal {

/// What is run. `cases_per_class`: sampled cases of each class in each stream that proves classes, and 163 times as
/// many a stream in the others.
struct Budget {
  std::string name;
  std::uint64_t cases_per_class;
  bool full_scope;  ///< {0..3}³ and the five-point lines too, not only {0,1,2}³

  friend bool operator==(const Budget&, const Budget&) = default;
};

/// quick: with no failure in 280 the pointwise bound is 1.1 %. standard: all sets, 0.3 %. soak: with all streams that
/// prove classes (16 today), 8.1·10⁶ cases a class, for which the simultaneous 95 % bound is 10⁻⁶; hours to days.
inline const std::vector<Budget> budgets{{"quick", 280, false}, {"standard", 1000, true}, {"soak", 506'000, true}};

struct CertifyPlan {
  Method method;
  Budget budget = budgets[0];
  std::uint64_t seed = 1;
  unsigned threads = 1;
  std::vector<Stream> streams = all_streams();
  std::vector<Case> cases{};    ///< the user's own cases, judged and reported with the rest
  std::vector<Truth> truths{};  ///< their exact answers
};

/// The exact answers to the user's cases. Fails with Exit::bad_input where a case of this file claims something false.
std::vector<Truth> truths_of(const std::vector<Case>& cases, const std::string& file);

/// The whole trial. Deterministic for a plan, whatever the number of threads. Fails if interrupted.
ChainedLog certify(const CertifyPlan& plan);

/// The user's own cases, whose exact answers are known, as a stream, with each that was answered wrongly as a
/// counterexample. `answer` says what the method answered to case i; operands that it does not take are not asked.
void log_own_cases(ChainedLog& log, const Method& method, const std::vector<Case>& cases,
                   const std::vector<Truth>& truths, const std::function<Answer(std::size_t)>& answer);

/// The records "plan" and "environment", with which every certificate's log begins.
void log_plan(ChainedLog& log, const Method& method, const std::string& budget, std::uint64_t seed);

}  // namespace tribunal
