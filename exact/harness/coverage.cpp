#include "exact/harness/coverage.h"

namespace tribunal {

int Coverage::classes(Format format) const {
  int n = 0;
  for (ClassId id = 1; id <= class_count; ++id) n += at(format, id).judged() > 0;
  return n;
}

int Coverage::classes(Format format, Stage stage) const {
  int n = 0;
  for (ClassId id = 1; id <= class_count; ++id) n += at(format, id).at(stage) > 0;
  return n;
}

std::string Coverage::to_text(const std::vector<Stage>& stages) const {
  std::string text;
  for (const Format format : {Format::binary64, Format::binary32}) {
    text += (text.empty() ? "" : ", ") + std::string(name_of(format)) + " " + std::to_string(classes(format)) + "/" +
            std::to_string(class_count);
    for (const Stage stage : stages) {
      text += (stage == stages.front() ? " (" : ", ") + std::string(name_of(stage)) + " " +
              std::to_string(classes(format, stage)) + (stage == stages.back() ? ")" : "");
    }
  }
  return text;
}

bool is_generic(ClassId id) {
  const ClassRow& row = class_row(id);
  if (row.rank < 4) return false;
  int code = chirotope(row.representative_segment(), row.representative_triangle(), FormulaKernel<double>{}).code;
  for (int i = 0; i < 5; ++i, code /= 3) {
    if (code % 3 == 1) return false;
  }
  return true;
}

}  // namespace tribunal
