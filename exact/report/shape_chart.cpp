// What chart.json, compilers.json and the JSON of a benchmark must look like.
#include <set>
#include <string>

#include "exact/report/shapes.h"

namespace tribunal {
namespace {

using namespace shape;

/// More than a quarter of an hour for one question, in nanoseconds, was never measured.
constexpr double most_time = 1e12;

/// {"median", "lower", "upper"}, the bounds where there are some.
Check median(double most) {
  return object(
      {needed("median", number(0, most)), if_there("lower", number(0, most)), if_there("upper", number(0, most))},
      [](const Record& r) {
        const double m = r.number("median");
        if (r.has("lower") && r.number("lower") > m) r.fail_at("lower", "is above the median");
        if (r.has("upper") && r.number("upper") < m) r.fail_at("upper", "is below the median");
      });
}

/// A spread of times.
Check timing() {
  constexpr const char* in_order[] = {"min", "lower_quartile", "median", "upper_quartile", "max"};
  std::vector<Member> members{if_there("batch", count()), if_there("stretches", count()),
                              if_there("repetitions", count()), if_there("ratio", median(most_time))};
  for (const char* key : in_order) members.push_back(needed(key, number(0, most_time)));
  return object(members, [=](const Record& r) {
    double before = 0;
    for (const char* key : in_order) {
      const double time = r.number(key);
      if (time < before) r.fail_at(key, "is below the figure before it, expected a spread in order");
      before = time;
    }
  });
}

Check panel() {
  return object(
      {needed("population", name()), needed("title", text()), needed("fmt", format()), if_there("about", text()),
       if_there("figure", text()), if_there("percent_hits", null_or(count(100))), if_there("cases", count()),
       if_there("hits", count()), if_there("subnormal", count()), if_there("by_stage", named(count()))},
      [](const Record& r) {
        if (!r.has("cases")) return;
        const std::uint64_t cases = r.count("cases");
        for (const char* key : {"hits", "subnormal"}) require_part(r, r.count_or(key, 0), cases, key);
        if (const auto stages = r.find("by_stage")) {
          for (const auto& [stage, n] : stages->members()) require_part(r, n.count(), cases, stage.c_str());
        }
      });
}

Check row() {
  return object({needed("method", name()), needed("population", name()), needed("fmt", format()),
                 if_there("own_format", truth()), if_there("answers", answers()), if_there("nanoseconds", timing()),
                 if_there("errors", errors())});
}

Check speed() {
  return object({needed("method", name()), if_there("probe", null_or(text())), if_there("call", text()),
                 if_there("nanoseconds", null_or(timing())), if_there("nothing", truth()),
                 if_there("bytes", null_or(count())), if_there("percent_hits", null_or(count(100)))});
}

Check picture() {
  return object({needed("method", name()), needed("fmt", format()), needed("pixels", count()), needed("wrong", count()),
                 if_there("other_start", count()), if_there("not_owed", count()), if_there("rays", count()),
                 if_there("repetitions", count()), if_there("rays_per_second", median(1e15))},
                [](const Record& r) {
                  const std::uint64_t pixels = r.count("pixels"), wrong = r.count("wrong");
                  require_share(r, wrong, pixels);
                  for (const char* key : {"other_start", "not_owed"}) {
                    require_part(r, r.count_or(key, 0), pixels - wrong, key);
                  }
                });
}

Check leaks() {
  const Check of_method = object({needed("method", name()), needed("fmt", format()), needed("rays", count()),
                                  needed("leaks", count()), needed("share", share()), needed("upper", share())},
                                 [](const Record& r) { require_share(r, r.count("leaks"), r.count("rays")); });
  return object({needed("mesh", text()), needed("rows", list(of_method))});
}

Check onset() {
  return object(
      {needed("method", name()), needed("fmt", format()), needed("bits", count(64)), if_there("answers", answers())});
}

/// No more cases than the record says that there were, of each population and format.
void require_within_cases(const Record& r) {
  if (!r.has("cases")) return;
  const std::uint64_t cases = r.count("cases");
  for (const Record& panel : r.items("panels")) require_part(panel, panel.count_or("cases", 0), cases, "cases");
  for (const Record& row : r.items("rows")) {
    if (const auto given = row.find("answers")) require_part(*given, given->count("asked"), cases, "asked");
    if (const auto given = row.find("errors")) require_part(*given, given->count("hits"), cases, "hits");
  }
}

/// Whoever is drawn is in the list of methods.
void require_known_methods(const Record& r) {
  std::set<std::string> known;
  for (const Record& m : r.items("methods")) known.insert(m.text("name"));
  const auto require_known = [&](const std::vector<Record>& rows) {
    for (const Record& row : rows) {
      if (!known.contains(row.text("method"))) row.fail_at("method", "is none of \"methods\"");
    }
  };
  require_known(r.items("rows"));
  require_known(r.items_or_none("onset"));
  for (const char* part : {"pictures", "leaks"}) {
    if (const auto found = r.find(part)) require_known(found->items("rows"));
  }
}

Check build() { return object({needed("name", name()), needed("compiler", text()), needed("flags", text())}); }

Check build_row() {
  return object({needed("method", name()), needed("build", name()), needed("fmt", format()),
                 needed("answers", answers()), needed("changed", count()), needed("spoiled", count()),
                 needed("mended", count()), if_there("case", null_or(text()))},
                [](const Record& r) {
                  require_part(r, r.count("changed"), r.member("answers").count("asked"), "changed");
                  require_part(r, r.count("spoiled"), r.count("changed"), "spoiled");
                  require_part(r, r.count("mended"), r.count("changed") - r.count("spoiled"), "mended");
                });
}

}  // namespace

void require_chart_record(const Record& record) {
  static const Check shape =
      object({needed("methods", list(method())), needed("panels", list(panel())), needed("rows", list(row())),
              needed("speed", list(speed())), if_there("seed", whole()), if_there("cases", count()),
              if_there("yardstick", text()), if_there("confidence", share()), if_there("speed_pairs", count()),
              if_there("onset", list(onset())), if_there("command", command()), if_there("environment", environment()),
              if_there("pictures", object({needed("rows", list(picture())), if_there("scenes", list(text()))})),
              if_there("leaks", leaks())},
             [](const Record& r) {
               require_within_cases(r);
               require_known_methods(r);
             });
  shape(record);
}

void require_compilers_record(const Record& record) {
  static const Check shape =
      object({needed("builds", list(build())), needed("rows", list(build_row())), if_there("seed", whole()),
              if_there("cases_of_each_format", count()), if_there("environment", environment())},
             [](const Record& r) {
               if (!r.has("cases_of_each_format")) return;
               for (const Record& row : r.items("rows")) {
                 require_part(row, row.member("answers").count("asked"), r.count("cases_of_each_format"), "asked");
               }
             });
  shape(record);
}

/// What Google Benchmark writes has more members, which the page does not show.
void require_bench_record(const Record& record) {
  constexpr double most = 1e18;
  static const Check one = object({needed("name", text()), if_there("run_type", text()),
                                   if_there("aggregate_name", text()), if_there("time_unit", text()),
                                   if_there("real_time", number(0, most)), if_there("cpu_time", number(0, most))});
  static const Check shape =
      object({needed("context", object({if_there("num_cpus", count(1u << 20))})), needed("benchmarks", list(one))});
  shape(record);
}

}  // namespace tribunal
