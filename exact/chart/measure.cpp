#include <algorithm>
#include <map>

#include "exact/base/interrupt.h"
#include "exact/chart/chart.h"
#include "exact/chart/errors.h"
#include "exact/chart/pairs.h"
#include "exact/classes/class_table.h"
#include "exact/methods/methods.h"

namespace tribunal {
namespace {

std::vector<Panel> panels_of(std::span<const Population> populations) {
  std::vector<Panel> panels;
  for (std::size_t p = 0; p < populations.size(); ++p) {
    for (const Format format : {Format::binary32, Format::binary64}) panels.push_back({p, format});
  }
  return panels;
}

// --- accuracy -------------------------------------------------------------------------------------------------------

using PanelCounts = std::map<std::pair<std::size_t, std::size_t>, Count>;  ///< by panel and index of the method

/// Judges all panels with these operands, and those methods that take them.
void judge_panels(const ChartPlan& plan, const std::vector<Panel>& panels, Operands operands, PanelCounts& counts) {
  std::vector<std::size_t> asked, at;
  FuzzPlan judging{.methods = {}, .streams = {}, .seed = plan.seed, .threads = plan.threads, .label = "chart"};
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const Population& population = all_populations()[panels[i].population];
    if (population.family.operands != operands) continue;
    judging.streams.push_back({&population.family, panels[i].format});
    at.push_back(i);
  }
  const Population& any = all_populations()[panels[at.front()].population];
  for (std::size_t m = 0; m < plan.methods.size(); ++m) {
    if (!takes(plan.methods[m], any)) continue;
    judging.methods.push_back(plan.methods[m]);
    asked.push_back(m);
  }
  if (asked.empty()) return;
  judging.cases = plan.cases * judging.streams.size();
  const FuzzReport report = fuzz(judging);
  fail_if_interrupted("no chart written");
  report.counts.for_each([&](const Cell& c, const Count& count) { counts[{at[c.stream], asked[c.method]}] += count; });
}

// --- time -----------------------------------------------------------------------------------------------------------

/// The cases of a panel, kept for as long as they are timed.
std::vector<Query> queries_of(const Panel& panel, const ChartPlan& plan) {
  std::vector<Query> queries;
  for (std::uint64_t k = 0; k < plan.cases; ++k) {
    queries.push_back(all_populations()[panel.population].family.make(panel.format, plan.seed, k).query);
  }
  return queries;
}

std::vector<SegmentPair> pairs_of(const std::vector<Query>& queries) {
  std::vector<SegmentPair> pairs;
  for (const Query& q : queries) pairs.push_back({std::get<Segment>(q.probe), q.triangle()});
  return pairs;
}

/// Polygons are prepared before the clock runs, as whoever asks about them more than once does.
TimedTest polygon_test(const Method& method, const std::vector<Query>& queries) {
  return [&method, &queries](std::size_t first, std::size_t count) -> NativeRun {
    std::vector<PreparedPolygon> prepared;
    for (std::size_t i = 0; i < count; ++i) prepared.push_back(method.polygon(queries[first + i].polygon()));
    return [prepared, &queries, first](std::span<std::uint8_t> hits, std::size_t step) {
      visit_by_steps(hits.size(), step, [&](std::size_t i) {
        const Probe& probe = queries[first + i].probe;
        const Segment* const s = std::get_if<Segment>(&probe);
        hits[i] = s != nullptr ? prepared[i].segment(*s).hit : prepared[i].ray(std::get<Ray>(probe)).hit;
      });
    };
  };
}

/// The tests of a panel, the yardstick first, and for each row the index of its test. The yardstick among the methods
/// is not timed twice.
struct PanelTests {
  std::vector<TimedTest> tests{};
  std::vector<std::size_t> of_row{};
};

PanelTests tests_of(const std::vector<Method>& methods, const std::vector<ChartRow>& rows,
                    const std::vector<Query>& queries, const std::vector<SegmentPair>& pairs) {
  PanelTests panel{{timed_test(single_loop(yardstick_method()), pairs)}};
  const bool of_polygons = queries.front().operands() == Operands::polygons;
  for (const ChartRow& row : rows) {
    const Method& method = methods[row.method];
    const bool is_yardstick = !of_polygons && method.name == yardstick_method().name;
    panel.of_row.push_back(is_yardstick ? 0 : panel.tests.size());
    if (is_yardstick) continue;
    panel.tests.push_back(of_polygons ? polygon_test(method, queries) : timed_test(single_loop(method), pairs));
  }
  return panel;
}

/// The rows of one panel, their counts still empty. The yardstick's loop runs beside, on the same triangles, or, where
/// these are polygons, on random ones.
std::vector<ChartRow> timed_rows(const ChartPlan& plan, const Panel& panel) {
  const Population& population = all_populations()[panel.population];
  std::vector<ChartRow> rows;
  for (std::size_t m = 0; m < plan.methods.size(); ++m) {
    const Method& method = plan.methods[m];
    if (!takes(method, panel.format) || !takes(method, population)) continue;
    rows.push_back({m, panel.population, panel.format, method.contract.format == panel.format, {}, {}});
  }
  if (rows.empty()) return rows;
  const std::vector<Query> queries = queries_of(panel, plan);
  const std::vector<SegmentPair> pairs = population.of_polygons() ? random_pairs(queries.size(), 7) : pairs_of(queries);
  const PanelTests timed = tests_of(plan.methods, rows, queries, pairs);
  const std::vector<Timing> times = time_stretches(
      timed.tests, {.cases = pairs.size(), .round = class_count, .repetitions = plan.repetitions, .yardstick = 0});
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i].time = times[timed.of_row[i]];
  return rows;
}

void add_errors(const ChartPlan& plan, const Panel& panel, std::vector<ChartRow>& rows) {
  const Population& population = all_populations()[panel.population];
  if (population.figure != Figure::main) return;
  const std::vector<HitErrors> errors =
      errors_on(population, panel.format, plan.seed, std::min(plan.cases, most_measured), plan.methods);
  for (ChartRow& row : rows) row.errors = errors[row.method];
}

}  // namespace

Chart measure(const ChartPlan& plan) {
  Chart chart;
  chart.panels = panels_of(all_populations());
  PanelCounts counts;
  for (const Operands o : {Operands::triangles, Operands::polygons}) judge_panels(plan, chart.panels, o, counts);
  for (std::size_t i = 0; i < chart.panels.size(); ++i) {
    Panel& panel = chart.panels[i];
    panel.makeup = makeup_of(all_populations()[panel.population], panel.format, plan.seed, plan.cases, plan.threads);
    std::vector<ChartRow> rows = timed_rows(plan, panel);
    add_errors(plan, panel, rows);
    for (ChartRow& row : rows) row.count = counts[{i, row.method}];
    chart.rows.insert(chart.rows.end(), rows.begin(), rows.end());
  }
  chart.speed = measure_speed(plan.methods, plan.repetitions);
  return chart;
}

}  // namespace tribunal
