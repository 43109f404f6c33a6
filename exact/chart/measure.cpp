#include <algorithm>
#include <map>

#include "exact/base/failure.h"
#include "exact/base/interrupt.h"
#include "exact/chart/chart.h"
#include "exact/classes/class_table.h"
#include "exact/sweep/sweep.h"

namespace tribunal {
namespace {

/// Cases timed, of those judged: a multiple of the 163 classes that fits a second-level cache.
constexpr std::uint64_t most_timed_cases = class_count * 50;

/// At each length of the entries: whole rounds of the classes of segments and rays.
constexpr std::uint64_t onset_cases = all_class_count * 14;

void end_if_interrupted() {
  if (interrupted() != 0) throw Failure(static_cast<Exit>(128 + interrupted()), "interrupted; no chart written");
}

FuzzReport judged(const ChartPlan& plan, const std::vector<Stream>& streams, std::uint64_t cases_each,
                  FuzzPlan& judging) {
  judging = {.methods = plan.methods,
             .streams = streams,
             .seed = plan.seed,
             .cases = cases_each * streams.size(),
             .seconds = 0,
             .threads = plan.threads};
  FuzzReport report = fuzz(judging);
  end_if_interrupted();
  return report;
}

std::vector<Panel> panels_of(std::span<const Population> populations) {
  std::vector<Panel> panels;
  for (std::size_t p = 0; p < populations.size(); ++p) {
    for (const Format format : populations[p].formats) panels.push_back({p, format});
  }
  return panels;
}

std::vector<SegmentPair> timed_pairs(const Family& family, Format format, const ChartPlan& plan) {
  std::vector<SegmentPair> pairs;
  for (std::uint64_t k = 0; k < std::min(plan.cases, most_timed_cases); ++k) {
    const Query query = family.make(format, plan.seed, k).query;
    pairs.push_back({std::get<Segment>(query.probe), query.triangle()});
  }
  return pairs;
}

/// The rows of one panel, their counts still empty.
std::vector<ChartRow> timed_rows(const ChartPlan& plan, const Panel& panel) {
  const Population& population = all_populations()[panel.population];
  std::vector<ChartRow> rows;
  std::vector<NativeLoop> loops;
  for (std::size_t m = 0; m < plan.methods.size(); ++m) {
    const Method& method = plan.methods[m];
    if (!takes(method, panel.format)) continue;
    loops.push_back(single_loop(method));
    rows.push_back({m, panel.population, panel.format, drawn_format(population, method) == panel.format, {}, {}});
  }
  const std::vector<SegmentPair> pairs = timed_pairs(population.family, panel.format, plan);
  const std::vector<Timing> times = time_loops(loops, pairs, class_count, plan.repetitions);
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i].time = times[i];
  return rows;
}

/// Counts the hits of a stream, in the closed reading. All methods of a stream see the same cases, so one is enough.
void count_hits(Panel& panel, std::size_t stream, std::size_t method, const FuzzReport& report) {
  report.counts.for_each([&](const Cell& cell, const Count& count) {
    if (cell.stream != stream || cell.method != method) return;
    panel.cases += count.asked;
    if (class_row(static_cast<ClassId>(cell.slot)).hit()) panel.hits += count.asked;
  });
}

void measure_populations(const ChartPlan& plan, Chart& chart) {
  const std::span<const Population> populations = all_populations();
  chart.panels = panels_of(populations);
  std::vector<Stream> streams;
  for (const Panel& panel : chart.panels) streams.push_back({&populations[panel.population].family, panel.format});
  FuzzPlan judging;
  const FuzzReport report = judged(plan, streams, plan.cases, judging);
  std::map<std::pair<std::size_t, std::size_t>, Count> totals;
  report.counts.for_each([&](const Cell& c, const Count& count) { totals[{c.stream, c.method}] += count; });
  for (std::size_t s = 0; s < chart.panels.size(); ++s) {
    std::vector<ChartRow> rows = timed_rows(plan, chart.panels[s]);
    end_if_interrupted();
    for (ChartRow& row : rows) row.count = totals[{s, row.method}];
    if (!rows.empty()) count_hits(chart.panels[s], s, rows.front().method, report);
    chart.rows.insert(chart.rows.end(), rows.begin(), rows.end());
  }
}

/// The segments of the sweep along the axis of mantissa fill.
void measure_onset(const ChartPlan& plan, Chart& chart) {
  static const StressAxis fill = fill_axis();
  const SweepPlan sweeping{
      .methods = plan.methods, .axes = {&fill}, .seed = plan.seed, .cases = onset_cases, .threads = plan.threads};
  for (const auto& [place, c] : sweep(sweeping).counts) {
    if (place.probe != ProbeKind::segment) continue;
    const bool drawn = plan.methods[place.method].contract.format == place.format;
    chart.onset.push_back({place.method, place.format, drawn, place.value, c.count});
  }
}

}  // namespace

Chart measure(const ChartPlan& plan) {
  Chart chart;
  measure_populations(plan, chart);
  measure_onset(plan, chart);
  chart.speed = measure_speed(plan.methods, plan.repetitions);
  return chart;
}

}  // namespace tribunal
