// Right or wrong: the exact answer to a trial, and a method's answer held against it.
#pragma once

#include <array>

#include "core/method.h"
#include "exact/families/family.h"

namespace tribunal {

/// The exact answer.
struct Truth {
  ClassId class_id = 0;
  Contact contact = Contact::none;

  bool hit() const { return contact != Contact::none; }
};

/// The exact answer by ways that must agree: the class table (signs looked up), the Segura–Feito decision of the
/// reference kernel, Carathéodory's theorem on the differences (which shares no formula with them), and CGAL's
/// do_intersect where its preconditions hold. Fails with Exit::oracles_contradict and both witnesses where two differ;
/// there is no majority.
Truth exact_truth(const Query& query);

/// What judged a family's cases, for reports.
constexpr const char* oracle_of(const Family& family) {
  return family.proves_class ? "construction, 1 case in 257 also by the other oracles"
                             : "class table, rational kernel, Caratheodory, CGAL where defined";
}

/// By construction where the trial knows its class, else exact_truth. Case numbers divisible by 257 (prime, so that all
/// classes and levels come up) are judged both ways.
Truth truth_of(const Trial& trial, std::uint64_t k);

enum class Judgement : std::uint8_t { right, wrong, unsupported };

/// Judged by the method's own convention: coplanar contacts are misses to a transversal method. A fault is wrong.
inline Judgement judge(const Method& method, const Truth& truth, const Answer& answer) {
  if (is_fault(answer.status)) return Judgement::wrong;
  if (answer.status != Status::ok) return Judgement::unsupported;
  return answer.hit == counts_as_hit(truth.contact, method.convention) ? Judgement::right : Judgement::wrong;
}

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
