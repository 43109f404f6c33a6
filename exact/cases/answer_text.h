// Answers as lines of text.
#pragma once

#include <string>

#include "exact/cases/case_io.h"

namespace tribunal {

/// Appends the line that from_answer(c, method, answer).dump() is, with its end.
void append_answer(std::string& lines, const Case& c, const Method& method, const Answer& answer);

}  // namespace tribunal
