#include "exact/cli/fuzz_polygons.h"

#include <algorithm>
#include <cstdio>

#include "exact/cli/command.h"
#include "exact/harness/environment.h"
#include "exact/harness/interrupt.h"
#include "exact/harness/progress.h"
#include "exact/io/failure.h"
#include "exact/io/files.h"

namespace tribunal {
namespace {

constexpr std::string_view prefix = "polygon-";

const PolygonFamily& family_named(const std::string& name) {
  if (const PolygonFamily* family = find_polygon_family(name)) return *family;
  if (!name.starts_with(prefix)) throw Failure(Exit::usage, "\"" + name + "\" is no polygon family: ask for it apart");
  std::vector<std::string> known;
  for (const PolygonFamily& f : all_polygon_families()) known.emplace_back(f.name);
  throw Failure(Exit::usage, "unknown family \"" + name + "\", did you mean \"" + nearest(name, known) + "\"?");
}

using Rows = std::map<std::tuple<std::size_t, std::size_t, std::size_t>, Count>;

/// By method × stream, and level if asked for.
Rows rows_of(const PolygonFuzzReport& report, bool levels) {
  Rows rows;
  for (const auto& [cell, count] : report.counts) rows[{cell.method, cell.stream, levels ? cell.level : 0}] += count;
  return rows;
}

std::string table(const PolygonFuzzPlan& plan, const PolygonFuzzReport& report, bool levels) {
  char line[200];
  std::snprintf(line, sizeof line, "%-14s %-17s %-9s %6s %12s %10s  %s\n", "method", "family", "format",
                levels ? "level" : "", "judged", "wrong", "share");
  std::string text = line;
  for (const auto& [row, count] : rows_of(report, levels)) {
    const auto& [method, stream, level] = row;
    const PolygonStream& s = plan.streams[stream];
    const std::string at = levels ? std::to_string(s.family->levels(s.format)[level]) : "";
    const auto judged = static_cast<double>(count.judged());
    std::snprintf(line, sizeof line, "%-14s %-17s %-9s %6s %12.0f %10llu  %.4f %%\n", plan.methods[method].name.c_str(),
                  std::string(s.family->name).c_str(), std::string(name_of(s.format)).c_str(), at.c_str(), judged,
                  static_cast<unsigned long long>(count.wrong),
                  judged == 0 ? 0 : 100 * static_cast<double>(count.wrong) / judged);
    text += line;
  }
  return text;
}

/// Nothing in it varies from run to run.
Json summary(const PolygonFuzzPlan& plan, const PolygonFuzzReport& report) {
  Json rows = Json::array();
  for (const auto& [cell, count] : report.counts) {
    const PolygonStream& s = plan.streams[cell.stream];
    rows.push_back({{"method", plan.methods[cell.method].name},
                    {"family", s.family->name},
                    {"fmt", name_of(s.format)},
                    {"level", s.family->levels(s.format)[cell.level]},
                    {"contact", name_of(cell.contact)},
                    {"planar", cell.planar},
                    {"asked", count.asked},
                    {"wrong", count.wrong},
                    {"unsupported", count.unsupported}});
  }
  Json constructions = Json::array();
  for (const auto& [known, n] : report.coverage) {
    const auto& [shape, place, approach] = known;
    constructions.push_back({{"configuration", all_shapes()[shape].name},
                             {"place", name_of(place)},
                             {"approach", name_of(approach)},
                             {"cases", n}});
  }
  return {{"seed", plan.seed},
          {"cases", report.cases},
          {"counts", rows},
          {"constructions", constructions},
          {"environment", environment()}};
}

std::vector<PolygonCase> counterexamples(const PolygonFuzzPlan& plan, const PolygonFuzzReport& report,
                                         std::size_t keep) {
  std::vector<PolygonCase> cases;
  std::vector<std::size_t> kept(plan.methods.size());
  for (const PolygonFinding& f : report.findings) {
    if (kept[f.method]++ < keep) cases.push_back(to_counterexample(plan, f));
  }
  return cases;
}

void write_findings(const PolygonFuzzPlan& plan, const PolygonFuzzReport& report, const std::string& out,
                    std::size_t keep) {
  const std::vector<PolygonCase> cases = counterexamples(plan, report, keep);
  std::string lines;
  for (const PolygonCase& c : cases) lines += from_case(c).dump() + "\n";
  write_file(out + "/summary.json", summary(plan, report).dump(1) + "\n");
  write_file(out + "/counterexamples.jsonl", lines);
  print(std::to_string(cases.size()) + " counterexamples in " + out + "/counterexamples.jsonl" +
        (cases.empty() ? "" : "; `tribunal replay` shows them") + "\n");
}

}  // namespace

std::vector<PolygonStream> polygon_streams_named(const std::string& comma_separated) {
  const std::vector<std::string> names = split(comma_separated);
  const bool any = std::any_of(names.begin(), names.end(), [](const auto& name) { return name.starts_with(prefix); });
  std::vector<PolygonStream> streams;
  if (!any) return streams;
  for (const std::string& name : names) {
    const PolygonFamily& family = family_named(name);
    for (const Format format : {Format::binary64, Format::binary32}) streams.push_back({&family, format});
  }
  return streams;
}

std::string polygon_family_names() {
  std::string text;
  for (const PolygonFamily& f : all_polygon_families()) text += " " + std::string(f.name);
  return text;
}

int run_polygons(const PolygonFuzzPlan& plan, const std::string& out, std::size_t keep, bool levels) {
  for (const Method& m : plan.methods) {
    if (!m.polygon) throw Failure(Exit::usage, m.name + " takes no polygons");
  }
  if (!out.empty()) make_directory(out);
  const PolygonFuzzReport report = fuzz(plan);
  if (report.cases == 0) throw Failure(Exit::resources, "no case was run");
  print(table(plan, report, levels));
  if (!report.coverage.empty()) print("constructed: " + describe(report.coverage) + "\n");
  print(compact(static_cast<double>(report.cases)) + " cases in " + compact(report.seconds) + " s, " +
        compact(static_cast<double>(report.cases) / report.seconds) + "/s; seed " + std::to_string(plan.seed) + "\n");
  if (!out.empty()) write_findings(plan, report, out, keep);
  return exit_code_after(code(report.findings.empty() ? Exit::ok : Exit::disagreement), interrupted());
}

}  // namespace tribunal
