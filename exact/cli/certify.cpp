#include "exact/certificate/certify.h"

#include <memory>

#include "exact/cli/command.h"
#include "exact/harness/counterexample.h"
#include "exact/io/failure.h"
#include "exact/io/files.h"

namespace tribunal {
namespace {

struct Options {
  std::string method, budget = "quick", cases, out;
  std::uint64_t seed = 1;
  unsigned threads = 1;
};

int exit_of(Verdict v) {
  constexpr Exit exits[] = {Exit::ok, Exit::disagreement, Exit::incomplete};
  return code(exits[static_cast<int>(v)]);
}

int run(const Options& o) {
  const std::vector<Method> methods = methods_named(o.method);
  if (methods.size() != 1) throw Failure(Exit::usage, "certify takes one method, found " + o.method);
  CertifyPlan plan{.method = methods[0], .seed = o.seed, .threads = o.threads};
  if (!o.cases.empty()) plan.cases = read_cases(o.cases);
  make_directory(o.out);
  const Certificate c = certify(plan);
  write_file(o.out + "/certificate.json", to_json(plan, c).dump(1) + "\n");
  write_file(o.out + "/certificate.md", to_markdown(plan, c));
  write_file(o.out + "/counterexamples.jsonl", to_lines(c.counterexamples));
  print(to_summary(plan, c) + "  " + std::to_string(c.counterexamples.size()) + " counterexamples; see " + o.out +
        "/certificate.md\n");
  return exit_of(c.verdict);
}

}  // namespace

Action declare_certify(CLI::App& app) {
  const auto o = std::make_shared<Options>();
  app.add_option("--method", o->method, "the method on trial")->required();
  app.add_option("--budget", o->budget, "how much to run")->check(CLI::IsMember({"quick"}))->capture_default_str();
  app.add_option("--cases", o->cases, "case file of your own, judged with the rest");
  app.add_option("--seed", o->seed, "seed of the sample")->check(whole_number())->capture_default_str();
  add_threads_option(app, o->threads);
  app.add_option("--out", o->out, "directory for certificate.json, certificate.md, counterexamples.jsonl")->required();
  return with_plugins(app, [o] { return run(*o); });
}

}  // namespace tribunal
