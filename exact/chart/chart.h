// Speed and accuracy of methods, measured on the same cases.
#pragma once

#include <string>
#include <vector>

#include "exact/base/json_fwd.h"
#include "exact/chart/populations.h"
#include "exact/chart/speed.h"
#include "exact/chart/timing.h"

namespace tribunal {

struct ChartPlan {
  std::vector<Method> methods;
  std::uint64_t seed = 1;
  std::uint64_t cases = 50'000;  ///< how many are judged of each population and format
  int repetitions = 31;
  unsigned threads = 1;  ///< for judging; time is taken on one thread
};

/// One method on the cases of one population in one format.
struct ChartRow {
  std::size_t method, population;
  Format format;
  bool drawn;  ///< it stands for the method in the figure
  Count count;
  Timing time;
};

/// One method at one value of the sweep's axis of mantissa fill: images of degenerate cases by maps with entries of
/// `bits` bits.
struct OnsetRow {
  std::size_t method;
  Format format;
  bool drawn;
  int bits;
  Count count;
};

/// The cases of one population in one format.
struct Panel {
  std::size_t population;
  Format format;
  std::uint64_t cases = 0, hits = 0;
};

struct Chart {
  std::vector<Panel> panels;
  std::vector<ChartRow> rows;
  std::vector<OnsetRow> onset;
  std::vector<SpeedRow> speed;
};

/// Counts are a function of methods, seed and cases; times are measured. Fails with 128 + signal if interrupted.
Chart measure(const ChartPlan& plan);

/// Every number that is drawn, and the environment.
Json to_json(const ChartPlan& plan, const Chart& chart);

/// What the terminal shows.
std::string to_table(const ChartPlan& plan, const Chart& chart);

/// Writes exact/chart/plot.py and its figures to the directory, which holds chart.json. Fails with Exit::resources
/// where there is no Python with matplotlib.
void plot(const std::string& directory);

}  // namespace tribunal
