// Right or wrong: a method's answer held against the exact one.
#pragma once

#include <array>

#include "core/method.h"
#include "exact/harness/truth.h"

namespace tribunal {

enum class Judgement : std::uint8_t { right, wrong, unsupported };

/// Whether the method promises an answer to a case with this exact answer; and to all cases with these operands.
bool promises(const Method& method, const Truth& truth);
bool promises_all(const Method& method, Operands operands);

/// The answer, or `unsupported` where the method promises none: an inexact method cannot tell by itself whether a
/// polygon is planar, or a probe meets its boundary.
Answer within_contract(const Method& method, const Truth& truth, const Answer& answer);

/// By the method's own convention and promise: coplanar contacts are misses to a transversal method; probes that meet a
/// ring edge and polygons that are not planar are not judged where the method promises nothing of them.
Judgement judge(const Method& method, const Truth& truth, const Answer& answer);

/// A binary32 method is on trial only where its operands are exact in binary32.
constexpr bool takes(const Method& method, Format format) {
  return method.format == Format::binary64 || format == Format::binary32;
}

/// Cases asked, of these answered wrongly, of these outside the contract; and the stage of each answer.
struct Count {
  std::uint64_t asked = 0, wrong = 0, unsupported = 0;
  std::array<std::uint64_t, stage_count> by_stage{};  ///< answers, right or wrong

  void add(Judgement j, Stage stage) {
    ++asked;
    wrong += j == Judgement::wrong;
    unsupported += j == Judgement::unsupported;
    by_stage[static_cast<std::size_t>(stage)] += j != Judgement::unsupported;
  }
  Count& operator+=(const Count& other) {
    asked += other.asked;
    wrong += other.wrong;
    unsupported += other.unsupported;
    for (std::size_t i = 0; i < by_stage.size(); ++i) by_stage[i] += other.by_stage[i];
    return *this;
  }
  std::uint64_t judged() const { return asked - unsupported; }
  std::uint64_t at(Stage stage) const { return by_stage[static_cast<std::size_t>(stage)]; }
  friend bool operator==(const Count&, const Count&) = default;
};

}  // namespace tribunal
