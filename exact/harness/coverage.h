// Coverage as a number: which classes were judged, in which format, by answers from which stage.
#pragma once

#include <array>
#include <string>

#include "exact/classes/class_table.h"
#include "exact/harness/judge.h"

namespace tribunal {

/// Judged answers of one method, by format and class.
class Coverage {
 public:
  void add(Format format, ClassId id, const Count& count) { of(format)[id] += count; }
  const Count& at(Format format, ClassId id) const { return counts_[static_cast<std::size_t>(format)][id]; }

  /// Of the 163: classes with a judged answer, and with an answer from this stage.
  int classes(Format format) const;
  int classes(Format format, Stage stage) const;

  /// "binary64 163/163 (filter 70, expansion 163, exact 12), binary32 163/163 (…)".
  std::string to_text(const std::vector<Stage>& stages) const;

 private:
  std::array<Count, class_count + 1>& of(Format format) { return counts_[static_cast<std::size_t>(format)]; }

  std::array<std::array<Count, class_count + 1>, 2> counts_{};
};

/// Whether all five orientations of the class are nonzero. In any other class some sign vanishes, and no filter
/// certifies a zero.
bool is_generic(ClassId id);

}  // namespace tribunal
