#include "exact/trial/coverage.h"

#include <algorithm>
#include <set>

#include "exact/classes/class_table.h"

namespace tribunal {
namespace {

/// The number of members of the group that have a count for which `good` holds.
template <class Good>
int members(const std::map<Slot, Count>& counts, const SlotGroup& group, const Good& good) {
  std::set<int> found;
  for (const auto& [slot, count] : counts) {
    if (group.member(slot) >= 0 && good(count)) found.insert(group.member(slot));
  }
  return static_cast<int>(found.size());
}

std::string text_of(const Coverage& c, Format format, const SlotGroup& group, const std::vector<Stage>& stages,
                    const StageWord& word) {
  std::string text = std::to_string(c.judged(format, group)) + "/" + std::to_string(group.size);
  if (!group.finest) return text;
  for (const Stage stage : stages) {
    text += (stage == stages.front() ? " (" : ", ") + word(stage) + " " +
            std::to_string(c.judged(format, group, stage)) + (stage == stages.back() ? ")" : "");
  }
  return text;
}

}  // namespace

Count Coverage::at(Format format, Slot slot) const {
  const auto found = of(format).find(slot);
  return found == of(format).end() ? Count{} : found->second;
}

bool Coverage::has(Operands operands) const {
  return total(Format::binary64, operands).asked + total(Format::binary32, operands).asked > 0;
}

Count Coverage::total(Format format, Operands operands) const {
  Count sum;
  for (const auto& [slot, count] : of(format)) {
    if (operands_of(slot) == operands) sum += count;
  }
  return sum;
}

int Coverage::judged(Format format, const SlotGroup& group) const {
  return members(of(format), group, [](const Count& count) { return count.judged() > 0; });
}

int Coverage::judged(Format format, const SlotGroup& group, Stage stage) const {
  return members(of(format), group, [stage](const Count& count) { return count.at(stage) > 0; });
}

std::vector<SlotGroup> Coverage::groups(Operands operands) const {
  const std::vector<SlotGroup>& all = slot_groups(operands);
  const auto asked = [&](const SlotGroup& group, Format format) {
    return members(of(format), group, [](const Count& count) { return count.asked > 0; }) > 0;
  };
  std::vector<SlotGroup> named;
  std::ranges::copy_if(all, std::back_inserter(named), [&](const SlotGroup& group) {
    return asked(group, Format::binary64) || asked(group, Format::binary32);
  });
  return named.empty() ? std::vector{all.front()} : named;
}

std::string Coverage::to_text(const std::vector<Stage>& stages, const StageWord& word) const {
  std::string text;
  for (const Operands operands : {Operands::triangles, Operands::polygons}) {
    if (operands == Operands::polygons ? !has(operands) : has(Operands::polygons) && !has(operands)) continue;
    if (has(Operands::triangles) && has(Operands::polygons)) {
      text += operands == Operands::triangles ? "classes: " : "; polygons: ";
    }
    for (const Format format : {Format::binary64, Format::binary32}) {
      text += (text.empty() || text.ends_with(": ") ? "" : ", ") + std::string(name_of(format));
      std::string separator = " ";
      for (const SlotGroup& group : groups(operands)) {
        text += separator + (group.name == slot_groups(Operands::triangles)[0].name ? "" : group.name + " ");
        text += text_of(*this, format, group, stages, word);
        separator = ", ";
      }
    }
  }
  return text;
}

bool is_generic(ClassId id) {
  const ClassRow& row = class_row(id);
  if (row.rank < 4) return false;
  const auto code_of = [&](const auto& probe) {
    return chirotope(probe, row.representative_triangle(), FormulaKernel<double>{}).code;
  };
  int code = std::visit(code_of, row.representative_probe());
  for (int i = 0; i < 5; ++i, code /= 3) {
    if (code % 3 == 1) return false;
  }
  return true;
}

}  // namespace tribunal
