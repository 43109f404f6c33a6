// Figures are drawn by Python scripts that are compiled into the program.
#pragma once

#include <string>
#include <vector>

namespace tribunal {

/// What a script exits with if a module is missing that it draws with.
inline constexpr int script_lacks_module = 69;

/// Writes the script to the directory as plot.py and runs `plot.py DIRECTORY/record DIRECTORY`; returns the lines that
/// it prints. Fails with Exit::resources where there is no Python with matplotlib, with Exit::bad_input where a
/// text in the record does not show as it is or the script cannot draw it, and with 128 + signal if interrupted;
/// plot.log then says what the script said.
std::vector<std::string> draw_figures(const std::string& directory, const std::string& script,
                                      const std::string& record);

}  // namespace tribunal
