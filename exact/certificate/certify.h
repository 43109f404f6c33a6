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
  std::vector<Stream> streams = {};  ///< if empty, all streams
  std::vector<Case> cases = {};      ///< the user's own cases, judged and reported beside the rest
  std::vector<Truth> truths = {};    ///< the exact answers to `cases`, of no meaning where these are not finite
};

/// The exact answers to the user's cases, of no meaning where these are not finite. Fails with Exit::bad_input where a
/// case of this file claims something false.
std::vector<Truth> truths_of(const std::vector<Case>& cases, const std::string& file);

/// The whole trial. Deterministic for a plan, whatever the number of threads. Fails if interrupted.
ChainedLog certify(const CertifyPlan& plan);

/// The naive methods that run beside the method on trial: all except the method itself.
std::vector<Method> calibration_beside(const std::string& method);

/// Logs the records "plan" and "environment", with which every certificate's log begins.
void log_plan(ChainedLog& log, const Method& method, Operands operands, const std::string& budget, std::uint64_t seed);

}  // namespace tribunal
