#include "exact/certificate/certify.h"

#include <memory>

#include "exact/certificate/certificate.h"
#include "exact/certificate/verify.h"
#include "exact/families/aimed.h"
#include "exact/io/failure.h"
#include "exact/io/files.h"
#include "tracer/cli/command.h"
#include "tracer/mesh/read_mesh.h"
#include "tracer/mesh/triangulate.h"

namespace tribunal {
namespace {

struct Options {
  std::string method, budget = "quick", cases, mesh, out;
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

Family family_of_mesh(const std::string& path) {
  const Mesh mesh = triangulated(read_mesh(path), path);
  std::vector<Triangle> triangles;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) triangles.push_back(mesh.triangle(i));
  if (triangles.empty()) throw bad_input(path, 0, "holds no faces");
  return aimed_at(std::move(triangles));
}

int run(const Options& o) {
  const std::vector<Method> methods = methods_named(o.method);
  if (methods.size() != 1) throw Failure(Exit::usage, "certify takes one method, found " + o.method);
  CertifyPlan plan{.method = methods[0], .budget = budget_named(o.budget), .seed = o.seed, .threads = o.threads};
  if (!o.cases.empty()) {
    plan.cases = read_cases(o.cases);
    plan.truths = truths_of(plan.cases, o.cases);
  }
  Family of_mesh;
  if (!o.mesh.empty()) {
    of_mesh = family_of_mesh(o.mesh);
    for (const Format format : {Format::binary64, Format::binary32}) plan.streams.push_back({&of_mesh, format});
  }
  make_directory(o.out);
  ChainedLog log = certify(plan);
  const Certificate c = write_certificate(o.out, log);
  print(to_summary(c) + "  " + std::to_string(c.counterexamples.size()) + " counterexamples, the simplest of each " +
        "class; see " + o.out + "/certificate.md\n");
  return exit_of(c.verdict);
}

int run_verify(const std::string& directory) {
  const Verification v = verify(directory);
  for (const std::string& fault : v.faults) print(fault + "\n");
  const Certificate& c = v.certificate;
  print(std::string(v.faults.empty() ? "verified" : "NOT VERIFIED") + ": " + c.method() + " " + name_of(c.verdict) +
        "; " + std::to_string(v.confirmed) + " of " + std::to_string(c.counterexamples.size()) +
        " counterexamples confirmed by exact arithmetic; " +
        (v.asked_again ? "asked again on 93888 cases" : "not asked again: the method is not known here") +
        "\nlog sha256 " + c.log_head + "\n");
  return code(v.faults.empty() ? Exit::ok : Exit::disagreement);
}

}  // namespace

Action declare_certify(CLI::App& app) {
  const auto o = std::make_shared<Options>();
  app.add_option("--method", o->method, "the method on trial")->required();
  app.add_option("--budget", o->budget,
                 "quick: {0,1,2}^3 whole and 1.2 million samples; standard: {0..3}^3 too, some minutes; "
                 "soak: 2.1e9 samples, many hours")
      ->check(CLI::IsMember(budget_names()))
      ->capture_default_str();
  app.add_option("--cases", o->cases, "case file of your own, judged with the rest");
  app.add_option("--mesh", o->mesh, "mesh of your own (OFF, OBJ, PLY, STL): segments are aimed at its triangles");
  app.add_option("--seed", o->seed, "seed of the sample")->check(whole_number())->capture_default_str();
  add_threads_option(app, o->threads);
  app.add_option("--out", o->out, "directory for certificate.json, certificate.md, log.jsonl, counterexamples.jsonl")
      ->required();
  return with_plugins(app, [o] { return run(*o); });
}

Action declare_verify(CLI::App& app) {
  const auto directory = std::make_shared<std::string>();
  app.add_option("DIR", *directory, "what certify --out wrote")->required();
  return with_plugins(app, [directory] { return run_verify(*directory); });
}

}  // namespace tribunal
