#include <algorithm>
#include <cstdio>
#include <deque>
#include <map>
#include <memory>

#include "exact/base/failure.h"
#include "exact/base/files.h"
#include "exact/base/interrupt.h"
#include "exact/base/output.h"
#include "exact/base/progress.h"
#include "exact/base/record.h"
#include "exact/cases/own/family.h"
#include "exact/cli/command.h"
#include "exact/cli/fuzz_relations.h"
#include "exact/record/checkpoint.h"
#include "exact/record/contract_json.h"
#include "exact/record/counterexample.h"
#include "exact/record/data_record.h"
#include "exact/record/environment.h"
#include "exact/record/errors_json.h"
#include "exact/record/plainest.h"
#include "exact/record/sample_row.h"
#include "exact/trial/coverage.h"

namespace tribunal {
namespace {

struct Options {
  std::string methods, families, out, cases, mesh, scene;
  std::uint64_t seed = 1, count = 0;
  double seconds = 0;
  unsigned threads = 1;
  std::size_t keep = 20;
  bool relations = false, resume = false, until_first = false;
};

/// Asked if no method is named and there is no plugin.
constexpr const char* default_methods = "sf-double";

/// The default is so many that each of one's own cases is asked as it stands.
std::uint64_t cases_of(const Options& o, const std::vector<Stream>& streams) {
  constexpr std::uint64_t default_cases = 500'000, no_limit = std::uint64_t{1} << 40;
  if (o.count > 0 || o.seconds > 0) return o.count > 0 ? o.count : no_limit;
  std::uint64_t cases = default_cases;
  for (const Stream& s : streams) {
    if (s.family->data) cases = std::max<std::uint64_t>(cases, 2 * s.family->data->items * streams.size());
  }
  return cases;
}

FuzzPlan plan_of(const Options& o, std::vector<Stream> streams) {
  FuzzPlan plan{.methods = methods_on_trial(o.methods, default_methods),
                .streams = std::move(streams),
                .seed = o.seed,
                .seconds = o.seconds,
                .threads = o.threads,
                .until_first = o.until_first};
  plan.cases = cases_of(o, plan.streams);
  plan.quick = quick_class_for(plan.methods, plan.operands());
  return plan;
}

struct Row {
  std::size_t method, stream;
  auto operator<=>(const Row&) const = default;
};

/// By method × stream; what becomes of answers along an axis is the business of a sweep.
std::map<Row, Count> rows_of(const FuzzReport& report) {
  std::map<Row, Count> rows;
  report.counts.for_each([&](const Cell& c, const Count& count) { rows[{c.method, c.stream}] += count; });
  return rows;
}

Coverage coverage_of(const FuzzPlan& plan, const FuzzReport& report, std::size_t method) {
  Coverage coverage;
  report.counts.for_each([&](const Cell& c, const Count& count) {
    if (c.method == method) coverage.add(plan.streams[c.stream].format, c.slot, count);
  });
  return coverage;
}

std::string coverage(const FuzzPlan& plan, const FuzzReport& report) {
  const std::string what = plan.operands() == Operands::triangles ? "classes judged  " : "judged  ";
  std::string text;
  for (std::size_t m = 0; m < plan.methods.size(); ++m) {
    const Method& method = plan.methods[m];
    text += what + method.name + ": " + coverage_of(plan, report, m).to_text(method.stages) + "\n";
  }
  return text;
}

std::string table(const FuzzPlan& plan, const FuzzReport& report) {
  const int width = plan.operands() == Operands::triangles ? 9 : 17;
  std::string text;
  char line[200];
  std::snprintf(line, sizeof line, "%-22s %-*s %-9s %12s %10s  %-10s  %s\n", "method", width, "family", "format",
                "judged", "wrong", "share", "of these");
  text += line;
  for (const auto& [row, count] : rows_of(report)) {
    const Stream& s = plan.streams[row.stream];
    const double share =
        count.judged() == 0 ? 0 : static_cast<double>(count.wrong) / static_cast<double>(count.judged());
    std::snprintf(line, sizeof line, "%-22s %-*s %-9s %12llu %10llu  %8.4f %%", plan.methods[row.method].name.c_str(),
                  width, std::string(s.family->name).c_str(), std::string(name_of(s.format)).c_str(),
                  static_cast<unsigned long long>(count.judged()), static_cast<unsigned long long>(count.wrong),
                  100 * share);
    const std::string of_these = breakdown(count);
    text += line + (of_these.empty() ? "" : "  " + of_these) + "\n";
  }
  return text;
}

std::string errors_cells(const char* what, const Ulps& u) {
  return u.all() == 0 ? "" : "  " + std::string(what) + ": " + in_words(u);
}

/// The errors of a method in one format, and the families that they are of: "plain", or "3 families".
struct ErrorsInFormat {
  HitErrors errors{};
  std::string families{};
};

ErrorsInFormat errors_in(const FuzzPlan& plan, const FuzzReport& report, std::size_t method, Format format) {
  ErrorsInFormat sum;
  std::size_t count = 0;
  for (std::size_t s = 0; s < plan.streams.size(); ++s) {
    const HitErrors& e = report.errors[plan.errors_at(method, s)];
    if (plan.streams[s].format != format || e.hits == 0) continue;
    sum.errors += e;
    sum.families = ++count == 1 ? std::string(plan.streams[s].family->name) : std::to_string(count) + " families";
  }
  return sum;
}

/// The errors of the numbers given with right hits of rays, a line for each method and format: what each family has,
/// summary.json says.
std::string errors_table(const FuzzPlan& plan, const FuzzReport& report) {
  std::string text;
  char line[200];
  for (std::size_t m = 0; m < plan.methods.size(); ++m) {
    for (const Format format : {Format::binary64, Format::binary32}) {
      const auto [errors, families] = errors_in(plan, report, m, format);
      if (errors.hits == 0) continue;
      std::snprintf(line, sizeof line, "%-22s %-9s %-9s", plan.methods[m].name.c_str(), families.c_str(),
                    std::string(name_of(format)).c_str());
      text += line + errors_cells("t", errors.t) + errors_cells("weights", errors.weights) + "\n";
    }
  }
  if (text.empty()) return "";
  return "errors of numbers in ulps of the exact value, of right hits of rays, one case in " +
         std::to_string(measured_period) + "; by family in --out DIR:\n" + text;
}

Json errors_json(const FuzzPlan& plan, const FuzzReport& report) {
  Json rows = Json::array();
  for (std::size_t m = 0; m < plan.methods.size(); ++m) {
    for (std::size_t s = 0; s < plan.streams.size(); ++s) {
      const HitErrors& e = report.errors[plan.errors_at(m, s)];
      if (e.hits == 0) continue;
      rows.push_back({{"method", plan.methods[m].name},
                      {"family", plan.streams[s].family->name},
                      {"fmt", name_of(plan.streams[s].format)}});
      rows.back().update(from_errors(e));
    }
  }
  return {{"one_case_in", measured_period}, {"counts", rows}};
}

/// The worst of each method, first of all; formats apart.
std::string verdicts(const FuzzPlan& plan, const FuzzReport& report) {
  std::map<std::pair<std::size_t, Format>, Count> totals;
  report.counts.for_each([&](const Cell& c, const Count& count) {
    totals[{c.method, plan.streams[c.stream].format}] += count;
  });
  std::string text;
  for (std::size_t m = 0; m < plan.methods.size(); ++m) {
    std::vector<Counted> counts;
    for (const Format format : {Format::binary64, Format::binary32}) {
      if (const Count& total = totals[{m, format}]; total.asked > 0)
        counts.push_back({std::string(name_of(format)), total});
    }
    text += plan.methods[m].name + ": " + headline(counts) + "\n";
  }
  return text + "\n";
}

/// Who said the exact answers, and how many of them the oracles checked.
std::string judged_by(const FuzzPlan& plan, const FuzzReport& report) {
  const std::string oracles = oracles_of(plan.operands());
  if (plan.operands() == Operands::polygons) return oracles;
  const std::string by = plan.quick ? "signs certified one way" : formulations_in_words();
  return "construction where a family knows the class, else by " + by + "; " + std::to_string(report.audited) +
         " cases, drawn by a hash, also by all of: " + oracles + "; all agreed";
}

Json coverage_json(const FuzzPlan& plan, const FuzzReport& report) {
  Json object = Json::object();
  for (std::size_t m = 0; m < plan.methods.size(); ++m) {
    object[plan.methods[m].name] = coverage_of(plan, report, m).to_text(plan.methods[m].stages);
  }
  return object;
}

/// One kind of fault of one method.
struct FaultRow {
  const Finding* first;
  std::size_t findings;
};

/// By method × fault, of the findings that are faults.
std::map<std::pair<std::size_t, Status>, FaultRow> faults_of(const FuzzReport& report) {
  std::map<std::pair<std::size_t, Status>, FaultRow> rows;
  for (const Finding& f : report.findings) {
    if (f.fault) ++rows.try_emplace({f.method, f.fault.kind}, FaultRow{&f, 0}).first->second.findings;
  }
  return rows;
}

std::string fault_lines(const FuzzPlan& plan, const FuzzReport& report) {
  std::string text;
  for (const auto& [key, row] : faults_of(report)) {
    const auto& [method, fault] = key;
    text += "FAULT: " + plan.methods[method].name + " " + std::string(fault_name(fault)) + ", in " +
            std::to_string(row.findings) + " of the findings; first on " + name_of(plan.streams[row.first->stream]) +
            " case " + std::to_string(row.first->k) + "\n";
  }
  return text;
}

Json faults_json(const FuzzPlan& plan, const FuzzReport& report) {
  Json rows = Json::array();
  for (const auto& [key, row] : faults_of(report)) {
    const auto& stream = plan.streams[row.first->stream];
    rows.push_back({{"method", plan.methods[key.first].name},
                    {"fault", fault_name(key.second)},
                    {"findings", row.findings},
                    {"family", stream.family->name},
                    {"fmt", name_of(stream.format)},
                    {"case", row.first->k}});
  }
  return rows;
}

/// Per method × family × format × class, or construction or outcome; nothing that varies from run to run.
Json summary(const FuzzPlan& plan, const FuzzReport& report) {
  const bool triangles = plan.operands() == Operands::triangles;
  std::map<std::tuple<std::size_t, std::size_t, Slot>, Count> cells;
  report.counts.for_each([&](const Cell& c, const Count& count) { cells[{c.method, c.stream, c.slot}] += count; });
  Json rows = Json::array();
  for (const auto& [key, count] : cells) {
    const auto& [method, stream, slot] = key;
    rows.push_back({{"method", plan.methods[method].name},
                    {"family", plan.streams[stream].family->name},
                    {"fmt", name_of(plan.streams[stream].format)},
                    {triangles ? "class" : "case", slot_name(slot)},
                    {"asked", count.asked},
                    {"wrong", count.wrong},
                    {"unsupported", count.unsupported}});
    if (count.wrong > 0 || count.refused > 0) rows.back().update(outcomes_of(count));
  }
  Json object = {{"seed", plan.seed},
                 {"cases", report.cases},
                 {"methods", methods_json(plan.methods)},
                 {"families", family_names_of(plan)}};
  if (const Json data = data_of(plan); !data.empty()) object["data"] = data;
  if (plan.until_first) object["until_first"] = true;
  object.update({{triangles ? "classes_judged" : "polygons_judged", coverage_json(plan, report)},
                 {"judged_by", judged_by(plan, report)},
                 {"audited", report.audited},
                 {"counts", rows},
                 {"errors", errors_json(plan, report)},
                 {"faults", faults_json(plan, report)},
                 {"environment", environment()}});
  return object;
}

/// The findings of each method that rank first, and the first of each kind of fault; shrinking may raise a rank.
std::vector<Case> counterexamples(const FuzzPlan& plan, const FuzzReport& report, std::size_t keep) {
  std::vector<Case> cases;
  std::vector<std::size_t> kept(plan.methods.size());
  const auto faults = faults_of(report);
  for (const Finding& f : report.findings) {
    fail_if_interrupted("no counterexamples written");
    const bool first_of_fault = f.fault && faults.at({f.method, f.fault.kind}).first == &f;
    if (kept[f.method]++ < keep || first_of_fault) cases.push_back(to_counterexample(plan, f));
  }
  sort_by_rank(cases);
  return cases;
}

FuzzReport run_plan(const Options& o, const FuzzPlan& plan) {
  if (o.out.empty()) return fuzz(plan);
  const UnbrokenEnd unbroken;  // until the checkpoint is saved
  make_directory(o.out);
  FuzzReport start = empty_report(plan);
  if (o.resume) {
    if (const auto saved = load_checkpoint(o.out, plan)) start = *saved;
    print("going on after " + std::to_string(start.cases) + " cases\n");
  } else if (exists(checkpoint_path(o.out))) {
    throw Failure(Exit::usage,
                  checkpoint_path(o.out) + " is of an interrupted run: --resume goes on with it, or remove it");
  }
  return fuzz(plan, start, [&](const FuzzReport& report) { save_checkpoint(o.out, plan, report); });
}

/// "mine.jsonl, 12 cases; left out: 1 of polygons"
std::string in_words(const Record& file) {
  const std::string text = file.text("file") + ", " + std::to_string(file.count("items")) + " used, SHA-256 " +
                           file.text("sha256").substr(0, 16) + "…";
  return file.has("left_out") ? text + "; not used: " + file.text("left_out") : text;
}

std::string totals(const FuzzPlan& plan, const FuzzReport& report) {
  std::string text = std::to_string(report.cases) + " cases, seed " + std::to_string(plan.seed);
  if (report.seconds > 0) {
    text += "; " + compact(static_cast<double>(report.run_here)) + " in " + compact(report.seconds) + " s, " +
            compact(static_cast<double>(report.run_here) / report.seconds) + "/s";
  }
  text += "\n";
  const Json data = data_of(plan);
  for (const Record& file : Record(data, {"data"}).items()) text += file.text("family") + ": " + in_words(file) + "\n";
  return text + "judged by " + judged_by(plan, report) + "\n";
}

void write_findings(const Options& o, const FuzzPlan& plan, const FuzzReport& report) {
  const auto cases = counterexamples(plan, report, o.keep);
  OutputSet set;
  set.add(o.out + "/counterexamples.jsonl", to_lines(cases));
  set.add(o.out + "/summary.json", summary(plan, report).dump(1) + "\n");
  set.commit();
  remove_tree(checkpoint_path(o.out));
  print(std::to_string(cases.size()) + " counterexamples in " + o.out + "/counterexamples.jsonl" +
        (cases.empty() ? "" : "; `tribunal replay` shows them") + "\n");
}

/// The finding that ranks first of all, or the first, shrunk, for the terminal.
std::string plainest(const FuzzPlan& plan, const FuzzReport& report) {
  if (report.findings.empty()) return plan.until_first ? "no finding\n" : "";
  const Finding& f = *std::ranges::min_element(report.findings, {}, &Finding::rank);
  const Method& method = plan.methods[f.method];
  const Case c = to_counterexample(plan, f);
  const std::string first =
      "the first finding, case " + std::to_string(f.k) + " of " + name_of(plan.streams[f.stream]) + ", shrunk, ";
  return (plan.until_first ? first : "the plainest counterexample, ") + in_words(f.outcome, f.severity, f.cause) +
         ":\n" + counterexample_in_words(method, c) + "\n";
}

/// A method of which no answer was judged has not been tried, and that is no success.
void require_judged(const FuzzPlan& plan, const FuzzReport& report) {
  std::vector<std::uint64_t> judged(plan.methods.size());
  report.counts.for_each([&](const Cell& c, const Count& count) { judged[c.method] += count.judged(); });
  for (std::size_t m = 0; m < judged.size(); ++m) {
    if (judged[m] > 0) continue;
    throw Failure(Exit::usage, plan.methods[m].name + ": nothing was judged; of " + std::to_string(report.cases) +
                                   " cases it refused all, or owes them no answer (" +
                                   in_words(plan.methods[m].contract) + ")");
  }
}

/// What is left to do of a run whose cases are done. Fails with 128 + signal if one asks for an end before the results
/// are written.
int finish(const Options& o, const FuzzPlan& plan, const FuzzReport& report, bool stopped) {
  const std::string first = plainest(plan, report);
  if (!o.out.empty()) write_findings(o, plan, report);
  print(first);
  if (!stopped) require_judged(plan, report);
  return code(report.findings.empty() ? Exit::ok : Exit::disagreement);
}

int run(const Options& o, const FuzzPlan& plan) {
  if (o.relations) return run_relations(plan, o.out);
  const OrderlyEnd orderly;  // a signal is answered by what was found so far
  FuzzReport report = run_plan(o, plan);
  if (report.cases == 0) fail_if_interrupted("no case was run");
  if (report.cases == 0) throw Failure(Exit::resources, "no case was run");
  ask_again(plan, report);
  const bool stopped = o.until_first && !report.findings.empty();
  const std::string counts =
      verdicts(plan, report) + table(plan, report) + coverage(plan, report) + errors_table(plan, report);
  print((stopped ? "" : counts) + fault_lines(plan, report) + totals(plan, report));
  try {
    if (is_complete(plan, report)) return finish(o, plan, report, stopped);
  } catch (const Failure& failure) {
    if (code(failure.exit()) != 128 + interrupted()) throw;
  }
  print("INTERRUPTED after " + std::to_string(report.cases) + " of " + std::to_string(plan.cases) + " cases" +
        (o.out.empty() ? "" : "; the same command with --resume goes on") + "\n");
  return 128 + interrupted();
}

/// The families that are asked, with those that are made of the user's own data. The streams point into it.
struct Sources {
  std::deque<OwnFamily> own{};
  std::vector<Stream> streams{};

