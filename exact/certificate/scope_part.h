// What a run of a whole set adds up, for sets of either operands.
#pragma once

#include <bitset>
#include <utility>

#include "exact/certificate/small_scope.h"

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

  Count count{};
  Slots judged{}, wrong_slots{};
  Hash hash{};
  std::vector<Query> wrong{};

  /// Files the answer to a case; `query` makes the case, should it be worth keeping.
  template <class MakeQuery>
  void add(const Method& method, const Truth& truth, const Answer& answer, const MakeQuery& query) {
    const Judgement j = judge(method, truth, answer);
    count.add(j, answer.stage);
    if (j != Judgement::unsupported) judged.set(slot_of(truth));
    hash.add(byte_of(answer));
    if (j == Judgement::wrong) keep(slot_of(truth), query);
  }

  /// Adds a block's findings; blocks come in order.
  void merge(const ScopePart& block) {
    count += block.count;
    judged |= block.judged;
    hash.add(block.hash.state);
    for (const auto& query : block.wrong) {
      keep(slot_of(exact_truth(query)), [&] { return query; });
    }
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
            .wrong = wrong};
  }

 private:
  static std::uint8_t byte_of(const Answer& answer) {
    if (answer.status == Status::ok) return answer.hit ? 1 : 0;
    return is_fault(answer.status) ? 3 : 2;
  }

  template <class MakeQuery>
  void keep(Slot slot, const MakeQuery& query) {
    if (wrong_slots.test(slot)) return;
    wrong_slots.set(slot);
    wrong.push_back(query());
  }
};

}  // namespace tribunal
