#include <memory>

#include "exact/base/failure.h"
#include "exact/base/files.h"
#include "exact/base/output.h"
#include "exact/base/record.h"
#include "exact/base/shown.h"
#include "exact/cli/command.h"
#include "exact/methods/methods.h"
#include "exact/record/counterexample.h"
#include "exact/record/emit.h"

namespace tribunal {
namespace {

struct ReplayOptions {
  std::string file, methods, language, function = "my_test";
};

int run_replay(const ReplayOptions& o) {
  if (!is_function_name(o.function))
    throw Failure(Exit::usage, "--function is " + o.function + ", expected letters, digits and _, no digit first");
  const std::vector<Case> cases = read_cases(o.file);
  if (!o.language.empty()) {
    print(emit(cases, o.language, o.function, o.file));
    return code(Exit::ok);
  }
  const std::vector<Method> methods =
      o.methods.empty() ? std::vector<Method>(all_methods().begin(), all_methods().end()) : methods_named(o.methods);
  bool any_wrong = false;
  for (const Case& c : cases) {
    bool wrong = false;
    print(replay(c, methods, wrong) + "\n");
    any_wrong |= wrong;
  }
  return code(any_wrong ? Exit::disagreement : Exit::ok);
}

/// The method that a case is a counterexample to: named in its finding, or given.
const Method& method_of(const Case& c, const std::string& given, const std::string& file) {
  const Record finding(c.finding, {file, 0, c.id + ".finding"});
  const std::string name = !given.empty() ? given : c.finding.is_null() ? "" : finding.text_or("method", "");
  if (name.empty()) throw Failure(Exit::usage, file + ": " + shown(c.id) + " names no method, expected --method");
  const Method* method = find_method(name);
  if (method != nullptr) return *method;
  if (!given.empty())
    throw Failure(Exit::usage, "unknown method " + given + ", expected one that `tribunal methods` lists");
  throw bad_input(file, 0,
                  shown(c.id) + " names an unknown method, " + shown(name) +
                      ", expected one that `tribunal methods` lists, or its library as --plugin");
}

int run_shrink(const std::string& file, const std::string& method, const std::string& out) {
  require_different(file, out);
  std::string lines;
  bool faults = false;
  for (const Case& c : read_cases(file)) {
    if (!is_finite(c.query)) {  // nobody answers it, so nothing is wrong that could be made smaller
      lines += from_case(c).dump() + "\n";
      continue;
    }
    const Case small = shrunk(c, method_of(c, method, file));
    faults |= small.finding.contains("fault");
    lines += from_case(small).dump() + "\n";
  }
  write_file(out, lines);
  return code(faults ? Exit::disagreement : Exit::ok);
}

}  // namespace

Action declare_replay(Arguments& arguments) {
  const auto o = std::make_shared<ReplayOptions>();
  arguments.option("FILE", o->file, "case or counterexample file (JSON Lines); - is standard input").required();
  arguments.option("--method,--methods", o->methods, "whose answers are shown, separated by commas (default: all)");
  arguments.option("--emit", o->language, "print a test to paste instead, which expects the exact answer")
      .one_of(emitted_languages());
  arguments
      .option("--function", o->function,
              "what the test asks: FUNCTION_segment, FUNCTION_ray and, with bounds, FUNCTION_ray_within")
      .shows_default();
  return with_plugins(arguments, [o] { return run_replay(*o); });
}

Action declare_shrink(Arguments& arguments) {
  struct Options {
    std::string file, method, out = "-";
  };
  const auto o = std::make_shared<Options>();
  arguments.option("FILE", o->file, "counterexample file (JSON Lines)").required();
  arguments.option("--method,--methods", o->method, "the method that is wrong (default: the one that the file names)");
  arguments.option("--out", o->out, "where the shrunk cases go; - is standard output").shows_default();
  return with_plugins(arguments, [o] { return run_shrink(o->file, o->method, o->out); });
}

}  // namespace tribunal
