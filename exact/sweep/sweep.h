// Sweeps: what becomes of every method's answers along stress axes.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "exact/sweep/axes/table.h"
#include "exact/sweep/outcome.h"
#include "exact/trial/fuzz.h"

namespace tribunal {

struct SweepPlan;
struct Sweep;

/// An axis along which rays are aimed at a mesh. It places no cases; a room further down runs it.
struct MeshAxis {
  std::shared_ptr<const StressAxis> axis{};
  /// Adds what the methods of the plan answer at each value of its axis of this number.
  std::function<void(const SweepPlan&, std::size_t axis, Sweep&)> run{};
  std::string off{};  ///< the mesh, as a file
};

struct SweepPlan {
  std::vector<Method> methods{};
  std::vector<const StressAxis*> axes{};
  std::uint64_t seed = 1;
  std::uint64_t cases = 2624;  ///< at each value of each axis, in each format: whole rounds of the 328 classes; < 2^32
  unsigned threads = 1;
  std::optional<MeshAxis> of_mesh{};  ///< if one of the axes aims at a mesh
};

/// Where on the sweep an answer belongs: indices into the plan. Formats and kinds of probe are never added up.
struct SweepPlace {
  std::size_t method = 0, axis = 0;
  Format format = Format::binary64;
  int value = 0;
  ProbeKind probe = ProbeKind::segment;

  auto operator<=>(const SweepPlace&) const = default;
};

/// What a ray at a mesh showed of a method: for each error the severity of the ray and the face that shows it.
struct MeshAnswer {
  std::array<std::optional<Severity>, swept_outcomes.size()> errors{};
  bool parity_judged = false;

  std::optional<Severity>& operator[](SweptOutcome o) { return errors[static_cast<std::size_t>(o)]; }
};

/// The answers of one method at one place.
struct SweepCount {
  Count count{};
  std::uint64_t due_hits = 0;                                ///< of those judged: a hit was due
  std::uint64_t mesh_rays = 0, parity_judged = 0;            ///< rays at a mesh: then all answers are about such
  std::array<std::uint64_t, swept_outcomes.size()> of{};     ///< answers by outcome
  std::array<std::uint64_t, swept_outcomes.size()> plain{};  ///< of these, the wrong ones of severity plain

  void add(const JudgedAnswer& a, const Contract& contract);
  void add(const MeshAnswer& a);
  SweepCount& operator+=(const SweepCount& other);

  /// The answers of this outcome, and those that could have been: a false miss needs a hit that is due, a false hit a
  /// miss that is due; every answer that was judged can be a wrong contact or a fault, and every one that the contract
  /// takes can be refused. Every ray at a mesh can be any error of such, but parity is not judged of all.
  std::uint64_t failures(SweptOutcome o) const { return of[static_cast<std::size_t>(o)]; }
  std::uint64_t chances(SweptOutcome o) const;

  friend bool operator==(const SweepCount&, const SweepCount&) = default;
};

/// The first case with an outcome at a place. Of a ray at a mesh, the case is of the face that shows the error.
struct Witness {
  std::uint64_t k;
  Query query;
  Status status;
};

using Witnesses = std::map<std::pair<SweepPlace, SweptOutcome>, Witness>;

struct Sweep {
  std::map<SweepPlace, SweepCount> counts{};
  Witnesses witnesses{};
  std::uint64_t audited = 0;  ///< cases judged by signs certified one way and by the oracles, which agreed

  /// Keeps the witness if there is none of a lower number.
  void note(const SweepPlace& place, SweptOutcome outcome, const Witness& witness);
  Sweep& operator+=(const Sweep& other);
};

/// Asks every method about every case of every axis that it takes. Deterministic, whatever the number of threads. Fails
/// with 128 + signal if interrupted.
Sweep sweep(const SweepPlan& plan);

/// Whether the method is asked on the axis at all, and whether it is in this format.
bool takes(const Method& method, const StressAxis& axis);

}  // namespace tribunal
