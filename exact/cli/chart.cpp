// tribunal chart: speed and accuracy on the same cases, as figures and as the numbers behind them.
#include "exact/chart/chart.h"

#include <algorithm>
#include <iterator>
#include <memory>
#include <vector>

#include "exact/base/failure.h"
#include "exact/base/files.h"
#include "exact/base/json.h"
#include "exact/cli/command.h"
#include "exact/methods/methods.h"

namespace tribunal {
namespace {

bool takes_segments(const Method& m) { return m.contract.triangles != Triangles::none && m.contract.probes.segments; }

/// Figures with all rivals cannot be read: of the methods with an exact twin only those with the role are drawn.
bool is_charted(const Method& m) {
  const std::vector<Role> roles = roles_of(m);
  return !has(m, Capability::exact_twin) || std::ranges::find(roles, Role::charted) != roles.end();
}

struct Options {
  std::string methods, out = "charts";
  ChartPlan plan;
};

ChartPlan plan_of(const Options& o) {
  ChartPlan plan = o.plan;
  if (o.methods.empty() || o.methods == "all") {
    std::ranges::copy_if(all_methods(), std::back_inserter(plan.methods),
                         [&](const Method& m) { return takes_segments(m) && (!o.methods.empty() || is_charted(m)); });
  } else {
    plan.methods = methods_named(o.methods);
  }
  for (const Method& m : plan.methods) {
    if (!takes_segments(m)) {
      throw Failure(Exit::usage, m.name + ": a chart asks segments and triangles, which it does not take (" +
                                     in_words(m.contract) + ")");
    }
  }
  return plan;
}

/// A method of which no answer was judged has no accuracy to draw.
void require_judged(const ChartPlan& plan, const Chart& chart) {
  for (std::size_t m = 0; m < plan.methods.size(); ++m) {
    const auto judged = [&](const ChartRow& row) { return row.method == m && row.count.judged() > 0; };
    if (std::ranges::any_of(chart.rows, judged)) continue;
    throw Failure(Exit::usage, plan.methods[m].name + ": nothing was judged, its contract owes an answer to no case");
  }
}

int run(const Options& o) {
  const ChartPlan plan = plan_of(o);
  make_directory(o.out);
  const Chart chart = measure(plan);
  require_judged(plan, chart);
  write_file(o.out + "/chart.json", to_json(plan, chart).dump(1) + "\n");
  print(to_table(plan, chart));
  plot(o.out);
  print("written: " + o.out + "/speed-accuracy.svg, onset.svg, speed.svg, the same as .png, chart.json, plot.py\n");
  return 0;
}

}  // namespace

Action declare_chart(Arguments& arguments) {
  const auto o = std::make_shared<Options>();
  arguments.option("--method,--methods", o->methods,
                   "methods, separated by commas, or all (default all but most rivals)");
  arguments.option("--seed", o->plan.seed, "seed of the cases").shows_default();
  arguments.option("--count", o->plan.cases, "cases judged, of each population and format")
      .above_zero()
      .shows_default();
  arguments.option("--repetitions", o->plan.repetitions, "times that every method is timed")
      .between(9, 10'000)
      .shows_default();
  add_threads_option(arguments, o->plan.threads);
  arguments.option("--out", o->out, "directory for the figures and chart.json").shows_default();
  return with_plugins(
      arguments, [o] { return run(*o); }, MayIsolate::no);
}

}  // namespace tribunal
