// Figures are drawn by Python scripts that are compiled into the program.
#pragma once

#include <string>
#include <vector>

#include "exact/base/output.h"

namespace tribunal {

/// What a script exits with if the record is not one that it can draw; if a module is missing that it draws with; if a
/// figure cannot be written. Whatever else it ends with, for want of memory above all, says nothing of the record.
inline constexpr int script_refuses_record = 65, script_lacks_module = 69, script_cannot_write = 74;

/// Names of figures without their endings; "axis-*" is all that begin so.
using FigureNames = std::vector<std::string>;

/// The figures of these names are of an earlier record: they go when the set appears.
void drop_figures(OutputSet& set, const std::string& directory, const FigureNames& names);

/// Writes the script to the directory as plot.py and runs `plot.py DIRECTORY/record ELSEWHERE`; the figures appear in
/// the directory together, once all are drawn, and those of these names that were not drawn go. Returns the lines that
/// the script prints. Fails with Exit::resources where there is no Python with matplotlib or it cannot run, with
/// Exit::bad_input where a text in the record does not show as it is or the script cannot draw it, with
/// Exit::output_failed where it cannot write, and with 128 + signal if interrupted. Where it failed by itself, plot.log
/// says how, in characters that show as they are.
std::vector<std::string> draw_figures(const std::string& directory, const std::string& script,
                                      const std::string& record, const FigureNames& names);

}  // namespace tribunal
