// Right or wrong: the exact answer to a trial, and a method's answer held against it.
#pragma once

#include "core/method.h"
#include "exact/families/family.h"

namespace tribunal {

/// The exact answer. class_id is 0 for rays.
struct Truth {
  ClassId class_id = 0;
  Contact contact = Contact::none;

  bool hit() const { return contact != Contact::none; }
};

/// The exact answer by three ways that must agree: the class table (signs looked up), the Segura–Feito decision of the
/// reference kernel, and Carathéodory's theorem on the differences, which shares no formula with them. Fails with
/// Exit::oracles_contradict where two differ; there is no majority.
Truth exact_truth(const Query& query);

/// What judged a family's cases, for reports.
constexpr const char* oracle_of(const Family& family) {
  return family.proves_class ? "construction" : "class table, rational kernel, Caratheodory";
}

/// By construction where the trial knows its class, else exact_truth.
Truth truth_of(const Trial& trial);

enum class Judgement : std::uint8_t { right, wrong, unsupported };

/// Judged by the convention that the answer was given under: coplanar contacts are misses to a transversal
/// method.
Judgement judge(Convention convention, const Truth& truth, const Answer& answer);

inline Judgement judge(const Method& method, const Truth& truth, const Answer& answer) {
  return judge(method.convention, truth, answer);
}

/// A binary32 method is on trial only where its operands are exact in binary32.
constexpr bool takes(const Method& method, Format format) {
  return method.format == Format::binary64 || format == Format::binary32;
}

/// Cases asked, of these answered wrongly, of these outside the contract.
struct Count {
  std::uint64_t asked = 0, wrong = 0, unsupported = 0;

  void add(Judgement j) {
    ++asked;
    wrong += j == Judgement::wrong;
    unsupported += j == Judgement::unsupported;
  }
  Count& operator+=(const Count& other) {
    asked += other.asked;
    wrong += other.wrong;
    unsupported += other.unsupported;
    return *this;
  }
  std::uint64_t judged() const { return asked - unsupported; }
  friend bool operator==(const Count&, const Count&) = default;
};

}  // namespace tribunal
