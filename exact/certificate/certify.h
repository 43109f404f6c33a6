// Runs a trial and logs it; the certificate is made from the log.
#pragma once

#include <string>
#include <vector>

#include "exact/certificate/small_scope.h"
#include "exact/log/chain.h"
#include "exact/polygon/fuzz.h"

namespace tribunal {

/// What is run. `cases_per_class`: sampled cases of each class in each stream that proves classes, and 328 times as
/// many a stream in the others. `rounds`: of polygons, how often each stream goes through all pairs of a ring
/// configuration and a place (572 cases).
struct Budget {
  std::string name;
  std::uint64_t cases_per_class;
  bool full_scope;  ///< {0..3}³ and the five-point lines too, not only {0,1,2}³; all of the small scope of polygons
  std::uint64_t rounds = 6;

  friend bool operator==(const Budget&, const Budget&) = default;
};

/// quick: with no failure in 280 the pointwise bound is 1.1 %. standard: all sets, 0.3 %. soak: with all streams that
/// prove classes (16 today), 8.1·10⁶ cases a class, for which the simultaneous 95 % bound is 10⁻⁶; hours to days.
inline const std::vector<Budget> budgets{
    {"quick", 280, false, 18}, {"standard", 1000, true, 108}, {"soak", 506'000, true, 10'800}};

template <class On>
struct BasicCertifyPlan {
  Method method;
  Budget budget = budgets[0];
  std::uint64_t seed = 1;
  unsigned threads = 1;
  std::vector<BasicStream<On>> streams = {};    ///< none: all of them
  std::vector<typename On::Case> cases = {};    ///< the user's own cases, judged and reported beside the rest
  std::vector<typename On::Truth> truths = {};  ///< their exact answers
};

using CertifyPlan = BasicCertifyPlan<OnTriangles>;
using PolygonCertifyPlan = BasicCertifyPlan<OnPolygons>;

/// The exact answers to the user's cases. Fails with Exit::bad_input where a case of this file claims something false.
std::vector<Truth> truths_of(const std::vector<Case>& cases, const std::string& file);
std::vector<PolygonTruth> truths_of(const std::vector<PolygonCase>& cases, const std::string& file);

/// The whole trial. Deterministic for a plan, whatever the number of threads. Fails if interrupted.
template <class On>
ChainedLog certify(const BasicCertifyPlan<On>& plan);

/// The user's own cases, whose exact answers are known, as a stream, with each that was answered wrongly as a
/// counterexample. `answer` says what the method answered to case i; operands that it does not take are not asked.
template <class On>
void log_own_cases(ChainedLog& log, const Method& method, const std::vector<typename On::Case>& cases,
                   const std::vector<typename On::Truth>& truths,
                   const std::function<typename On::Answer(std::size_t)>& answer);

/// The record "budget": what the budget asks for, in numbers.
Json budget_record(const Budget& budget);
Budget to_budget(const Json& record, const Where& where);

/// What a whole trial with this budget and seed must have in its log, apart from answers: the sets that are run whole,
/// in order, and the record "stream" of each sampled stream, in order, without "taken", which depends on the method.
struct Owed {
  std::vector<SetDescription> sets;
  std::vector<Json> streams;
};

Owed owed_by(const Budget& budget, std::uint64_t seed, Operands operands);

/// The naive methods that run beside the method on trial: all but itself.
std::vector<Method> calibration_beside(const std::string& method);

/// The records "plan" and "environment", with which every certificate's log begins.
void log_plan(ChainedLog& log, const Method& method, Operands operands, const std::string& budget, std::uint64_t seed);

}  // namespace tribunal
