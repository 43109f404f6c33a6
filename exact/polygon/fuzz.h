// The differential harness on polygons: generated cases, asked of every method, judged by the exact answer.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "exact/io/polygon_case_io.h"
#include "exact/polygon/judge.h"

namespace tribunal {

/// One endless sequence of cases: a family in a format.
struct PolygonStream {
  const PolygonFamily* family;
  Format format;
};

/// All families in both formats.
std::vector<PolygonStream> all_polygon_streams();

struct PolygonFuzzPlan {
  std::vector<Method> methods;  ///< those that take polygons
  std::vector<PolygonStream> streams;
  std::uint64_t seed = 1;
  std::uint64_t cases = 0;  ///< in all, dealt to the streams in turn
  double seconds = 0;       ///< if > 0, stop after that time instead; `cases` is then a ceiling
  unsigned threads = 1;
};

/// Where a count belongs. Indices into the plan; the contact is the exact one.
struct PolygonCell {
  std::size_t method, stream, level;
  Contact contact;
  bool planar;
  auto operator<=>(const PolygonCell&) const = default;
};

/// How often a construction was asked.
using PolygonCoverage = std::map<std::tuple<std::size_t, PolygonPlace, Approach>, std::uint64_t>;

/// A wrong answer, with all that is needed to make the case again.
struct PolygonFinding {
  std::size_t method, stream;
  std::uint64_t k;  ///< case number within the stream
  PolygonTrial trial;
  PolygonTruth truth;
};

struct PolygonFuzzReport {
  std::uint64_t cases = 0;
  double seconds = 0;
  std::map<PolygonCell, Count> counts{};
  PolygonCoverage coverage{};
  std::vector<PolygonFinding>
      findings{};  ///< the first of each method × stream × contact × planar, in order of discovery
};

/// Deterministic: the same plan gives the same report (but for `seconds`) whatever the number of threads.
PolygonFuzzReport fuzz(const PolygonFuzzPlan& plan);

/// "shapes 22 of 22, places × approaches 78 of 78, shapes × places 258 of 258".
std::string describe(const PolygonCoverage& coverage);

/// The finding, shrunk, as a case with a "finding" that says method, answer and origin.
PolygonCase to_counterexample(const PolygonFuzzPlan& plan, const PolygonFinding& finding);

/// What a counterexample says of a method.
Json finding_of(const Method& method, const PolygonQuery& query, const PolygonTruth& truth);

/// What `replay` prints of a case. Sets `wrong` if some method that takes it answers wrongly, or the case claims
/// something false of itself.
std::string replay(const PolygonCase& c, bool& wrong);

}  // namespace tribunal
