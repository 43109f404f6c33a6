#include <memory>

#include "exact/base/failure.h"
#include "exact/base/files.h"
#include "exact/base/output.h"
#include "exact/cases/case_io.h"
#include "exact/cli/command.h"
#include "exact/trial/judge.h"

namespace tribunal {
namespace {

struct Options {
  std::string methods, in = "-", out = "-";
};

/// The method's answer, with the class where it can say it.
Answer answer_to(const Method& method, const Query& query) {
  if (!is_finite(query)) return refusal(Status::nonfinite);
  const bool classifies = method.classify && !query.bounds && query.operands() == Operands::triangles;
  return classifies ? method.classify(query.probe, query.triangle()) : method.ask(query);
}

/// The method's answer, or `unsupported` where it owes none; whether it does may depend on the exact answer.
Answer owed_answer(const Method& method, const Query& query) {
  const Answer answer = answer_to(method, query);
  if (owes_all(method.contract, query.operands()) || answer.status != Status::ok) return answer;
  return within_contract(method, exact_truth(query), answer);
}

int run(const Options& o) {
  const std::vector<Method> methods = methods_on_trial(o.methods);
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

Action declare_classify(Arguments& arguments) {
  const auto o = std::make_shared<Options>();
  add_methods_option(arguments, o->methods);
  arguments.option("--in,FILE", o->in, "case file (JSON Lines); - is standard input").shows_default();
  arguments.option("--out", o->out, "answer file (JSON Lines); - is standard output").shows_default();
  return with_plugins(arguments, [o] { return run(*o); });
}

}  // namespace tribunal
