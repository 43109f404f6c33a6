// The reader of a case's line, quick where the line is of the usual kind.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "exact/cases/case_io.h"

namespace tribunal {

/// Reads the case of a line as programs write it: keys in any order, plain strings, finite numbers, no finding. Returns
/// false, and leaves anything in `c`, for every other line, legal or not: to_case reads it, or says what is wrong.
bool scan_case(std::string_view line, Case& c);

/// Reads the case on a line of a file: quickly, or as to_case does.
void read_case(std::string_view line, const std::string& path, std::size_t number, Case& c);

}  // namespace tribunal
