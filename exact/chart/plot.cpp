// Runs exact/chart/plot.py, which is compiled into the program with what it imports.
#include <algorithm>
#include <filesystem>

#include "exact/base/embedded.h"
#include "exact/base/figures.h"
#include "exact/base/files.h"
#include "exact/chart/chart.h"

namespace tribunal {
namespace {

constexpr const char* all_figures[] = {
    "speed-accuracy", "speed-accuracy-shares", "speed-accuracy-polygons", "pictures", "leaks", "speed"};

/// So that no figure of an older record stands beside this one's.
void remove_figure(const std::string& directory, const std::string& name) {
  for (const char* ending : {".svg", ".pdf", ".png"}) std::filesystem::remove(directory + "/" + name + ending);
}

}  // namespace

std::vector<std::string> plot(const std::string& directory) {
  write_file(directory + "/plot_marks.py", embedded_plot_marks);
  write_file(directory + "/plot_sheet.py", embedded_plot_sheet);
  const std::vector<std::string> printed = draw_figures(directory, embedded_plot_script, "chart.json");
  std::vector<std::string> figures;
  for (const char* const name : all_figures) {
    if (std::ranges::find(printed, std::string("drawn ") + name) != printed.end()) {
      figures.emplace_back(name);
    } else {
      remove_figure(directory, name);
    }
  }
  return figures;
}

}  // namespace tribunal
