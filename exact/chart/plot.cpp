// Runs exact/chart/plot.py, which is compiled into the program with what it imports.
#include <algorithm>

#include "exact/base/embedded.h"
#include "exact/base/figures.h"
#include "exact/base/json.h"
#include "exact/base/output.h"
#include "exact/chart/chart.h"

namespace tribunal {
namespace {

const FigureNames all_figures = {
    "speed-accuracy", "speed-accuracy-shares", "speed-accuracy-polygons", "pictures", "leaks", "speed"};

}  // namespace

void write_chart(const std::string& directory, const Json& record) {
  OutputSet set;
  drop_figures(set, directory, all_figures);
  set.add(directory + "/chart.json", record.dump(1) + "\n");
  set.commit();
}

std::vector<std::string> plot(const std::string& directory) {
  write_file(directory + "/plot_marks.py", embedded_plot_marks);
  write_file(directory + "/plot_sheet.py", embedded_plot_sheet);
  const std::vector<std::string> printed = draw_figures(directory, embedded_plot_script, "chart.json", all_figures);
  std::vector<std::string> figures;
  for (const std::string& name : all_figures) {
    if (std::ranges::find(printed, "drawn " + name) != printed.end()) figures.push_back(name);
  }
  return figures;
}

}  // namespace tribunal
