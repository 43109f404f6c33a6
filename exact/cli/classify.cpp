#include <memory>

#include "exact/cli/command.h"
#include "exact/harness/fuzz.h"
#include "exact/io/failure.h"
#include "exact/io/files.h"
#include "exact/io/polygon_case_io.h"
#include "exact/polygon/judge.h"

namespace tribunal {
namespace {

struct Options {
  std::string methods, in = "-", out = "-";
};

/// With the class where the method can tell it.
Answer answer_to(const Method& method, const Query& query) {
  return method.classify ? method.classify(query.probe, query.triangle) : method.ask(query);
}

/// `unsupported` where the method promises nothing, which takes the exact answer to tell.
PolygonAnswer answer_to(const Method& method, const PolygonQuery& query) {
  const PolygonAnswer answer = method.ask(query);
  const bool promises_all = method.polygon_promise.boundary && method.polygon_promise.surface;
  if (promises_all || answer.answer.status != Status::ok) return answer;
  return within_contract(method, exact_truth(query), answer);
}

int run(const Options& o) {
  const std::vector<Method> methods = methods_named(o.methods);
  require_different(o.in, o.out);
  std::string lines;
  bool any_fault = false;
  const auto answer = [&](const auto& c) {
    for (const Method& m : methods) {
      const auto given = answer_to(m, c.query);
      any_fault |= is_fault(plain(given).status);
      lines += from_answer(c.id, m, given).dump() + "\n";
    }
  };
  for (const AnyCase& c : read_any_cases(o.in)) std::visit(answer, c);
  write_file(o.out, lines);
  return code(any_fault ? Exit::disagreement : Exit::ok);
}

}  // namespace

Action declare_classify(CLI::App& app) {
  const auto o = std::make_shared<Options>();
  app.add_option("--method", o->methods, "methods, separated by commas")->required();
  app.add_option("--in", o->in, "case file (JSON Lines); - is standard input")->capture_default_str();
  app.add_option("--out", o->out, "answer file (JSON Lines); - is standard output")->capture_default_str();
  return with_plugins(app, [o] { return run(*o); });
}

}  // namespace tribunal
