// Figures are drawn by Python scripts that are compiled into the program.
#pragma once

#include <string>

namespace tribunal {

/// Writes the script to the directory as plot.py and runs `plot.py DIRECTORY/record DIRECTORY`. Fails with
/// Exit::resources where there is no Python with matplotlib, and with 128 + signal if interrupted.
void draw_figures(const std::string& directory, const std::string& script, const std::string& record);

}  // namespace tribunal
