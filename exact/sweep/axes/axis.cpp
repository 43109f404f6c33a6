#include "exact/sweep/axes/axis.h"

namespace tribunal {

/// The value is a part of the case number, so that no two values share a draw.
Trial case_at(const StressAxis& axis, Format format, std::uint64_t seed, int value, std::uint64_t k) {
  const std::uint64_t number = std::uint64_t{static_cast<std::uint32_t>(value)} << 32 | k;
  Draw draw(axis.stream, seed, number);
  Trial trial = axis.place(draw, format, value, k);
  trial.level = 0;
  return trial;
}

}  // namespace tribunal
