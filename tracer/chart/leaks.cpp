#include "tracer/chart/leaks.h"

#include <cstdio>
#include <filesystem>

#include "exact/base/failure.h"
#include "exact/base/interrupt.h"
#include "exact/base/json.h"
#include "exact/certificate/rate.h"
#include "exact/trial/judge.h"
#include "tracer/leak/trial.h"

namespace tribunal {
namespace {

std::string mesh_name(const LeakChartPlan& plan) { return std::filesystem::path(plan.mesh).filename().string(); }

void add_rows(std::vector<LeakRow>& rows, const LeakChartPlan& plan, const leak::Surface& surface) {
  const Format format = surface.format();
  std::vector<std::size_t> asked;
  std::vector<leak::Subject> subjects;
  for (std::size_t m = 0; m < plan.methods.size(); ++m) {
    if (!leak::takes_rays(plan.methods[m]) || !takes(plan.methods[m], format)) continue;
    asked.push_back(m);
    subjects.push_back(leak::subject_of(plan.methods[m], surface));
  }
  if (asked.empty()) return;
  const leak::LeakReport report = leak::run_leak_trial(
      surface, subjects, {.seed = plan.seed, .rays = plan.rays, .threads = plan.threads, .keep = 0});
  fail_if_interrupted("leaks are not counted");
  if (report.rays == 0) throw Failure(Exit::resources, plan.mesh + ": no ray could be judged");
  for (std::size_t i = 0; i < asked.size(); ++i) {
    const leak::AimTally all = report.subjects[i].tally.all();
    rows.push_back({asked[i], format, all.rays, all[leak::Outcome::leak]});
  }
}

}  // namespace

std::vector<leak::Surface> surfaces_of(const Mesh& triangles, const std::string& file) {
  std::vector<leak::Surface> surfaces;
  for (const Format format : {Format::binary32, Format::binary64}) surfaces.emplace_back(triangles, format, file);
  return surfaces;
}

std::vector<LeakRow> measure_leaks(const LeakChartPlan& plan, std::span<const leak::Surface> surfaces) {
  std::vector<LeakRow> rows;
  for (const leak::Surface& surface : surfaces) add_rows(rows, plan, surface);
  return rows;
}

Json to_json(const LeakChartPlan& plan, const std::vector<LeakRow>& rows) {
  Json json = {{"mesh", mesh_name(plan)}, {"rows", Json::array()}};
  for (const LeakRow& r : rows) {
    const Rate rate = rate_of(r.leaks, r.rays);
    json["rows"].push_back({{"method", plan.methods[r.method].name},
                            {"fmt", name_of(r.format)},
                            {"rays", r.rays},
                            {"leaks", r.leaks},
                            {"share", rate.share},
                            {"lower", rate.lower},
                            {"upper", rate.upper}});
  }
  return json;
}

std::string to_table(const LeakChartPlan& plan, const std::vector<LeakRow>& rows) {
  std::string text = "Leaks per million rays at vertices, edges and faces of " + mesh_name(plan) + "\n";
  char line[160];
  for (const LeakRow& r : rows) {
    std::snprintf(line, sizeof line, "  %-22s %8s %10llu rays %10.0f\n", plan.methods[r.method].name.c_str(),
                  std::string(name_of(r.format)).c_str(), static_cast<unsigned long long>(r.rays),
                  1e6 * static_cast<double>(r.leaks) / static_cast<double>(r.rays));
    text += line;
  }
  return text + "\n";
}

}  // namespace tribunal
