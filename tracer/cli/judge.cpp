// tribunal judge: answers computed anywhere, compared with the exact ones.
#include <algorithm>
#include <cctype>
#include <memory>

#include "exact/base/failure.h"
#include "exact/base/files.h"
#include "exact/certificate/certificate.h"
#include "exact/certificate/certify.h"
#include "exact/cli/command.h"
#include "exact/record/judge_answers.h"
#include "tracer/cli/command.h"
#include "tracer/cli/judge_mesh.h"

namespace tribunal {
namespace {

struct Options {
  std::string cases{}, convention = "closed";
  bool culls = false, towards_source = false;
  MeshAnswers mesh{};  ///< with the options that both ways to judge have
};

/// What the answers may promise, by the word that says it. Beside `closed` and `transversal` these are readings of the
/// boundary, of triangles and of rings alike.
struct Promise {
  std::string word;
  Convention convention = Convention::closed;
  Boundary boundary = Boundary::closed;
};

const std::vector<Promise>& promises() {
  static const std::vector<Promise> table = {{"closed"},
                                             {"transversal", Convention::transversal},
                                             {"open", Convention::transversal, Boundary::open},
                                             {"half-open", Convention::transversal, Boundary::half_open}};
  return table;
}

std::vector<std::string> promise_words() {
  std::vector<std::string> words;
  for (const Promise& p : promises()) words.push_back(p.word);
  return words;
}

Contract contract_of(const Options& o) {
  const Promise& p = *std::ranges::find(promises(), o.convention, &Promise::word);
  return {
      .polygons = Polygons::any, .convention = p.convention, .boundary = p.boundary, .polygon_boundary = p.boundary};
}

/// The log of a trial that consists of these cases and answers. It is about triangles if there are any.
ChainedLog log_of(const Exam& exam, const AnswerSheet& sheet, const Contract& contract) {
  const Method method = method_of(sheet, contract);
  const bool triangles =
      std::ranges::any_of(exam.truths, [](const Truth& t) { return t.operands() == Operands::triangles; });
  ChainedLog log;
  log_plan(log, method, triangles ? Operands::triangles : Operands::polygons, "the cases of a file", 0);
  log_own_cases(log, method, exam.cases, exam.truths, [&](std::size_t i) { return sheet.answers[i]; });
  return log;
}

/// The name of a directory for a method of this name: letters, digits, '-', '_'.
std::string directory_name(std::string name) {
  for (char& c : name) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '-') c = '_';
  }
  return name;
}

/// Writes one certificate into the directory itself, or several each into a numbered directory of its name.
std::string write_report(const std::string& out, std::vector<ChainedLog>& logs, const std::vector<Certificate>& all) {
  std::string text;
  for (std::size_t i = 0; i < logs.size(); ++i) {
    const std::string name = std::to_string(i + 1) + "-" + directory_name(all[i].method());
    const std::string directory = logs.size() == 1 ? out : out + "/" + name;
    make_directory(directory);
    write_certificate(directory, logs[i]);
    text += "see " + directory + "/certificate.md\n";
  }
  return text;
}

int run_cases(const Options& o) {
  if (o.cases == "-" && o.mesh.answers == "-")
    throw Failure(Exit::usage, "--cases and --answers are both standard input");
  const Exam exam = read_exam(o.cases, o.mesh.trial.threads);
  std::vector<ChainedLog> logs;
  std::vector<Certificate> all;
  std::string text;
  Count sum;
  for (const AnswerSheet& sheet : read_answers(o.mesh.answers, exam)) {
    logs.push_back(log_of(exam, sheet, contract_of(o)));
    all.push_back(certificate_from(logs.back().so_far(), o.mesh.answers));
    sum += all.back().own();
    text += to_summary(all.back());
  }
  if (sum.judged() == 0) throw bad_input(o.mesh.answers, 0, "no answer is \"ok\" and owed, nothing to judge");
  if (!o.mesh.trial.out.empty()) text += write_report(o.mesh.trial.out, logs, all);
  print(text);
  return code(sum.wrong > 0 ? Exit::disagreement : Exit::ok);
}

int run(const Options& o) {
  const bool rays = !o.mesh.rays.empty(), mesh = !o.mesh.trial.mesh.empty(), cases = !o.cases.empty();
  if (cases == (rays || mesh) || rays != mesh) {
    throw Failure(Exit::usage, "expected --cases, or --mesh and --rays, beside --answers");
  }
  if (cases) return run_cases(o);
  MeshAnswers answers = o.mesh;
  answers.promises.contract = contract_of(o);
  if (o.culls) answers.promises.contract.culling = Culling::back_faces;
  if (o.towards_source) answers.promises.sense = leak::NormalSense::towards_source;
  return judge_mesh_answers(answers);
}

}  // namespace

Action declare_judge(Arguments& arguments) {
  const auto o = std::make_shared<Options>();
  arguments.option("--cases", o->cases, "case file (JSON Lines); - is standard input");
  arguments.option("--answers", o->mesh.answers, "answer file (JSON Lines), one answer a case or ray, and method")
      .required();
  arguments
      .option("--convention", o->convention,
              "what the answers promise: closed; transversal (coplanar contacts are misses); open (so are contacts "
              "with the "
              "boundary); half-open (transversal, and nothing is promised of the boundary of a face alone)")
      .one_of(promise_words())
      .shows_default();
  add_threads_option(arguments, o->mesh.trial.threads);
  arguments.option("--out", o->mesh.trial.out,
                   "directory for the report, as certify writes it: certificate.json and .md, log.jsonl, "
                   "counterexamples.jsonl; a directory for each method if the answers name several. With --mesh, as "
                   "leak writes it");
  arguments.option("--mesh", o->mesh.trial.mesh,
                   "instead of cases: the mesh that rays were asked about, as `leak --rays-out` wrote it");
  arguments.option("--rays", o->mesh.rays, "its rays (JSON Lines)");
  arguments.flag("--culls", o->culls, "faces seen from behind are missed on purpose");
  arguments.flag("--sorted", o->mesh.promises.sorted, "each list of all hits begins with the nearest");
  arguments.option("--most-ulps", o->mesh.promises.most_ulps, "t of the closest hit is promised to so many ulps")
      .above_zero();
  arguments.option("--most-degrees", o->mesh.promises.most_degrees, "its normal is promised to so many degrees")
      .above_zero();
  arguments.flag("--normals-towards-source", o->towards_source,
                 "normals point to where the ray comes from (default: as the face's vertices turn)");
  arguments.flag("--by-aim", o->mesh.trial.by_aim, "show rays aimed at vertices, edges and faces apart");
  arguments.flag("--json", o->mesh.trial.json, "all counts as JSON instead of the table");
  arguments.needs("--rays", "--mesh");
  for (const char* option :
       {"--culls", "--sorted", "--most-ulps", "--most-degrees", "--normals-towards-source", "--by-aim", "--json"}) {
    arguments.needs(option, "--mesh");
  }
  return [o] { return run(*o); };
}

}  // namespace tribunal
