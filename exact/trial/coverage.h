// Coverage as a number: which classes, constructions and outcomes were judged, in which format, by answers from which
// stage.
#pragma once

#include <array>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "exact/trial/judge.h"
#include "exact/trial/slot.h"

namespace tribunal {

/// The name of a stage in a report.
using StageWord = std::function<std::string(Stage)>;

/// Answers of one method, by format and slot.
class Coverage {
 public:
  void add(Format format, Slot slot, const Count& count) { of(format)[slot] += count; }
  Count at(Format format, Slot slot) const;

  /// Whether anything was asked of these operands.
  bool has(Operands operands) const;

  /// All answers about these operands.
  Count total(Format format, Operands operands) const;

  /// How many of the group have a judged answer, and an answer from this stage.
  int judged(Format format, const SlotGroup& group) const;
  int judged(Format format, const SlotGroup& group, Stage stage) const;

  /// The same for the 163 classes.
  int classes(Format format) const { return judged(format, slot_groups(Operands::triangles)[0]); }

  /// The groups that a report should name: those of which anything was asked in either format, or the only one.
  std::vector<SlotGroup> groups(Operands operands) const;

  /// "binary64 163/163 (filter 70, integers 163, exact 12), binary32 163/163 (…)"; of polygons, the groups by name.
  /// Stages are called by `word`.
  std::string to_text(
      const std::vector<Stage>& stages, const StageWord& word = [](Stage s) { return std::string(name_of(s)); }) const;

 private:
  using Counts = std::map<Slot, Count>;
  Counts& of(Format format) { return counts_[static_cast<std::size_t>(format)]; }
  const Counts& of(Format format) const { return counts_[static_cast<std::size_t>(format)]; }

  std::array<Counts, 2> counts_{};
};

/// Whether all five orientations of the class are nonzero. In any other class some sign vanishes, and no filter
/// certifies a zero.
bool is_generic(ClassId id);

}  // namespace tribunal
