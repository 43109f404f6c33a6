// Right or wrong: a method's answer held against the exact one.
#pragma once

#include <array>

#include "core/due.h"
#include "core/method.h"
#include "exact/trial/truth.h"

namespace tribunal {

enum class Judgement : std::uint8_t { right, wrong, unsupported };

/// What contracts can turn on in a case with this exact answer.
Facts facts_of(const Truth& truth);

/// What the contract owes to a case with this exact answer.
Due due(const Contract& contract, const Truth& truth);

/// Holds a hit or a miss against what is owed.
constexpr Judgement judge(Due owed, bool hit) {
  if (owed == Due::nothing) return Judgement::unsupported;
  return hit == (owed == Due::hit) ? Judgement::right : Judgement::wrong;
}

/// Whether the contract owes an answer to every case with these operands that the method does not refuse by itself.
bool owes_all(const Contract& contract, Operands operands);

/// The answer, or `unsupported` where the contract owes none: most methods cannot tell by themselves whether the probe
/// meets a boundary, or a polygon is planar.
Answer within_contract(const Method& method, const Truth& truth, const Answer& answer);

/// Judged by the method's own contract: coplanar contacts are misses to a transversal method, faces seen from behind to
/// one that culls them; where the contract owes nothing, the answer is not judged. A fault is wrong everywhere: to
/// answer is promised of every query.
Judgement judge(const Method& method, const Truth& truth, const Answer& answer);

/// A binary32 method is on trial only where its operands are exact in binary32.
inline bool takes(const Method& method, Format format) {
  return method.contract.format == Format::binary64 || format == Format::binary32;
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
