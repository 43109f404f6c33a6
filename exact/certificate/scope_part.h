// What a run of a whole set adds up, for sets of either operands.
#pragma once

#include <bitset>
#include <set>
#include <tuple>
#include <utility>

#include "exact/certificate/small_scope.h"
#include "exact/trial/severity.h"

namespace tribunal {

/// FNV-1a, 64 bits.
struct Hash {
  std::uint64_t state = 0xcbf29ce484222325;

  void add(std::uint8_t byte) { state = (state ^ byte) * 0x100000001b3; }
  void add(std::uint64_t word) {
    for (int shift = 0; shift < 64; shift += 8) add(static_cast<std::uint8_t>(word >> shift));
  }
};

/// What one worker or block has found.
struct ScopePart {
  using Slots = std::bitset<2048>;
  using Kind = std::tuple<Slot, Outcome, Severity>;

  struct WrongCase {
    Query query;
    Kind kind;
  };

  Count count{};
  Slots judged{};
  Hash hash{};
  std::set<Kind> kinds{};          ///< of wrong answers that came up
  std::vector<WrongCase> wrong{};  ///< the first of each
  TwinQuota quota{};

  /// Files the answer to a case; `query` makes the case, should it be wrong.
  template <class MakeQuery>
  void add(const Method& method, const Truth& truth, const Answer& answer, const MakeQuery& query) {
    const Outcome outcome = judge(method, truth, answer);
    count.add(outcome, answer.stage);
    if (is_judged(outcome)) judged.set(slot_of(truth));
    hash.add(byte_of(answer));
    if (is_wrong(outcome)) add_wrong(method, truth, outcome, query());
  }

  /// Adds a block's findings; blocks come in order.
  void merge(const ScopePart& block) {
    count += block.count;
    judged |= block.judged;
    hash.add(block.hash.state);
    for (const WrongCase& c : block.wrong) keep(c);
  }

  ScopeResult result(const SetDescription& set, std::string oracles) const {
    return {.name = set.name,
            .of_rays = set.of_rays,
            .oracles = std::move(oracles),
            .size = set.size,
            .answers_hash = hash.state,
            .count = count,
            .classes = static_cast<int>(judged.count()),
            .complete = count.asked == set.size,
            .wrong = queries()};
  }

 private:
  std::vector<Query> queries() const {
    std::vector<Query> list;
    for (const WrongCase& c : wrong) list.push_back(c.query);
    return list;
  }

  static std::uint8_t byte_of(const Answer& answer) {
    if (answer.status == Status::ok) return answer.hit ? 1 : 0;
    return is_fault(answer.status) ? 3 : 2;
  }

  void add_wrong(const Method& method, const Truth& truth, Outcome outcome, const Query& query) {
    const Severity severity = severity_of(query, truth);
    count.add_wrong(severity, quota.cause_of(method, query, truth, outcome, severity, count.wrong));
    keep({query, {slot_of(truth), outcome, severity}});
  }

  void keep(const WrongCase& c) {
    if (kinds.insert(c.kind).second) wrong.push_back(c);
  }
};

}  // namespace tribunal
