#include <memory>

#include "exact/base/failure.h"
#include "exact/base/files.h"
#include "exact/base/held_output.h"
#include "exact/cases/answer_text.h"
#include "exact/cases/case_blocks.h"
#include "exact/cli/command.h"
#include "exact/trial/judge.h"
#include "exact/trial/quick_truth.h"

namespace tribunal {
namespace {

struct Options {
  std::string methods, in = "-", out = "-";
  unsigned threads = 1;
};

/// The method's answer, with the class where it can say it.
Answer answer_to(const Method& method, const Query& query) {
  if (!is_finite(query)) return refusal(Status::nonfinite);
  const bool classifies = method.classify && !query.bounds && query.operands() == Operands::triangles;
  return classifies ? method.classify(query.probe, query.triangle()) : method.ask(query);
}

/// What a contract may turn on: of triangles by certified signs, which take a fraction of the oracles' time. Nothing is
/// judged by it.
Truth exact_facts(const Query& query) {
  if (query.operands() == Operands::polygons) return exact_truth(query);
  return quick_truth_with_facing({.query = query}, certified_class);
}

/// The method's answer, or `unsupported` where it owes none; whether it does may depend on the exact answer.
Answer owed_answer(const Method& method, const Query& query) {
  const Answer answer = answer_to(method, query);
  if (owes_all(method.contract, query.operands()) || answer.status != Status::ok) return answer;
  return within_contract(method, exact_facts(query), answer);
}

/// The answers to the cases of a block, in order.
struct Answered {
  std::string lines{};
  bool any_fault = false;

  void clear() {
    lines.clear();
    any_fault = false;
  }
};

int run(const Options& o) {
  const std::vector<Method> methods = methods_on_trial(o.methods);
  require_different(o.in, o.out);
  HeldOutput out(o.out);
  bool any_fault = false;
  const auto answer = [&](const Case& c, CasePlace, Answered& block) {
    for (const Method& m : methods) {
      const Answer given = owed_answer(m, c.query);
      block.any_fault |= is_fault(given.status);
      append_answer(block.lines, c, m, given);
    }
  };
  const auto take = [&](const Answered& block) {
    out.write(block.lines);
    any_fault |= block.any_fault;
  };
  for_each_case<Answered>(o.in, {o.threads, "no answers written"}, answer, take);
  out.commit();
  return code(any_fault ? Exit::disagreement : Exit::ok);
}

}  // namespace

Action declare_classify(Arguments& arguments) {
  const auto o = std::make_shared<Options>();
  add_methods_option(arguments, o->methods);
  arguments.option("--in,FILE", o->in, "case file (JSON Lines); - is standard input").shows_default();
  arguments.option("--out", o->out, "answer file (JSON Lines); - is standard output").shows_default();
  add_threads_option(arguments, o->threads);
  return with_plugins(arguments, [o] { return run(*o); });
}

}  // namespace tribunal
