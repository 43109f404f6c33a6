// What `leak` and `judge --mesh` wrote: summary.json and cases.jsonl.
#include <algorithm>

#include "exact/report/gathering.h"
#include "exact/report/shapes.h"

namespace tribunal {
namespace {

/// Leaks are worse than any other error; errors beside them are wrong answers on the boundaries of faces.
/// Of a mesh that is not closed, or of which that is not said, nothing is said about being watertight.
ReportLine leak_line(std::size_t run, const Record& subject, const Record& trial, const std::string& mesh) {
  const std::string fmt = trial.text("fmt");
  const Record all = subject.member("all");
  const std::uint64_t rays = number_in(all, "rays"), leaks = number_in(all, "leak");
  std::uint64_t others = 0;
  std::string detail;
  for (const char* error : {"false hit", "double hit", "closest", "order", "parity", "t", "normal", "fault"}) {
    const std::uint64_t n = number_in(all, error);
    require_part(all, n, rays, error);
    others += n;
    if (n > 0) detail += (detail.empty() ? "" : ", ") + std::string(error) + ": " + std::to_string(n);
  }
  require_part(all, leaks, rays, "leak");
  const std::string name = subject.text("name");
  ReportLine line{.run = run, .method = name, .fmt = fmt, .detail = detail, .wrong = leaks, .judged = rays};
  line.level = leaks > 0                     ? Level::leaks
               : number_in(all, "fault") > 0 ? Level::fault
               : others > 0                  ? Level::boundary
                                             : Level::nothing;
  if (leaks > 0) {
    line.text = name + ": " + share_in_words(leaks, rays) + " " + fmt + " rays leak through " + mesh;
    return line;
  }
  const bool closed = trial.truth_or("closed", false);
  line.text =
      name + ": " + (closed ? "watertight on " : "no leak on ") + std::to_string(rays) + " " + fmt + " rays at " + mesh;
  if (!closed) line.text += ", whose surface is " + trial.text_or("topology", "not said to be closed");
  if (others > 0) line.text += ", but wrong in other ways";
  return line;
}

}  // namespace

void gather_leak(Run& run, Gathering& g) {
  const Record all = run.all();
  require_leak_record(all);
  const std::string mesh = all.text_or("mesh", "");
  std::vector<std::string> names;
  for (const Record& trial : all.items("trials")) {
    for (const Record& subject : trial.items("subjects")) {
      const std::string name = g.add_method(subject.text("name"));
      if (std::ranges::find(names, name) == names.end()) names.push_back(name);
      g.add(leak_line(run.number, subject, trial, mesh));
    }
  }
  run.page["title"] = mesh;
  run.page["methods"] = names;
  run.page["command"] = command_in(run);
  Json r = run.record;
  r.erase("environment");
  run.page["record"] = std::move(r);
}

}  // namespace tribunal
