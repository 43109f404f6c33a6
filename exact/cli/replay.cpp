#include <memory>

#include "exact/base/failure.h"
#include "exact/base/files.h"
#include "exact/cli/command.h"
#include "exact/methods/methods.h"
#include "exact/record/counterexample.h"

namespace tribunal {
namespace {

int run_replay(const std::string& file) {
  bool any_wrong = false;
  for (const Case& c : read_cases(file)) {
    bool wrong = false;
    print(replay(c, wrong) + "\n");
    any_wrong |= wrong;
  }
  return code(any_wrong ? Exit::disagreement : Exit::ok);
}

/// The method that a case is a counterexample to: named in its finding, or given.
const Method& method_of(const Case& c, const std::string& given, const std::string& file) {
  const std::string name = !given.empty() ? given : c.finding.is_object() ? c.finding.value("method", "") : "";
  if (name.empty()) throw Failure(Exit::usage, file + ": " + c.id + " names no method, expected --method");
  const Method* method = find_method(name);
  if (method == nullptr) throw Failure(Exit::usage, file + ": " + c.id + " names an unknown method, " + name);
  return *method;
}

int run_shrink(const std::string& file, const std::string& method, const std::string& out) {
  require_different(file, out);
  std::string lines;
  bool faults = false;
  for (const Case& c : read_cases(file)) {
    const Case small = shrunk(c, method_of(c, method, file));
    faults |= small.finding.contains("fault");
    lines += from_case(small).dump() + "\n";
  }
  write_file(out, lines);
  return code(faults ? Exit::disagreement : Exit::ok);
}

}  // namespace

Action declare_replay(CLI::App& app) {
  const auto file = std::make_shared<std::string>();
  app.add_option("FILE", *file, "case or counterexample file (JSON Lines); - is standard input")->required();
  return with_plugins(app, [file] { return run_replay(*file); });
}

Action declare_shrink(CLI::App& app) {
  struct Options {
    std::string file, method, out = "-";
  };
  const auto o = std::make_shared<Options>();
  app.add_option("FILE", o->file, "counterexample file (JSON Lines)")->required();
  app.add_option("--method", o->method, "the method that is wrong (default: the one that the file names)");
  app.add_option("--out", o->out, "where the shrunk cases go; - is standard output")->capture_default_str();
  return with_plugins(app, [o] { return run_shrink(o->file, o->method, o->out); });
}

}  // namespace tribunal
