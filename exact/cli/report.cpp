// tribunal report: one page of the results in any directories.
#include "exact/report/report.h"

#include <memory>

#include "exact/base/failure.h"
#include "exact/base/files.h"
#include "exact/base/output.h"
#include "exact/base/record.h"
#include "exact/cli/command.h"
#include "exact/report/classes.h"

namespace tribunal {
namespace {

struct Options {
  ReportPlan plan{};
  std::string out = "report.html", json, classes;
};

/// What the page says first, and what it does not show.
std::string in_words(const Json& report, const std::string& out) {
  std::string text;
  const Record all(report, {out});
  for (const Record& line : all.items("verdicts")) {
    const std::string detail = line.text("detail");
    text += (line.text("text") + (detail.empty() ? "" : "; " + detail)) + "\n";
  }
  for (const Record& what : all.items("left_out")) text += "left out: " + (what.text()) + "\n";
  return text + "\n" + std::to_string(report["runs"].size()) + " results, " + std::to_string(report["cases"].size()) +
         " cases; open " + out + "\n";
}

int run(const Options& o) {
  std::vector<Output> outputs{{"--classes", o.classes}, {"--json", o.json}};
  if (!o.plan.directories.empty()) outputs.push_back({"--out", o.out});
  std::erase_if(outputs, [](const Output& output) { return output.file.empty(); });
  require_distinct(outputs);
  OutputSet set;
  if (!o.classes.empty()) set.add(o.classes, classes_json().dump(1) + "\n");
  if (!o.classes.empty() && o.plan.directories.empty()) return set.commit(), code(Exit::ok);
  if (o.plan.directories.empty()) throw Failure(Exit::usage, "report: no directory given, expected one with results");
  const Json report = gather_report(o.plan);
  if (!o.json.empty()) set.add(o.json, report.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n");
  set.add(o.out, report_page(report));
  set.commit();
  if (o.out != "-" && o.json != "-" && o.classes != "-") print(in_words(report, o.out));
  return code(Exit::ok);
}

}  // namespace

Action declare_report(Arguments& arguments) {
  const auto o = std::make_shared<Options>();
  arguments.several("DIR", o->plan.directories,
                    "directories with results of fuzz, certify, judge, sweep, chart, leak, render --against, bench; "
                    "what is in them is searched too");
  arguments.option("--out", o->out, "the page, one file that needs no other").shows_default();
  arguments.option("--max-cases", o->plan.most_cases, "cases on the page, the worst and most diverse").shows_default();
  arguments.option("--json", o->json, "also what the page shows, as JSON (docs/report.md)");
  arguments.option("--classes", o->classes, "also the classes with their drawings, as JSON; needs no DIR");
  return [o] { return run(*o); };
}

}  // namespace tribunal
