// Runs exact/chart/plot.py, which is compiled into the program with what it imports.
#include "exact/base/embedded.h"
#include "exact/base/figures.h"
#include "exact/base/files.h"
#include "exact/base/json.h"
#include "exact/chart/chart.h"

namespace tribunal {

std::vector<std::string> plot(const std::string& directory, const Json& record) {
  write_file(directory + "/plot_marks.py", embedded_plot_marks);
  write_file(directory + "/plot_sheet.py", embedded_plot_sheet);
  draw_figures(directory, embedded_plot_script, "chart.json");
  std::vector<std::string> figures = {"speed-accuracy", "speed-accuracy-shares", "speed-accuracy-polygons", "speed"};
  const auto has_rows = [&](const char* part) { return record.contains(part) && !record.at(part).at("rows").empty(); };
  for (const char* const part : {"pictures", "leaks"}) {
    if (has_rows(part)) figures.emplace_back(part);
  }
  return figures;
}

}  // namespace tribunal
