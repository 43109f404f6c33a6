// The differential harness: generated cases, asked of every method, judged by the exact answer.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "core/method.h"
#include "exact/base/fault.h"
#include "exact/cases/families/family.h"
#include "exact/trial/count_table.h"
#include "exact/trial/formulations.h"
#include "exact/trial/quick_truth.h"
#include "exact/trial/ulps.h"

namespace tribunal {

/// One endless sequence of cases: a family in a format.
struct Stream {
  const Family* family;
  Format format;
};

/// One answer after it was judged, as FuzzPlan::watch is told of it.
struct JudgedAnswer {
  std::size_t method, stream;
  std::uint64_t k;  ///< case number within the stream
  const Trial& trial;
  const Truth& truth;
  Answer answer;
  Outcome outcome;

  // Of wrong answers.
  Severity severity = Severity::extreme;
  Cause cause = Cause::unknown;
};

struct FuzzPlan {
  std::vector<Method> methods;
  std::vector<Stream> streams;  ///< at least one; all with the same operands
  std::uint64_t seed = 1;
  std::uint64_t cases = 0;  ///< in all, dealt to the streams in turn
  double seconds = 0;       ///< if > 0, stop after that time instead; `cases` is then a ceiling
  unsigned threads = 1;
  bool until_first = false;    ///< stop soon after the first finding, and keep that one alone
  ClassBy quick = nullptr;     ///< of triangles: judges all cases; if none, `formulations` do
  std::string label = "fuzz";  ///< of the line of progress
  std::function<void(unsigned worker, const JudgedAnswer&)> watch{};  ///< told of every answer, in no order
  TruthBy formulations = truth_by_formulations;                       ///< of triangles

  Operands operands() const { return streams.front().family->operands; }

  /// Where the errors of a method on a stream stand.
  std::size_t errors_at(std::size_t method, std::size_t stream) const { return method * streams.size() + stream; }
};

/// A wrong answer, with all that is needed to make the case again.
struct Finding {
  std::size_t method, stream;
  std::uint64_t k;  ///< case number within the stream
  Trial trial;
  Truth truth;
  Answer answer;
  Outcome outcome;
  Severity severity;

  // What `ask_again` finds out.
  Fault fault{};
  Cause cause = Cause::unknown;
  bool naive_right = false;  ///< the naive methods answer it rightly

  Rank rank() const { return {severity, outcome == Outcome::wrong_contact, !naive_right, cause}; }
};

struct FuzzReport {
  std::uint64_t cases = 0;     ///< from the plan's first
  std::uint64_t run_here = 0;  ///< of these, in this run
  std::uint64_t audited = 0;   ///< of all, of triangles, judged by all oracles too, which agreed
  double seconds = 0;          ///< of this run
  CountTable counts;
  std::vector<HitErrors> errors;  ///< of numbers given with right hits, by method × stream; of one case in
                                  ///< `measured_period`
  std::vector<Finding> findings;  ///< the first of each method × stream × slot × fault × outcome × severity, by case
                                  ///< number
};

/// The number of the finding's case among all of the plan.
std::uint64_t case_number(const FuzzPlan& plan, const Finding& finding);

/// Before the first case.
FuzzReport empty_report(const FuzzPlan& plan);

/// Called with the report so far: every minute, and when a signal has ended the run.
using Checkpoint = std::function<void(const FuzzReport&)>;

/// Deterministic: the same plan gives the same report (but for `seconds`) whatever the number of threads, and whether
/// it ran at once or went on from a report of an earlier part of it. With a time limit the number of cases varies, but
/// not what is said of them. A method with a batch form is asked by it. A run until the first finding ends at one of
/// a few case numbers that are the same for all plans, so it is as deterministic: its finding is the one with the
/// lowest case number of all.
FuzzReport fuzz(const FuzzPlan& plan, FuzzReport so_far, const Checkpoint& checkpoint);
FuzzReport fuzz(const FuzzPlan& plan);

/// What may judge the answers of these methods quickly: nothing if one of them promises to be exact, so that no
/// certified arithmetic is judged by its like; and nothing where the operands are polygons.
ClassBy quick_class_for(const std::vector<Method>& methods, Operands operands);

/// Cases that a thread runs at a time: polygons have slower oracles.
std::uint64_t block_size_of(Operands operands);

/// Whether all cases of the plan were run, or all its seconds, or it stops at the first finding and has one.
bool is_complete(const FuzzPlan& plan, const FuzzReport& report);

/// "affine binary64".
std::string name_of(const Stream& s);

/// All families of these operands, in both formats.
std::vector<Stream> streams_of(Operands operands);

}  // namespace tribunal
