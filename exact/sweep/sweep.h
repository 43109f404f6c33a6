// Sweeps: what becomes of every method's answers along stress axes.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "exact/sweep/axes/table.h"
#include "exact/trial/fuzz.h"

namespace tribunal {

struct SweepPlan {
  std::vector<Method> methods{};
  std::vector<const StressAxis*> axes{};
  std::uint64_t seed = 1;
  std::uint64_t cases = 2624;  ///< at each value of each axis, in each format: whole rounds of the 328 classes; < 2^32
  unsigned threads = 1;
};

/// Where on the sweep an answer belongs: indices into the plan. Formats and kinds of probe are never added up.
struct SweepPlace {
  std::size_t method = 0, axis = 0;
  Format format = Format::binary64;
  int value = 0;
  ProbeKind probe = ProbeKind::segment;

  auto operator<=>(const SweepPlace&) const = default;
};

/// The answers of one method at one place.
struct SweepCount {
  Count count{};
  std::uint64_t due_hits = 0;            ///< of those judged: a hit was due
  std::array<std::uint64_t, 4> plain{};  ///< wrong ones of severity plain, in the order of `wrong_outcomes`

  void add(const JudgedAnswer& a, const Contract& contract);
  SweepCount& operator+=(const SweepCount& other);

  /// The answers of this outcome, and those that could have been: a false miss needs a hit that is due, a false hit a
  /// miss that is due; every answer that was judged can be a wrong contact or a fault, and every one that the contract
  /// takes can be refused.
  std::uint64_t failures(Outcome o) const;
  std::uint64_t chances(Outcome o) const;

  friend bool operator==(const SweepCount&, const SweepCount&) = default;
};

/// What a sweep counts failures of.
inline constexpr std::array swept_outcomes = {Outcome::false_hit, Outcome::false_miss, Outcome::wrong_contact,
                                              Outcome::fault, Outcome::refused};

/// The first case with an outcome at a place.
struct Witness {
  std::uint64_t k;
  Query query;
  Status status;
};

using Witnesses = std::map<std::pair<SweepPlace, Outcome>, Witness>;

struct Sweep {
  std::map<SweepPlace, SweepCount> counts{};
  Witnesses witnesses{};
  std::uint64_t audited = 0;  ///< cases judged by signs certified one way and by the oracles, which agreed
};

/// Asks every method about every case of every axis that it takes. Deterministic, whatever the number of threads. Fails
/// with 128 + signal if interrupted.
Sweep sweep(const SweepPlan& plan);

/// Whether the method is asked on the axis at all, and whether it is in this format.
bool takes(const Method& method, const StressAxis& axis);

}  // namespace tribunal
