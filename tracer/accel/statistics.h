// What a render counts.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "core/answer.h"

namespace tribunal {

enum class RayKind : std::uint8_t { primary, shadow, reflection, refraction };

inline constexpr RayKind all_ray_kinds[] = {RayKind::primary, RayKind::shadow, RayKind::reflection,
                                            RayKind::refraction};

constexpr std::string_view name_of(RayKind k) {
  constexpr std::string_view names[] = {"primary", "shadow", "reflection", "refraction"};
  return names[static_cast<int>(k)];
}

/// What it cost to answer a query or to compute a pixel.
struct Cost {
  std::uint64_t tests = 0;      ///< tests of faces, those for proved starts included
  Stage deepest = Stage::none;  ///< the deepest stage that answered; tests for proved starts do not count

  Cost& operator+=(const Cost& c) {
    tests += c.tests;
    deepest = std::max(deepest, c.deepest);
    return *this;
  }
};

/// Counts of one thread; the caller owns them and adds them up. Indexed by RayKind where there are four.
struct RayTally {
  std::array<std::uint64_t, 4> rays{};      ///< rays cast; a shadow ray is a segment
  std::array<std::uint64_t, 4> ray_hits{};  ///< of these, those that met something
  std::uint64_t box_tests = 0;
  std::uint64_t triangle_tests = 0, triangle_hits = 0;
  std::uint64_t polygon_tests = 0, polygon_hits = 0;

  std::array<std::uint64_t, stage_count> by_stage{};  ///< answers to those tests by the stage that gave them

  // Of the search for proved starts (departure.h), whose tests are counted here and not above.
  std::uint64_t starts = 0;            ///< secondary-ray origins that were searched for
  std::uint64_t start_candidates = 0;  ///< points that were tried as origins
  std::uint64_t start_tests = 0;       ///< primitives tested against segments to these points
  std::uint64_t starts_unproved = 0;   ///< searches in which no point could be proved

  RayTally& operator+=(const RayTally& t) {
    for (std::size_t k = 0; k < rays.size(); ++k) {
      rays[k] += t.rays[k];
      ray_hits[k] += t.ray_hits[k];
    }
    box_tests += t.box_tests;
    triangle_tests += t.triangle_tests;
    triangle_hits += t.triangle_hits;
    polygon_tests += t.polygon_tests;
    polygon_hits += t.polygon_hits;
    for (std::size_t s = 0; s < by_stage.size(); ++s) by_stage[s] += t.by_stage[s];
    starts += t.starts;
    start_candidates += t.start_candidates;
    start_tests += t.start_tests;
    starts_unproved += t.starts_unproved;
    return *this;
  }

  std::uint64_t tests() const { return triangle_tests + polygon_tests; }
  std::uint64_t hits() const { return triangle_hits + polygon_hits; }

  std::uint64_t all_rays() const { return rays[0] + rays[1] + rays[2] + rays[3]; }
};

/// The cost of all that was counted between two states of one tally.
inline Cost cost_between(const RayTally& before, const RayTally& after) {
  Cost cost{after.tests() + after.start_tests - before.tests() - before.start_tests, Stage::none};
  for (const Stage s : deciding_stages) {
    if (after.by_stage[static_cast<std::size_t>(s)] > before.by_stage[static_cast<std::size_t>(s)]) cost.deepest = s;
  }
  return cost;
}

}  // namespace tribunal
