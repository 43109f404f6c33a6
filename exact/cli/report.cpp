// tribunal report: one page of the results in any directories.
#include "exact/report/report.h"

#include <memory>

#include "exact/base/failure.h"
#include "exact/base/files.h"
#include "exact/base/record.h"
#include "exact/cli/command.h"
#include "exact/report/classes.h"

namespace tribunal {
namespace {

struct Options {
  ReportPlan plan{};
  std::string out = "report.html", json, classes;
};

/// For a terminal: names and faults come from files, and may hold what would steer it.
std::string printable(std::string text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    const bool c1 = byte == 0xc2 && i + 1 < text.size() && static_cast<unsigned char>(text[i + 1]) < 0xa0;
    if (c1) text[i + 1] = '?';
    if (byte < 0x20 || byte == 0x7f || c1) text[i] = '?';
  }
  return text;
}

/// What the page says first, and what it does not show.
std::string in_words(const Json& report, const std::string& out) {
  std::string text;
  const Record all(report, {out});
  for (const Record& line : all.items("verdicts")) {
    const std::string detail = line.text("detail");
    text += printable(line.text("text") + (detail.empty() ? "" : "; " + detail)) + "\n";
  }
  for (const Record& what : all.items("left_out")) text += "left out: " + printable(what.text()) + "\n";
  return text + "\n" + std::to_string(report["runs"].size()) + " results, " + std::to_string(report["cases"].size()) +
         " cases; open " + printable(out) + "\n";
}

int run(const Options& o) {
  std::vector<Output> outputs{{"--classes", o.classes}, {"--json", o.json}};
  if (!o.plan.directories.empty()) outputs.push_back({"--out", o.out});
  std::erase_if(outputs, [](const Output& output) { return output.file.empty(); });
  require_distinct(outputs);
  if (!o.classes.empty()) {
    write_file(o.classes, classes_json().dump(1) + "\n");
    if (o.plan.directories.empty()) return code(Exit::ok);
  }
  if (o.plan.directories.empty()) throw Failure(Exit::usage, "report: no directory given, expected one with results");
  const Json report = gather_report(o.plan);
  if (!o.json.empty()) write_file(o.json, report.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n");
  write_file(o.out, report_page(report));
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