  void add(const OwnData& data) {
    const OwnFamily& added = own.emplace_back(family_of(data));
    for (const Format format : added.formats) streams.push_back({&added.family, format});
  }
};

/// What cases of one's own must be about: what the families named are about.
std::optional<Operands> operands_wanted(const Options& o, const std::vector<Stream>& named) {
  const bool triangles = !o.mesh.empty() || !o.scene.empty();
  if (named.empty()) return triangles ? std::optional(Operands::triangles) : std::nullopt;
  const Operands operands = named.front().family->operands;
  if (triangles && operands == Operands::polygons) {
    throw Failure(Exit::usage, "--mesh and --scene ask about triangles, and family " +
                                   std::string(named.front().family->name) + " about polygons: ask for it apart");
  }
  return operands;
}

/// Own data alone, unless families are named too.
Sources sources_of(const Options& o, ReadScene read_scene) {
  const bool own = !o.cases.empty() || !o.mesh.empty() || !o.scene.empty();
  Sources sources;
  if (!own || !o.families.empty()) sources.streams = streams_named(o.families);
  const auto wanted = operands_wanted(o, sources.streams);
  if (!o.cases.empty()) sources.add(read_own_cases(o.cases, wanted));
  if (!o.mesh.empty()) sources.add(read_own_mesh(o.mesh));
  if (!o.scene.empty()) sources.add(read_scene(o.scene));
  return sources;
}

int run(const Options& o, ReadScene read_scene) {
  const Sources sources = sources_of(o, read_scene);
  const FuzzPlan plan = plan_of(o, sources.streams);
  if (plan.operands() == Operands::polygons) std::ranges::for_each(plan.methods, require_polygons);
  return run(o, plan);
}

}  // namespace

Action declare_fuzz(Arguments& arguments, ReadScene read_scene) {
  const auto o = std::make_shared<Options>();
  add_methods_option(arguments, o->methods, default_methods);
  arguments.option("--family", o->families, family_help());
  arguments.option("--cases", o->cases,
                   "case file of your own (- is standard input): hunt from its cases, as they are and changed by ulps, "
                   "snapped, flipped, aimed; without --family from them alone. "
                   "Example: tribunal fuzz --cases mine.jsonl --method sf-double --until-first");
  arguments.option("--mesh", o->mesh,
                   "mesh of your own (OFF, OBJ, PLY, STL): hunt from its triangles, with probes aimed at them");
  arguments.option("--scene", o->scene,
                   "scene of your own: hunt from the rays of its camera and of what it shades, and the triangles near");
  arguments.option("--seed", o->seed, "seed of the cases").shows_default();
  arguments.option("--count", o->count, "cases in all (default 500000)").above_zero();
  arguments.option("--seconds", o->seconds, "run for a time instead").above_zero();
  arguments.excludes("--seconds", "--count");
  add_threads_option(arguments, o->threads);
  arguments.option("--out", o->out, "directory for summary.json and counterexamples.jsonl");
  arguments.flag("--resume", o->resume, "go on with an interrupted run of the same plan in --out");
  arguments.needs("--resume", "--out");
  arguments.option("--keep", o->keep, "counterexamples to shrink and write, a method").shows_default();
  arguments.flag("--relations", o->relations, "check relations between answers instead: no oracle is asked");
  arguments.excludes("--relations", "--seconds");
  arguments.flag("--until-first", o->until_first,
                 "stop at the first finding and print it: the one with the lowest case number, whatever the threads");
  arguments.excludes("--until-first", "--relations");
  return with_plugins(arguments, [o, read_scene] { return run(*o, read_scene); });
}

}  // namespace tribunal
