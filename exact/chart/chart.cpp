// A chart as JSON, and as a table for the terminal.
#include "exact/chart/chart.h"

#include <cstdio>

#include "exact/base/json.h"
#include "exact/certificate/bounds.h"
#include "exact/certificate/rate.h"
#include "exact/chart/timing_json.h"
#include "exact/record/contract_json.h"
#include "exact/record/environment.h"
#include "exact/record/errors_json.h"

namespace tribunal {
namespace {

Json panels_json(const Chart& chart) {
  Json rows = Json::array();
  for (const Panel& panel : chart.panels) {
    const Population& p = all_populations()[panel.population];
    rows.push_back({{"population", p.key},
                    {"title", p.title},
                    {"about", p.about},
                    {"fmt", name_of(panel.format)},
                    {"cases", panel.cases},
                    {"hits", panel.hits}});
  }
  return rows;
}

Json rows_json(const ChartPlan& plan, const Chart& chart) {
  Json rows = Json::array();
  for (const ChartRow& r : chart.rows) {
    rows.push_back({{"method", plan.methods[r.method].name},
                    {"population", all_populations()[r.population].key},
                    {"fmt", name_of(r.format)},
                    {"drawn", r.drawn},
                    {"answers", to_json(r.count)},
                    {"nanoseconds", timing_json(r.time)}});
    if (r.errors.hits > 0) rows.back()["errors"] = from_errors(r.errors);
  }
  return rows;
}

Json onset_json(const ChartPlan& plan, const Chart& chart) {
  Json rows = Json::array();
  for (const OnsetRow& r : chart.onset) {
    rows.push_back({{"method", plan.methods[r.method].name},
                    {"fmt", name_of(r.format)},
                    {"drawn", r.drawn},
                    {"bits", r.bits},
                    {"answers", to_json(r.count)}});
  }
  return rows;
}

const ChartRow* drawn_row(const Chart& chart, std::size_t method, std::size_t population) {
  for (const ChartRow& r : chart.rows) {
    if (r.drawn && r.method == method && r.population == population) return &r;
  }
  return nullptr;
}

/// 99 % of the errors of t are within so many ulps; nothing if there are none.
std::string ulps_cell(const ChartRow& r) {
  char text[24];
  std::snprintf(text, sizeof text, "%.3g", r.errors.t.bound_of(99));
  return r.errors.t.measured() == 0 ? "" : text;
}

std::string cells_of(const ChartRow& r) {
  char text[140], spread[40];
  const std::string unjudged =
      r.count.unsupported == 0 ? "" : std::to_string(100 * r.count.unsupported / r.count.asked) + " %";
  std::snprintf(spread, sizeof spread, "%.1f - %.1f", r.time.lower_quartile, r.time.upper_quartile);
  std::snprintf(text, sizeof text, " %8s %8.1f %18s %20s %10s %10s", std::string(name_of(r.format)).c_str(),
                r.time.median, spread, to_text(r.count).c_str(), unjudged.c_str(), ulps_cell(r).c_str());
  return text;
}

}  // namespace

Json to_json(const ChartPlan& plan, const Chart& chart) {
  Json object;
  object["seed"] = plan.seed;
  object["cases"] = plan.cases;
  object["confidence"] = 1 - confidence_alpha;
  object["methods"] = methods_json(plan.methods);
  object["panels"] = panels_json(chart);
  object["rows"] = rows_json(plan, chart);
  object["onset"] = onset_json(plan, chart);
  object["speed"] = to_json(chart.speed);
  object["environment"] = environment();
  return object;
}

std::string to_table(const ChartPlan& plan, const Chart& chart) {
  std::string text;
  char line[160];
  for (std::size_t p = 0; p < all_populations().size(); ++p) {
    const Population& population = all_populations()[p];
    text += std::string(population.title) + ": " + std::string(population.about) + "\n";
    std::snprintf(line, sizeof line, "  %-22s %8s %8s %18s %20s %10s %10s\n", "method", "cases", "ns/test", "quartiles",
                  "wrong", "not judged", "t, ulps");
    text += line;
    for (std::size_t m = 0; m < plan.methods.size(); ++m) {
      const ChartRow* row = drawn_row(chart, m, p);
      if (row == nullptr) continue;
      std::snprintf(line, sizeof line, "  %-22s", plan.methods[m].name.c_str());
      text += line + cells_of(*row) + "\n";
    }
    text += "\n";
  }
  return text + to_table(chart.speed);
}

}  // namespace tribunal
