// Where on an axis a method begins to fail, and where it has failed completely.
#pragma once

#include <optional>
#include <vector>

#include "exact/sweep/sweep.h"

namespace tribunal {

/// Counts at one value of an axis.
struct Mark {
  int value = 0;
  std::uint64_t failures = 0, chances = 0;

  friend bool operator==(const Mark&, const Mark&) = default;
};

/// To which side of the axis's easiest value one looks.
enum class AxisSide : std::uint8_t { up, down };

constexpr std::string_view name_of(AxisSide s) { return s == AxisSide::up ? "up" : "down"; }

/// Of one method, on one side of one axis, in one format, asked by one kind of probe: where one outcome begins and
/// where nothing else is left.
struct Threshold {
  std::size_t method = 0, axis = 0;
  Format format = Format::binary64;
  AxisSide side = AxisSide::up;
  ProbeKind probe = ProbeKind::segment;
  SweptOutcome outcome = SweptOutcome::false_hit;

  Mark first{};                  ///< the first value with a failure, seen from the easiest
  std::optional<Mark> before{};  ///< the value before it, without one; none if the easiest value has failures
  std::optional<Mark> all{};     ///< the first from which on everything fails that can, to the end of the axis

  SweepPlace place() const { return {method, axis, format, first.value, probe}; }
};

/// A row for each outcome that was seen; in the order method, axis, format, side, outcome, probe.
std::vector<Threshold> thresholds_of(const SweepPlan& plan, const Sweep& sweep);

/// The values of one side, from the easiest outward. The side down has the easiest value only if it has others.
std::vector<int> values_outward(const StressAxis& axis, Format format, AxisSide side);

}  // namespace tribunal
