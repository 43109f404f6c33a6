// What became of one answer, how bad a wrong one is, and where it comes from.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/method.h"
#include "exact/trial/truth.h"

namespace tribunal {

/// `wrong_contact`: hit or miss is right, and what the method tells beside it is not: which part of the target is met,
/// from which side, or whether the polygon is planar. `fault`: it did something else than answer. `refused`: it
/// declined, although its contract takes the case. `not_owed`: the contract promises nothing of the case.
enum class Outcome : std::uint8_t { right, false_hit, false_miss, wrong_contact, fault, refused, not_owed };

inline constexpr std::array wrong_outcomes = {Outcome::false_hit, Outcome::false_miss, Outcome::wrong_contact,
                                              Outcome::fault};

constexpr bool is_wrong(Outcome o) { return o >= Outcome::false_hit && o <= Outcome::fault; }

/// Whether the answer is right or wrong.
constexpr bool is_judged(Outcome o) { return o <= Outcome::fault; }

/// How bad a wrong answer is, the worst first. `plain`: at everyday scale, in general position and well away from any
/// other, where nobody expects an error (severity.h). `boundary`: at everyday scale, degenerate or nearly so.
/// `extreme`: the rest.
enum class Severity : std::uint8_t { plain, boundary, extreme };

inline constexpr std::array all_severities = {Severity::plain, Severity::boundary, Severity::extreme};

/// Where a wrong answer comes from. `logic`: the method is wrong without rounding too. `rounding`: it is right without.
/// `unknown`: it has no exact twin, or did not answer, or its twin was not asked.
enum class Cause : std::uint8_t { logic, rounding, unknown };

/// In which order findings are reported, the first first: the worst; wrong hits and misses before wrong contacts; then
/// those that naive methods get right, which no excuse of rounding covers; then faults of logic.
struct Rank {
  Severity severity = Severity::extreme;
  bool contact_alone = true;
  bool naive_wrong = true;
  Cause cause = Cause::unknown;

  auto operator<=>(const Rank&) const = default;
};

/// Where a wrong answer to the query comes from; asks the method's exact twin, which is slow.
Cause cause_of(const Method& method, const Query& query, const Truth& truth, Outcome outcome);

/// Asks the twin about some of many wrong answers, which saves time: about all that are plain; of the others about the
/// first `early` of a run of cases, if they are of triangles, whose twins are quick; and about every 17th case, a
/// prime, so that levels and kinds of probe have their share.
struct TwinQuota {
  static constexpr std::uint64_t one_in = 17;

  std::uint64_t early = 4;

  /// `unknown` for those about which it does not ask. `k`: the number of the case, or of the wrong answer.
  Cause cause_of(const Method& method, const Query& query, const Truth& truth, Outcome outcome, Severity severity,
                 std::uint64_t k) {
    const bool is_early = query.operands() == Operands::triangles && early > 0;
    early -= is_early;
    const bool asks = severity == Severity::plain || is_early || k % one_in == 0;
    return asks ? tribunal::cause_of(method, query, truth, outcome) : Cause::unknown;
  }
};

constexpr std::string_view name_of(Outcome o) {
  constexpr std::string_view names[] = {"right", "false hit", "false miss", "wrong contact",
                                        "fault", "refused",   "not owed"};
  return names[static_cast<int>(o)];
}

constexpr std::string_view name_of(Severity s) {
  constexpr std::string_view names[] = {"plain", "boundary", "extreme"};
  return names[static_cast<int>(s)];
}

constexpr std::string_view name_of(Cause c) {
  constexpr std::string_view names[] = {"logic", "rounding", "unknown"};
  return names[static_cast<int>(c)];
}

/// The outcome of this name, or nothing.
constexpr std::optional<Outcome> outcome_named(std::string_view name) {
  for (const Outcome o : wrong_outcomes) {
    if (name == name_of(o)) return o;
  }
  return std::nullopt;
}

/// All three in one sentence, for people.
std::string in_words(Outcome outcome, Severity severity, Cause cause);

}  // namespace tribunal
