// What a population of a chart is really made of.
#pragma once

#include <array>
#include <cstdint>

#include "exact/chart/populations.h"

namespace tribunal {

/// Of the first cases of a population in a format: those in which the closed sets meet, those with a subnormal
/// coordinate, and by which stage the certified method answers them; what its stage `exact` answers does not fit
/// integers of any fixed width that it has.
struct Makeup {
  std::uint64_t cases = 0, hits = 0, subnormal = 0;
  std::array<std::uint64_t, stage_count> by_stage{};

  Makeup& operator+=(const Makeup& other);
  friend bool operator==(const Makeup&, const Makeup&) = default;
};

/// Whether a coordinate is not 0 and below the least normal number of the format.
bool has_subnormal(const Query& query, Format format);

/// Does not depend on the number of threads. Fails with 128 + signal if interrupted.
Makeup makeup_of(const Population& population, Format format, std::uint64_t seed, std::uint64_t cases,
                 unsigned threads);

}  // namespace tribunal
