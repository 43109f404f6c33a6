// Runs a trial and logs it; the certificate is made from the log.
#pragma once

#include <string>
#include <vector>

#include "exact/cases/case_io.h"
#include "exact/certificate/budget.h"
#include "exact/record/chain.h"
#include "exact/trial/fuzz.h"

namespace tribunal {

struct CertifyPlan {
  Method method;
  Operands operands = Operands::triangles;
  Budget budget = budgets[0];
  std::uint64_t seed = 1;
  unsigned threads = 1;
  std::vector<Stream> streams = {};  ///< none: all of them
  std::vector<Case> cases = {};      ///< the user's own cases, judged and reported beside the rest
  std::vector<Truth> truths = {};    ///< their exact answers
};

/// The exact answers to the user's cases. Fails with Exit::bad_input where a case of this file claims something false.
std::vector<Truth> truths_of(const std::vector<Case>& cases, const std::string& file);

/// The whole trial. Deterministic for a plan, whatever the number of threads. Fails if interrupted.
ChainedLog certify(const CertifyPlan& plan);

/// The user's own cases, whose exact answers are known, as a stream for each of operands and formats, with each that
/// was answered wrongly as a counterexample. `answer` says what the method answered to case i; operands that it does
/// not take are not asked.
void log_own_cases(ChainedLog& log, const Method& method, const std::vector<Case>& cases,
                   const std::vector<Truth>& truths, const std::function<Answer(std::size_t)>& answer);

/// The naive methods that run beside the method on trial: all but itself.
std::vector<Method> calibration_beside(const std::string& method);

/// The records "plan" and "environment", with which every certificate's log begins.
void log_plan(ChainedLog& log, const Method& method, Operands operands, const std::string& budget, std::uint64_t seed);

}  // namespace tribunal
