// Answers of one method, counted.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "exact/trial/outcome.h"

namespace tribunal {

/// Cases asked, of these answered wrongly, of these not judged; the stage of each judged answer; and of the wrong
/// ones, what they are. Counts of older logs say no more than how many are wrong: then less than all is said.
struct Count {
  std::uint64_t asked = 0, wrong = 0;
  std::uint64_t unsupported = 0;                      ///< refused, or not owed
  std::uint64_t refused = 0;                          ///< of these, where the contract takes the case
  std::array<std::uint64_t, stage_count> by_stage{};  ///< answers, right or wrong
  std::array<std::uint64_t, 4> by_outcome{};          ///< wrong ones, in the order of `wrong_outcomes`
  std::array<std::uint64_t, 3> by_severity{};         ///< wrong ones
  std::uint64_t logic = 0, rounding = 0;              ///< wrong ones about which the exact twin was asked

  void add(Outcome o, Stage stage) {
    ++asked;
    unsupported += !is_judged(o);
    refused += o == Outcome::refused;
    by_stage[static_cast<std::size_t>(stage)] += is_judged(o);
    if (!is_wrong(o)) return;
    ++wrong;
    ++by_outcome[index_of(o)];
  }

  /// What else is known of a wrong answer that was added.
  void add_wrong(Severity severity, Cause cause) {
    ++by_severity[static_cast<std::size_t>(severity)];
    logic += cause == Cause::logic;
    rounding += cause == Cause::rounding;
  }

  Count& operator+=(const Count& other);

  std::uint64_t judged() const { return asked - unsupported; }
  std::uint64_t not_owed() const { return unsupported - refused; }
  std::uint64_t at(Stage stage) const { return by_stage[static_cast<std::size_t>(stage)]; }
  std::uint64_t at(Outcome wrong_one) const { return by_outcome[index_of(wrong_one)]; }
  std::uint64_t at(Severity severity) const { return by_severity[static_cast<std::size_t>(severity)]; }

  /// Of the wrong answers, those of which the outcome and the severity are not said.
  std::uint64_t unsaid() const { return wrong - at(Severity::plain) - at(Severity::boundary) - at(Severity::extreme); }

  friend bool operator==(const Count&, const Count&) = default;

 private:
  static constexpr std::size_t index_of(Outcome wrong_one) {
    return static_cast<std::size_t>(wrong_one) - static_cast<std::size_t>(Outcome::false_hit);
  }
};

/// What the wrong answers are: "3 false hits, 12 false misses; 2 plain, 13 boundary; 4 logic, 2 rounding of 6 asked".
/// Empty if nothing was wrong or refused.
std::string breakdown(const Count& count);

/// What a count is of: "binary64", "the sets run whole".
struct Counted {
  std::string population;
  Count count;
};

/// The first line of a verdict, about the worst that there was: "wrong in plain general position: 12 of 3456
/// (binary64), 1 of 3456 (binary32)". Populations stay apart; those with nothing of the worst kind are left out.
std::string headline(const std::vector<Counted>& counts);

}  // namespace tribunal
