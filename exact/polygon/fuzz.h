// The differential harness on polygons.
#pragma once

#include <string>

#include "exact/harness/fuzz.h"
#include "exact/io/polygon_case_io.h"
#include "exact/polygon/judge.h"

namespace tribunal {

/// What judges polygon cases whose construction is not known.
inline constexpr const char* polygon_oracles = "rational kernel, point in rings twice, covering surface, Caratheodory";

/// What the harness needs to know of cases with polygons.
struct OnPolygons {
  using Family = PolygonFamily;
  using Trial = PolygonTrial;
  using Truth = PolygonTruth;
  using Answer = PolygonAnswer;
  using Query = PolygonQuery;
  using Case = PolygonCase;
  static constexpr Operands operands = Operands::polygons;
  static constexpr std::uint64_t block_size = 256;  ///< the oracles take their time

  static Truth truth_of(const Trial& trial, std::uint64_t) { return tribunal::truth_of(trial); }
  static Slot slot_of(const Trial& trial, const Truth& truth) {
    return trial.known ? tribunal::slot_of(*trial.known, truth.of_ray) : tribunal::slot_of(truth);
  }
  static bool aims(const Family& family) { return family.constructs; }
  static const char* oracle_of(const Family& family) {
    return family.constructs ? "construction, rational kernel, point in rings twice, covering surface, Caratheodory"
                             : polygon_oracles;
  }
};

using PolygonStream = BasicStream<OnPolygons>;
using PolygonFuzzPlan = BasicFuzzPlan<OnPolygons>;
using PolygonFinding = BasicFinding<OnPolygons>;
using PolygonFuzzReport = BasicFuzzReport<OnPolygons>;

/// All families in both formats.
std::vector<PolygonStream> all_polygon_streams();

}  // namespace tribunal
