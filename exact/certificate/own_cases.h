// One's own cases on trial: counted as they come, in any number, in bounded memory.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "exact/cases/case_io.h"
#include "exact/certificate/certificate.h"
#include "exact/record/chain.h"
#include "exact/record/sample_row.h"

namespace tribunal {

/// A case with its exact answer, of no meaning where the case is not finite, and what the method answered.
struct OwnAnswer {
  const Case& of;
  const Truth& truth;
  Answer given{};
  /// What numbers it gives with a right hit of a ray; empty if it gives none to any case.
  std::function<std::optional<HitAt>()> numbers{};
  std::uint64_t number = 0;  ///< of the case, from 0
};

/// Counts of some cases, by kind of operands and format, and the cases that were answered wrongly, as text. `Text` is
/// what these are kept in: a string, or a spool.
template <class Text>
struct OwnCounts {
  struct Part {
    SampleRow row{};
    HitErrors errors{};
  };

  std::array<Part, 4> parts{};                   ///< triangles, polygons; of each binary64, binary32
  std::array<NonfiniteRow, 2> nonfinite{};       ///< binary64, binary32
  bool gives_numbers = false;                    ///< with any hit
  std::map<std::pair<Rank, int>, Text> wrong{};  ///< counterexamples by rank and part: one line each
};

/// Judges the answer and counts it. Of operands that the method does not take, the answer should be `unsupported`.
void add(OwnCounts<std::string>& counts, const Method& method, const OwnAnswer& answer);

/// Adds those of later cases.
void add(OwnCounts<Spool>& all, const OwnCounts<std::string>& later);

/// Logs one stream for each kind of operands in each format, what became of cases that are not finite, and the
/// counterexamples: the worst first, in the order of the cases.
void log_own_cases(ChainedLog& log, const Method& method, const OwnCounts<Spool>& counts);

}  // namespace tribunal
