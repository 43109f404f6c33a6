// A chart as JSON, and as a table for the terminal.
#include "exact/chart/chart.h"

#include <algorithm>
#include <cstdio>

#include "exact/base/json.h"
#include "exact/certificate/bounds.h"
#include "exact/certificate/rate.h"
#include "exact/chart/timing_json.h"
#include "exact/methods/methods.h"
#include "exact/record/contract_json.h"
#include "exact/record/environment.h"
#include "exact/record/errors_json.h"

namespace tribunal {
namespace {

/// The methods, with what a drawing needs to know of them.
Json drawn_methods(const std::vector<Method>& methods) {
  Json rows = methods_json(methods);
  for (std::size_t i = 0; i < methods.size(); ++i) {
    const Method& m = methods[i];
    rows[i]["maker"] = name_of(maker_of(m));
    rows[i]["origin"] = maker_of(m) == Maker::added ? "plugin" : "built-in";
    rows[i]["certified"] = has_role(m, Role::flagship);
    rows[i]["yardstick"] = has_role(m, Role::yardstick);
  }
  return rows;
}

std::string_view name_of(Figure figure) {
  constexpr std::string_view names[] = {"main", "shares", "polygons"};
  return names[static_cast<int>(figure)];
}

Json panels_json(const Chart& chart) {
  Json rows = Json::array();
  for (const Panel& panel : chart.panels) {
    const Population& p = all_populations()[panel.population];
    const Makeup& made = panel.makeup;
    rows.push_back({{"population", p.key},
                    {"figure", name_of(p.figure)},
                    {"title", p.title},
                    {"about", p.about},
                    {"fmt", name_of(panel.format)},
                    {"percent_hits", p.percent_hits ? Json(*p.percent_hits) : Json()},
                    {"cases", made.cases},
                    {"hits", made.hits},
                    {"subnormal", made.subnormal},
                    {"by_stage",
                     {{"filter", made.by_stage[static_cast<std::size_t>(Stage::filter)]},
                      {"integers", made.by_stage[static_cast<std::size_t>(Stage::integers)]},
                      {"exact", made.by_stage[static_cast<std::size_t>(Stage::exact)]}}}});
  }
  return rows;
}

Json rows_json(const ChartPlan& plan, const Chart& chart) {
  Json rows = Json::array();
  for (const ChartRow& r : chart.rows) {
    rows.push_back({{"method", plan.methods[r.method].name},
                    {"population", all_populations()[r.population].key},
                    {"fmt", name_of(r.format)},
                    {"own_format", r.own_format},
                    {"answers", to_json(r.count)},
                    {"nanoseconds", timing_json(r.time)}});
    if (r.errors.hits > 0) rows.back()["errors"] = from_errors(r.errors);
  }
  return rows;
}

/// The row on cases of the method's own format.
const ChartRow* own_row(const Chart& chart, std::size_t method, std::size_t population) {
  for (const ChartRow& r : chart.rows) {
    if (r.own_format && r.method == method && r.population == population) return &r;
  }
  return nullptr;
}

/// 99 % of the errors of t are within so many ulps; nothing if there are none.
std::string ulps_cell(const ChartRow& r) {
  char text[24];
  std::snprintf(text, sizeof text, "%.3g", std::min(r.errors.t.bound_of(99), r.errors.t.most));
  return r.errors.t.measured() == 0 ? "" : text;
}

std::string cells_of(const ChartRow& r) {
  char text[180], spread[40], ratio[60] = "";
  const std::string unjudged =
      r.count.unsupported == 0 ? "" : std::to_string(100 * r.count.unsupported / r.count.asked) + " %";
  std::snprintf(spread, sizeof spread, "%.1f - %.1f", r.time.lower_quartile, r.time.upper_quartile);
  if (const std::optional<Median>& q = r.time.ratio) {
    std::snprintf(ratio, sizeof ratio, "%.2f (%.2f - %.2f)", q->value, q->lower, q->upper);
  }
  std::snprintf(text, sizeof text, " %8s %8.1f %18s %24s %20s %10s %10s", std::string(name_of(r.format)).c_str(),
                r.time.median, spread, ratio, to_text(r.count).c_str(), unjudged.c_str(), ulps_cell(r).c_str());
  return text;
}

}  // namespace

Json to_json(const ChartPlan& plan, const Chart& chart) {
  Json object;
  object["seed"] = plan.seed;
  object["cases"] = plan.cases;
  object["yardstick"] = yardstick_method().name;
  object["confidence"] = 1 - confidence_alpha;
  object["methods"] = drawn_methods(plan.methods);
  object["panels"] = panels_json(chart);
  object["rows"] = rows_json(plan, chart);
  object["speed_pairs"] = timed_pairs;
  object["speed"] = to_json(chart.speed);
  object["environment"] = environment();
  return object;
}

std::string to_table(const ChartPlan& plan, const Chart& chart) {
  std::string text = "yardstick: " + yardstick_method().name + ", timed beside\n\n";
  char line[200];
  for (std::size_t p = 0; p < all_populations().size(); ++p) {
    const Population& population = all_populations()[p];
    text += std::string(population.title) + ": " + std::string(population.about) + "\n";
    std::snprintf(line, sizeof line, "  %-22s %8s %8s %18s %24s %20s %10s %10s\n", "method", "cases", "ns/test",
                  "quartiles", "x yardstick (95 %)", "wrong", "not judged", "t, ulps");
    text += line;
    for (std::size_t m = 0; m < plan.methods.size(); ++m) {
      const ChartRow* row = own_row(chart, m, p);
      if (row == nullptr) continue;
      std::snprintf(line, sizeof line, "  %-22s", plan.methods[m].name.c_str());
      text += line + cells_of(*row) + "\n";
    }
    text += "\n";
  }
  return text + to_table(chart.speed);
}

}  // namespace tribunal
