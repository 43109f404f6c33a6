// The differential harness: generated cases, asked of every method, judged by the exact answer. Written once for
// triangles and for polygons (exact/polygon/fuzz.h).
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <type_traits>
#include <vector>

#include "exact/families/family.h"
#include "exact/harness/fault.h"
#include "exact/harness/slot.h"
#include "exact/io/case_io.h"

namespace tribunal {

/// What the harness needs to know of cases with triangles.
struct OnTriangles {
  using Family = tribunal::Family;
  using Trial = tribunal::Trial;
  using Truth = tribunal::Truth;
  using Answer = tribunal::Answer;
  using Query = tribunal::Query;
  using Case = tribunal::Case;
  static constexpr Operands operands = Operands::triangles;
  static constexpr std::uint64_t block_size = 2048;

  static Truth truth_of(const Trial& trial, std::uint64_t k) { return tribunal::truth_of(trial, k); }
  /// Under which a case is counted.
  static Slot slot_of(const Trial&, const Truth& truth) { return tribunal::slot_of(truth); }
  static bool aims(const Family& family) { return family.proves_class; }
  static const char* oracle_of(const Family& family) { return tribunal::oracle_of(family); }
};

/// What every answer has.
inline const Answer& plain(const Answer& answer) { return answer; }
inline const Answer& plain(const PolygonAnswer& answer) { return answer.answer; }

/// One endless sequence of cases: a family in a format.
template <class On>
struct BasicStream {
  const typename On::Family* family;
  Format format;
};

template <class On>
struct BasicFuzzPlan {
  std::vector<Method> methods;
  std::vector<BasicStream<On>> streams;
  std::uint64_t seed = 1;
  std::uint64_t cases = 0;  ///< in all, dealt to the streams in turn
  double seconds = 0;       ///< if > 0, stop after that time instead; `cases` is then a ceiling
  unsigned threads = 1;
};

/// Where a count belongs. Indices into the plan.
struct Cell {
  std::size_t method, stream, level;
  Slot slot;
};

/// Counts by method × stream × level × slot. Only the rows in which something was counted take room.
class CountTable {
 public:
  CountTable(std::size_t methods, std::size_t streams, std::size_t levels, SlotRange slots);
  Count& at(const Cell& cell);
  CountTable& operator+=(const CountTable& other);

  /// All cells in which something was asked, in index order, with their counts.
  void for_each(const std::function<void(const Cell&, const Count&)>& visit) const;

  friend bool operator==(const CountTable& a, const CountTable& b) { return a.rows_ == b.rows_; }

 private:
  std::size_t streams_, levels_;
  SlotRange slots_;
  std::vector<std::vector<Count>> rows_;
};

/// A wrong answer, with all that is needed to make the case again.
template <class On>
struct BasicFinding {
  std::size_t method, stream;
  std::uint64_t k;  ///< case number within the stream
  typename On::Trial trial;
  typename On::Truth truth;
  typename On::Answer answer;
  Fault fault{};  ///< what showed when it was asked again (`ask_again`)
};

template <class On>
struct BasicFuzzReport {
  std::uint64_t cases = 0;     ///< from the plan's first
  std::uint64_t run_here = 0;  ///< of these, in this run
  double seconds = 0;          ///< of this run
  CountTable counts;
  std::vector<BasicFinding<On>> findings;  ///< the first of each method × stream × class or outcome × fault, by case
                                           ///< number
};

/// Before the first case.
template <class On>
BasicFuzzReport<On> empty_report(const BasicFuzzPlan<On>& plan);

/// Called with the report so far: every minute, and when a signal has ended the run.
template <class On>
using Checkpoint = std::function<void(const BasicFuzzReport<On>&)>;

/// Deterministic: the same plan gives the same report (but for `seconds`) whatever the number of threads, and whether
/// it ran at once or went on from a report of an earlier part of it. With a time limit the number of cases varies, but
/// not what is said of them. A method with a batch form is asked by it.
template <class On>
BasicFuzzReport<On> fuzz(const BasicFuzzPlan<On>& plan, BasicFuzzReport<On> so_far,
                         const std::type_identity_t<Checkpoint<On>>& checkpoint);

template <class On>
BasicFuzzReport<On> fuzz(const BasicFuzzPlan<On>& plan) {
  return fuzz(plan, empty_report(plan), {});
}

/// Whether all cases of the plan were run, or all its seconds.
template <class On>
bool is_complete(const BasicFuzzPlan<On>& plan, const BasicFuzzReport<On>& report) {
  return report.cases == plan.cases || (plan.seconds > 0 && report.seconds > plan.seconds);
}

/// "affine binary64".
template <class On>
std::string name_of(const BasicStream<On>& s) {
  return std::string(s.family->name) + " " + std::string(name_of(s.format));
}

using Stream = BasicStream<OnTriangles>;
using FuzzPlan = BasicFuzzPlan<OnTriangles>;
using Finding = BasicFinding<OnTriangles>;
using FuzzReport = BasicFuzzReport<OnTriangles>;

/// All families in both formats.
std::vector<Stream> all_streams();

}  // namespace tribunal
