// What a test of segments, and of rays, costs, by the share of its pairs that hit, and by how it is called.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "exact/base/json_fwd.h"
#include "exact/chart/timing.h"

namespace tribunal {

/// Percentages of random pairs that hit: none, as many as the paper counted in its scenes, half, all.
inline constexpr std::array hit_shares = {0, 7, 50, 100};

/// Pairs of each share: more than a branch predictor learns; each repetition takes some of them.
inline constexpr std::size_t timed_pairs = 65'200;

/// One way to call one test, timed on each of `hit_shares`.
struct SpeedRow {
  std::string method;
  ProbeKind probe = ProbeKind::segment;
  std::string call;           ///< "single", "batch", "prepared"; or "set-up", a triangle, which no probe changes
  std::size_t bytes = 0;      ///< kept of a triangle; 0: not known, or not kept
  std::vector<Timing> times;  ///< in the order of `hit_shares`; of set-up the first alone
  bool does_nothing = false;  ///< no method, but a test that shows what a clock shows of none
};

/// Every call of every method, and of two tests that do nothing, interleaved, first about segments and then about rays:
/// on the pairs that `./run bench predicate` takes, by the loops that `Method::native` and `native_rays` have.
std::vector<SpeedRow> measure_speed(std::span<const Method> methods, int repetitions);

Json to_json(const std::vector<SpeedRow>& rows);
std::string to_table(const std::vector<SpeedRow>& rows);

}  // namespace tribunal
