#include "exact/certificate/certify.h"

#include <algorithm>
#include <array>
#include <memory>
#include <optional>

#include "exact/base/failure.h"
#include "exact/base/files.h"
#include "exact/base/output.h"
#include "exact/base/shown.h"
#include "exact/cases/families/aimed.h"
#include "exact/certificate/certificate.h"
#include "exact/certificate/verify.h"
#include "exact/cli/command.h"

namespace tribunal {
namespace {

struct Options {
  std::string method, budget = "quick", cases, mesh, out;
  bool polygons = false;
  std::uint64_t seed = 1;
  unsigned threads = 1;
};

int exit_of(Verdict v) {
  constexpr Exit exits[] = {Exit::ok, Exit::disagreement, Exit::incomplete};
  return code(exits[static_cast<int>(v)]);
}

std::vector<std::string> budget_names() {
  std::vector<std::string> names;
  for (const Budget& b : budgets) names.push_back(b.name);
  return names;
}

const Budget& budget_named(const std::string& name) { return *std::ranges::find(budgets, name, &Budget::name); }

Family family_of_mesh(const std::string& path) { return aimed_at(read_own_mesh(path).triangles); }

CertifyPlan plan_of(const Options& o, const Method& method, Operands operands) {
  return {
      .method = method, .operands = operands, .budget = budget_named(o.budget), .seed = o.seed, .threads = o.threads};
}

int run(const Options& o, CertifyPlan plan) {
  std::optional<Rereadable> own;
  if (!o.cases.empty()) {
    require_sound(own.emplace(o.cases), plan.operands, plan.threads);
    plan.own = &*own;
  }
  make_directory(o.out);
  ChainedLog log = certify(plan);
  const Certificate c = write_certificate(o.out, log);
  const char* each = plan.operands == Operands::triangles ? "class" : "outcome";
  print(to_summary(c) + "  " + std::to_string(c.counterexamples) + " counterexamples, the simplest of each " + each +
        "; see " + o.out + "/certificate.md\n");
  return exit_of(c.verdict);
}

/// Whether the method tests triangles: asked about a plain hit, by a segment and by a ray, it answers or has a fault.
bool takes_triangles(const Method& method) {
  const Triangle t{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  const Answer to_segment = method.ask(Query{Segment{{1, 1, 1}, {1, 1, -1}}, t});
  const Answer to_ray = method.ask(Query{Ray{{1, 1, 1}, {{0, 0, -1}}}, t});
  return std::ranges::any_of(std::array{to_segment, to_ray},
                             [](const Answer& a) { return a.status == Status::ok || is_fault(a.status); });
}

int run_polygons(const Options& o, const Method& method) {
  require_polygons(method);
  if (!o.mesh.empty()) throw Failure(Exit::usage, "--mesh aims at triangles, expected none with polygons");
  return run(o, plan_of(o, method, Operands::polygons));
}

int run(const Options& o) {
  const Method method = method_on_trial(o.method);
  if (o.polygons || !takes_triangles(method)) return run_polygons(o, method);
  CertifyPlan plan = plan_of(o, method, Operands::triangles);
  Family of_mesh;
  if (!o.mesh.empty()) {
    of_mesh = family_of_mesh(o.mesh);
    plan.streams = streams_of(Operands::triangles);
    for (const Format format : {Format::binary64, Format::binary32}) plan.streams.push_back({&of_mesh, format});
  }
  return run(o, plan);
}

struct VerifyOptions {
  std::string directory;
  bool rerun = false;
  unsigned threads = 1;
};

int run_verify(const VerifyOptions& o) {
  const Verification v = verify(o.directory, o.rerun ? o.threads : 0);
  for (const std::string& fault : v.faults) print(shown(fault) + "\n");
  const Certificate& c = v.certificate;
  print(std::string(v.faults.empty() ? "verified" : "NOT VERIFIED") + ": " + shown(c.method()) + " " +
        name_of(c.verdict) + "; " + std::to_string(v.confirmed) + " of " + std::to_string(c.counterexamples) +
        " counterexamples confirmed by exact arithmetic; " +
        (v.not_asked.empty() ? "asked again on " + std::to_string(v.asked_again) + " cases"
                             : "not asked again: " + v.not_asked) +
        (v.rerun > 0 ? "; " + std::to_string(v.rerun) + " cases run again" : "") + "\nlog sha256 " + c.log_head + "\n");
  return code(v.faults.empty() ? Exit::ok : Exit::disagreement);
}

}  // namespace

Action declare_certify(Arguments& arguments) {
  const auto o = std::make_shared<Options>();
  arguments.option("--method,--methods", o->method, "the method on trial (default: that of a plugin)");
  arguments
      .option("--budget", o->budget,
              "quick: {0,1,2}^3 whole and 1.2 million samples; standard: {0..3}^3 too, some minutes; "
              "soak: 2.1e9 samples, many hours. With --polygons: 1.9 million cases in whole sets and 144 thousand "
              "samples; 32 million and 865 thousand; 86 million samples. Relations between answers are checked on 1000 "
              "cases "
              "of each family and format; 10 thousand; 500 thousand")
      .one_of(budget_names())
      .shows_default();
  arguments.flag(
      "--polygons", o->polygons,
      "certify its test of polygons instead of that of triangles (a method without the latter needs no word)");
  arguments.option("--cases", o->cases,
                   "case file of your own, judged and reported beside the rest; with --polygons of rings");
  arguments.option(
      "--mesh", o->mesh,
      "mesh of your own (OFF, OBJ, PLY, STL): segments and rays are aimed at its triangles, one a case; how "
      "often an answer is wrong is no leak rate, which `tribunal leak` measures");
  arguments.option("--seed", o->seed, "seed of the sample").shows_default();
  add_threads_option(arguments, o->threads);
  arguments.option("--out", o->out, "directory for certificate.json, certificate.md, log.jsonl, counterexamples.jsonl")
      .required();
  return with_plugins(arguments, [o] { return run(*o); });
}

Action declare_verify(Arguments& arguments) {
  const auto o = std::make_shared<VerifyOptions>();
  arguments.option("DIR", o->directory, "what certify --out or judge --out wrote").required();
  arguments.flag("--rerun", o->rerun,
                 "run the whole trial again, which takes as long as it took, and compare all counts");
  add_threads_option(arguments, o->threads);
  return with_plugins(arguments, [o] { return run_verify(*o); });
}

}  // namespace tribunal
