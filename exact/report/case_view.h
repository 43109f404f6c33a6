// One case as a report shows it.
#pragma once

#include <string>
#include <vector>

#include "exact/base/json.h"
#include "exact/report/case_book.h"

namespace tribunal {

/// The case line to copy; where it was read and how to replay it; what its finding says; the exact answer; the signs of
/// the five volumes, exact and in each format; and every method's answer as a letter, in the order of `answer_methods`.
/// It is described in docs/report.md.
Json case_view(const FoundCase& found, const std::vector<std::string>& answer_methods);

/// A word of a shell's command line: in single quotes unless it is made of harmless characters alone.
std::string shell_word(const std::string& text);

}  // namespace tribunal
