// How often each stage decided. The caller owns it: one a thread, added up at the end.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "core/answer.h"

namespace tribunal {

class Tally {
 public:
  std::uint64_t& operator[](Stage s) { return counts_[static_cast<std::size_t>(s)]; }
  std::uint64_t operator[](Stage s) const { return counts_[static_cast<std::size_t>(s)]; }

  Tally& operator+=(const Tally& other) {
    for (std::size_t i = 0; i < counts_.size(); ++i) counts_[i] += other.counts_[i];
    return *this;
  }

  /// The deepest stage that decided anything; `none` if nothing was asked.
  Stage deepest() const {
    Stage deepest = Stage::none;
    for (const Stage s : deciding_stages) {
      if ((*this)[s] > 0) deepest = s;
    }
    return deepest;
  }

 private:
  std::array<std::uint64_t, stage_count> counts_{};
};

}  // namespace tribunal
