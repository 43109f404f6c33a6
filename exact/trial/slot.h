// What a case is counted under, for triangles and polygons alike.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "exact/trial/truth.h"

namespace tribunal {

/// For triangles: the class, of a segment or a ray. Above these, for polygons: the constructions
/// (configuration × place × approach), for cases that know theirs; and the outcomes (contact, planar or not) for the
/// others; each with segments and with rays.
using Slot = std::uint16_t;

/// Slots first ≤ s < end.
struct SlotRange {
  Slot first, end;

  std::size_t size() const { return static_cast<std::size_t>(end - first); }
  bool contains(Slot s) const { return first <= s && s < end; }
};

SlotRange slots_of(Operands operands);
Operands operands_of(Slot slot);

/// The slot of a case of which only the exact answer is known.
Slot slot_of(const Truth& truth);

/// The slot of a generated case: by its construction, if that is known.
Slot slot_of(const Trial& trial, const Truth& truth);

Slot slot_of(const Construction& construction, bool of_ray);

/// Whether the slot's cases have rays, else segments.
bool is_of_rays(Slot slot);

/// "C017", "R017", "comb / outer corner / through", "edge", "none, not planar".
std::string slot_name(Slot slot);

/// The slot of this name; nothing if no slot has it.
std::optional<Slot> slot_named(const std::string& name);

/// What the name of the slot stands for, in words.
std::string slot_description(Slot slot);

/// Slots that are counted together, such as the 163 classes, or all that have one ring configuration.
struct SlotGroup {
  std::string name;     ///< what is counted
  std::size_t size;     ///< how many there are
  bool finest;          ///< each slot is a member by itself
  int (*member)(Slot);  ///< which member of the group the slot belongs to; -1: none
};

const std::vector<SlotGroup>& slot_groups(Operands operands);

/// The slots that a sampled sequence must have cases of: all classes of triangles; for polygons, all constructions if
/// `aimed`, else all outcomes.
std::vector<Slot> slots_due(Operands operands, bool aimed);

}  // namespace tribunal
