// Speed and accuracy of methods, measured on the same cases.
#pragma once

#include <string>
#include <vector>

#include "exact/base/json_fwd.h"
#include "exact/chart/makeup.h"
#include "exact/chart/populations.h"
#include "exact/chart/speed.h"
#include "exact/chart/timing.h"

namespace tribunal {

struct ChartPlan {
  std::vector<Method> methods;
  std::uint64_t seed = 1;
  std::uint64_t cases = 65'200;  ///< of each population and format, judged and timed: 400 rounds of the 163 classes
  int repetitions = 31;
  unsigned threads = 1;  ///< for judging; time is taken on one thread
};

/// Rays of each population and format whose hits are measured.
inline constexpr std::uint64_t most_measured = 8'000;

/// One method on the cases of one population in one format.
struct ChartRow {
  std::size_t method, population;
  Format format;
  bool own_format;  ///< the cases have the method's own format
  Count count;
  Timing time;
  HitErrors errors{};  ///< of its numbers, on rays through the segments of the first `most_measured` cases
};

/// The cases of one population in one format.
struct Panel {
  std::size_t population;
  Format format;
  Makeup makeup{};
};

struct Chart {
  std::vector<Panel> panels;
  std::vector<ChartRow> rows;
  std::vector<SpeedRow> speed;
};

/// Counts are a function of methods, seed and cases; times are measured. Fails with 128 + signal if interrupted.
Chart measure(const ChartPlan& plan);

/// The part of chart.json that is about pairs, the methods with what a drawing needs to know of them, and the
/// environment.
Json to_json(const ChartPlan& plan, const Chart& chart);

/// What the terminal shows.
std::string to_table(const ChartPlan& plan, const Chart& chart);

/// Writes chart.json. The figures of an earlier one go.
void write_chart(const std::string& directory, const Json& record);

/// Writes exact/chart/plot.py and the figures to the directory, which holds chart.json; nothing is measured. Returns
/// the names of the figures that were drawn, without endings, and removes older ones of the other names. Fails as
/// `draw_figures` does.
std::vector<std::string> plot(const std::string& directory);

}  // namespace tribunal
