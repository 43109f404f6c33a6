#include "exact/report/report.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <set>

#include "exact/base/failure.h"
#include "exact/base/files.h"
#include "exact/base/foreign_json.h"
#include "exact/base/shown.h"
#include "exact/cases/family_table.h"
#include "exact/record/environment.h"
#include "exact/report/classes.h"
#include "exact/report/gathering.h"

namespace tribunal {
namespace {

namespace fs = std::filesystem;

std::string no_cases(const Run&) { return ""; }
std::string counterexamples(const Run&) { return "counterexamples.jsonl"; }
std::string witnesses(const Run&) { return "witnesses.jsonl"; }
std::string cases(const Run&) { return "cases.jsonl"; }
std::string named_cases(const Run& run) {
  return fs::path(run.all().member("files").text_or("cases", "")).filename().string();
}

constexpr std::array kinds = {
    ResultKind{"fuzz", "summary", ".json", "counts", counterexamples, gather_fuzz},
    ResultKind{"relations", "relations", ".json", "relations", witnesses, gather_relations},
    ResultKind{"certificate", "certificate", ".json", "verdict", counterexamples, gather_certificate},
    ResultKind{"sweep", "sweep", ".json", "thresholds", witnesses, gather_sweep},
    ResultKind{"compilers", "compilers", ".json", "builds", no_cases, gather_compilers},
    ResultKind{"map", "map-", ".json", "panels", no_cases, gather_map},
    ResultKind{"render", "", ".diff.json", "pixels", named_cases, gather_render},
    ResultKind{"leak", "summary", ".json", "trials", cases, gather_leak},
    ResultKind{"chart", "chart", ".json", "speed", no_cases, gather_chart},
    ResultKind{"bench", "bench", ".json", "benchmarks", no_cases, gather_bench},
};

constexpr const char* writers = "fuzz, certify, judge, sweep, chart, leak, render --against or bench wrote";

struct Result {
  const ResultKind* kind;
  Run run;
};

/// Whether a file of this name may be a result.
bool may_be_result(const std::string& name) {
  return std::ranges::any_of(kinds, [&](const ResultKind& k) {
    return name.starts_with(k.prefix) && name.ends_with(k.suffix) && name.size() >= k.prefix.size() + k.suffix.size();
  });
}

const ResultKind* kind_of(const std::string& name, const Json& record) {
  for (const ResultKind& k : kinds) {
    if (name.starts_with(k.prefix) && name.ends_with(k.suffix) && record.is_object() && record.contains(k.key)) {
      return &k;
    }
  }
  return nullptr;
}

/// Adds the results in the directory whose files are not among those taken before, by their canonical paths:
/// directories may lie in each other.
void add_results(const std::string& directory, std::vector<Result>& results, std::set<std::string>& taken) {
  bool any = false;
  for (const std::string& file : files_below(directory)) {
    const fs::path path(file);
    const std::string name = path.filename().string();
    if (!may_be_result(name)) continue;
    Json record = parse_json(read_file(file), {file});
    const ResultKind* kind = kind_of(name, record);
    if (kind == nullptr) continue;
    any = true;
    if (!taken.insert(canonical_path(file)).second) continue;
    results.push_back({kind,
                       {.number = results.size(),
                        .directory = path.parent_path().string(),
                        .file = name,
                        .record = std::move(record)}});
  }
  if (!any) throw bad_input(directory, 0, std::string("holds no result, expected a file that ") + writers);
}

void read_cases(Result& result, CaseBook& book) {
  const std::string name = result.kind->cases(result.run);
  if (name.empty()) return;
  const std::string file = result.run.path(name);
  if (is_regular_file(file)) book.read(result.run.number, file);
}

Json start_of_page(const Result& result) {
  const Run& run = result.run;
  const Json& r = run.record;
  if (r.contains("seed")) run.all().whole("seed");
  if (const auto made_with = run.all().find("environment")) made_with->object();
  return {{"kind", result.kind->name},
          {"id", "run-" + std::to_string(run.number)},
          {"title", run.directory},
          {"directory", run.directory},
          {"files", {run.file}},
          {"command", Json()},
          {"command_is", "from the record"},
          {"methods", Json::array()},
          {"seed", r.contains("seed") ? r["seed"] : Json()},
          {"environment", r.contains("environment") ? r["environment"] : Json()},
          {"cases", Json::array()},
          {"cases_in_all", 0},
          {"left_out", Json::array()}};
}

void gather(Result& result, Gathering& g) {
  Run& run = result.run;
  run.page = start_of_page(result);
  if (const std::string name = result.kind->cases(run); !name.empty()) run.page["files"].push_back(name);
  result.kind->gather(run, g);
  const std::vector<std::size_t> shown = g.book.numbers_of(run.number);
  const std::size_t found = g.book.found_in(run.number);
  run.page["cases"] = shown;
  run.page["cases_in_all"] = found;
  if (shown.size() < found) {
    g.leave_out(run, std::to_string(found - shown.size()) + " of its " + std::to_string(found) +
                         " cases; the worst and most diverse are here");
  }
}

Json families_json(const Json& runs) {
  Json families = Json::object();
  for (const Json& run : runs) {
    for (const Record& named : Record(run, {"page"}).items_or_none("families")) {
      const std::string name = named.text();
      const Family* family = find_family(name);
      families[name] = {{"about", family != nullptr ? Json(family->stresses) : Json("cases of your own")}};
    }
  }
  return families;
}

}  // namespace

Json gather_report(const ReportPlan& plan) {
  std::vector<Result> results;
  std::set<std::string> taken;
  for (const std::string& directory : plan.directories) add_results(directory, results, taken);
  Gathering g;
  for (Result& r : results) read_cases(r, g.book);
  g.book.choose(plan.most_cases);
  Json runs = Json::array();
  for (Result& r : results) {
    gather(r, g);
    runs.push_back(std::move(r.run.page));
  }
  const Json report = {{"schema", 1},
                       {"made_with", environment()},
                       {"directories", plan.directories},
                       {"verdicts", g.verdicts()},
                       {"methods", g.methods()},
                       {"method_order", g.method_order()},
                       {"families", families_json(runs)},
                       {"runs", std::move(runs)},
                       {"answer_methods", g.book.answer_methods()},
                       {"cases", g.book.shown()},
                       {"classes", classes_json()},
                       {"images", g.images()},
                       {"left_out", g.left_out()}};
  return with_strings(report, shown);  // names in it come from files
}

}  // namespace tribunal
