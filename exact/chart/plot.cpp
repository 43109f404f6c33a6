// Runs exact/chart/plot.py, which is compiled into the program.
#include "exact/base/embedded.h"
#include "exact/base/figures.h"
#include "exact/chart/chart.h"

namespace tribunal {

void plot(const std::string& directory) { draw_figures(directory, embedded_plot_script, "chart.json"); }

}  // namespace tribunal
