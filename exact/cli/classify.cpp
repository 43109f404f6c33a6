#include <memory>

#include "exact/base/failure.h"
#include "exact/base/files.h"
#include "exact/cases/case_io.h"
#include "exact/cli/command.h"
#include "exact/trial/judge.h"

namespace tribunal {
namespace {

struct Options {
  std::string methods, in = "-", out = "-";
};

/// With the class where the method can tell it.
Answer answer_to(const Method& method, const Query& query) {
  const bool classifies = method.classify && query.operands() == Operands::triangles;
  return classifies ? method.classify(query.probe, query.triangle()) : method.ask(query);
}

/// `unsupported` where the method owes nothing, which may take the exact answer to tell.
Answer owed_answer(const Method& method, const Query& query) {
  const Answer answer = answer_to(method, query);
  if (owes_all(method.contract, query.operands()) || answer.status != Status::ok) return answer;
  return within_contract(method, exact_truth(query), answer);
}

int run(const Options& o) {
  const std::vector<Method> methods = methods_named(o.methods);
  require_different(o.in, o.out);
  std::string lines;
  bool any_fault = false;
  for (const Case& c : read_cases(o.in)) {
    for (const Method& m : methods) {
      const Answer answer = owed_answer(m, c.query);
      any_fault |= is_fault(answer.status);
      lines += from_answer(c, m, answer).dump() + "\n";
    }
  }
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
