// Counter-based random draws: every number is a function of (family, seed, case, draw), so any shard can make it.
// Source: Salmon, Moraes, Dror & Shaw, "Parallel random numbers: as easy as 1, 2, 3", SC 2011 (Philox, by Random123).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "exact/cases/families/streams.h"

namespace tribunal {

/// The random numbers of case k under a seed; `stream` is the number of their owner in streams.h. One draw per
/// statement: argument order is unspecified in C++.
class Draw {
 public:
  Draw(std::uint32_t stream, std::uint64_t seed, std::uint64_t k)
      : key_{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)},
        counter_{0, stream, static_cast<std::uint32_t>(k), static_cast<std::uint32_t>(k >> 32)} {}

  std::uint64_t next() {
    if (at_ == words_.size()) refill();
    return words_[at_++];
  }

  /// Uniform in [0, n), n > 0, by Lemire's multiplication; the bias is below n/2⁶⁴.
  std::uint64_t below(std::uint64_t n) {
    __extension__ using wide = unsigned __int128;
    return static_cast<std::uint64_t>((wide{next()} * n) >> 64);
  }

  /// Uniform integer in [lo, hi].
  std::int64_t between(std::int64_t lo, std::int64_t hi) {
    return lo + static_cast<std::int64_t>(below(static_cast<std::uint64_t>(hi - lo) + 1));
  }

 private:
  void refill();

  std::array<std::uint32_t, 2> key_;
  std::array<std::uint32_t, 4> counter_;
  std::array<std::uint64_t, 8> words_;  ///< of four blocks: a processor computes them side by side
  std::size_t at_ = words_.size();
};

}  // namespace tribunal
