// Runs a trial and logs it; the certificate is made from the log.
#pragma once

#include <string>
#include <vector>

#include "exact/base/lines.h"
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
  /// The user's own cases, judged and reported beside the rest, if there are any. They are never held.
  const Rereadable* own = nullptr;
};

/// Fails with Exit::bad_input if the file holds no cases, or where one has other operands or claims something false.
void require_sound(const Rereadable& cases, Operands operands, unsigned threads);

/// The whole trial. Deterministic for a plan, whatever the number of threads. Fails if interrupted.
ChainedLog certify(const CertifyPlan& plan);

/// The naive methods that run beside the method on trial: all except the method itself.
std::vector<Method> calibration_beside(const std::string& method);

/// Logs the records "plan" and "environment", with which every certificate's log begins. `command`: the words that
/// judge the same again, where method, budget and seed do not say how to.
void log_plan(ChainedLog& log, const Method& method, Operands operands, const std::string& budget, std::uint64_t seed,
              const std::vector<std::string>& command = {});

}  // namespace tribunal
