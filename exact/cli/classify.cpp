#include <memory>

#include "exact/cli/command.h"
#include "exact/io/files.h"
#include "exact/io/polygon_case_io.h"
#include "exact/polygon/judge.h"

namespace tribunal {
namespace {

struct Options {
  std::string methods, in = "-", out = "-";
};

/// Whether every triangle that the method takes has an answer by its contract. (`proper` ones it refuses by itself.)
bool promises_all_triangles(const Contract& c) { return reads_point_sets(c) && c.triangles != Triangles::none; }

/// With the class where the method can tell it.
Answer answer_to(const Method& method, const Query& query) {
  if (method.classify) return method.classify(query.probe, query.triangle);
  const Answer answer = method.ask(query);
  if (promises_all_triangles(method.contract) || answer.status != Status::ok) return answer;
  return within_contract(method, exact_truth(query), answer);
}

/// `unsupported` where the method promises nothing, which takes the exact answer to tell.
PolygonAnswer answer_to(const Method& method, const PolygonQuery& query) {
  const PolygonAnswer answer = method.ask(query);
  if (promises_all_polygons(method.contract) || answer.answer.status != Status::ok) return answer;
  return within_contract(method, exact_truth(query), answer);
}

int run(const Options& o) {
  const std::vector<Method> methods = methods_named(o.methods);
  require_different(o.in, o.out);
  std::string lines;
  const auto answer = [&](const auto& c) {
    for (const Method& m : methods) lines += from_answer(c.id, m, answer_to(m, c.query)).dump() + "\n";
  };
  for (const AnyCase& c : read_any_cases(o.in)) std::visit(answer, c);
  write_file(o.out, lines);
  return 0;
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
