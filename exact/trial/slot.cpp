#include "exact/trial/slot.h"

#include <array>
#include <unordered_map>

#include "exact/cases/polygons/construction.h"
#include "exact/classes/class_table.h"

namespace tribunal {
namespace {

constexpr std::size_t contact_count = 5;  ///< that an exact answer can have
constexpr Slot first_construction = all_class_count + 1;

/// All outcomes that exist: a coplanar contact occurs with planar polygons only.
std::vector<Truth> find_outcomes() {
  std::vector<Truth> found;
  for (std::size_t contact = 0; contact < contact_count; ++contact) {
    const auto outcome = static_cast<Contact>(contact);
    found.push_back({.contact = outcome, .planar = true});
    if (outcome != Contact::coplanar) found.push_back({.contact = outcome, .planar = false});
  }
  return found;
}

const std::vector<Truth>& outcomes() {
  static const std::vector<Truth> found = find_outcomes();
  return found;
}

/// 2·n slots from `first` on: n for segments, then n for rays.
struct Twice {
  Slot first;
  std::size_t n;

  Slot end() const { return static_cast<Slot>(first + 2 * n); }
  bool contains(Slot s) const { return first <= s && s < end(); }
  Slot at(std::size_t i, bool of_ray) const { return static_cast<Slot>(first + i + (of_ray ? n : 0)); }
  std::size_t index(Slot s) const { return (s - first) % n; }
  bool of_ray(Slot s) const { return s - first >= static_cast<int>(n); }
};

Twice construction_slots() { return {first_construction, all_constructions().size()}; }
Twice outcome_slots() { return {construction_slots().end(), outcomes().size()}; }

bool is_class(Slot slot) { return slot > 0 && slot < first_construction; }
bool is_construction(Slot slot) { return construction_slots().contains(slot); }
bool is_outcome(Slot slot) { return outcome_slots().contains(slot); }

const Construction& construction_of(Slot slot) { return all_constructions()[construction_slots().index(slot)]; }
const Truth& outcome_of(Slot slot) { return outcomes()[outcome_slots().index(slot)]; }

std::string name_of(const Construction& c) {
  return std::string(all_shapes()[c.shape].name) + " / " + std::string(name_of(c.place)) + " / " +
         std::string(name_of(c.approach));
}

std::string name_of(const Truth& truth) {
  return std::string(name_of(truth.contact)) + (truth.planar ? "" : ", not planar");
}

int class_member(Slot slot) { return is_class(slot) && !is_ray_class(slot) ? slot : -1; }
int ray_class_member(Slot slot) { return is_class(slot) && is_ray_class(slot) ? slot : -1; }

int shape_member(Slot slot) { return is_construction(slot) ? static_cast<int>(construction_of(slot).shape) : -1; }

int place_member(Slot slot) {
  if (!is_construction(slot)) return -1;
  const Construction& c = construction_of(slot);
  return static_cast<int>(c.place) * approach_count + static_cast<int>(c.approach);
}

/// The index of the slot's construction, for either kind of probe or for rays alone; −1 if it has none.
template <bool rays_alone>
int construction_member(Slot slot) {
  if (!is_construction(slot) || (rays_alone && !construction_slots().of_ray(slot))) return -1;
  return static_cast<int>(construction_slots().index(slot));
}

template <bool rays_alone>
int outcome_member(Slot slot) {
  if (!is_outcome(slot) || (rays_alone && !outcome_slots().of_ray(slot))) return -1;
  return static_cast<int>(outcome_slots().index(slot));
}

std::unordered_map<std::string, Slot> find_names() {
  std::unordered_map<std::string, Slot> names;
  for (Slot slot = 1; slot < slots_of(Operands::polygons).end; ++slot) names.emplace(slot_name(slot), slot);
  return names;
}

}  // namespace

SlotRange slots_of(Operands operands) {
  if (operands == Operands::triangles) return {1, first_construction};
  return {first_construction, outcome_slots().end()};
}

Operands operands_of(Slot slot) { return slot < first_construction ? Operands::triangles : Operands::polygons; }

Slot slot_of(const Truth& truth) {
  if (truth.operands() == Operands::triangles) return truth.class_id;
  const std::size_t index = 2 * static_cast<std::size_t>(truth.contact) + (truth.planar ? 0 : 1);
  return outcome_slots().at(index, truth.of_ray);
}

Slot slot_of(const Trial& trial, const Truth& truth) {
  return trial.construction ? slot_of(*trial.construction, truth.of_ray) : slot_of(truth);
}

Slot slot_of(const Construction& construction, bool of_ray) {
  return construction_slots().at(index_of(construction), of_ray);
}

bool is_of_rays(Slot slot) {
  if (is_class(slot)) return is_ray_class(slot);
  return is_construction(slot) ? construction_slots().of_ray(slot) : outcome_slots().of_ray(slot);
}

std::string slot_name(Slot slot) {
  if (!is_class(slot)) {
    const std::string name = is_outcome(slot) ? name_of(outcome_of(slot)) : name_of(construction_of(slot));
    return name + (is_of_rays(slot) ? ", ray" : "");
  }
  return class_name(static_cast<ClassId>(slot));
}

std::optional<Slot> slot_named(const std::string& name) {
  static const std::unordered_map<std::string, Slot> names = find_names();
  const auto found = names.find(name);
  return found == names.end() ? std::nullopt : std::optional(found->second);
}

std::string slot_description(Slot slot) {
  if (is_construction(slot)) return "configuration / place / approach";
  if (is_outcome(slot)) return "exact contact";
  const ClassRow& row = class_row(static_cast<ClassId>(slot));
  return "triangle " + row.triangle + (is_ray_class(row.id) ? ", ray " : ", segment ") + row.probe +
         ", meet: " + row.intersection + " " + (row.hit() ? row.touches : "");
}

const std::vector<SlotGroup>& slot_groups(Operands operands) {
  static const std::vector<SlotGroup> of_triangles = {{"classes", class_count, true, class_member},
                                                      {"ray classes", ray_class_count, true, ray_class_member}};
  static const std::vector<SlotGroup> of_polygons = {
      {"ring configurations", shape_count, false, shape_member},
      {"places x approaches", place_count * approach_count, false, place_member},
      {"constructions", all_constructions().size(), true, construction_member<false>},
      {"outcomes", outcomes().size(), true, outcome_member<false>},
      {"constructions by rays", all_constructions().size(), true, construction_member<true>},
      {"outcomes by rays", outcomes().size(), true, outcome_member<true>},
  };
  return operands == Operands::triangles ? of_triangles : of_polygons;
}

std::vector<Slot> slots_due(Operands operands, bool aimed) {
  std::vector<Slot> due;
  for (Slot slot = slots_of(operands).first; slot < slots_of(operands).end; ++slot) {
    if (is_class(slot) || (aimed ? is_construction(slot) : is_outcome(slot))) {
      due.push_back(slot);
    }
  }
  return due;
}

}  // namespace tribunal
