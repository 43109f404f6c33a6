// tribunal judge: answers computed anywhere, compared with the exact ones.
#include <algorithm>
#include <array>
#include <cctype>
#include <memory>

#include "exact/base/failure.h"
#include "exact/base/files.h"
#include "exact/base/json.h"
#include "exact/base/output.h"
#include "exact/certificate/certificate.h"
#include "exact/certificate/certify.h"
#include "exact/certificate/judge_files.h"
#include "exact/cli/command.h"
#include "tracer/cli/command.h"
#include "tracer/cli/judge_mesh.h"

namespace tribunal {
namespace {

struct Options {
  std::string cases{}, convention = "closed";
  std::string boundary{}, ends = "closed", bounds = "closed";
  bool culls = false, no_degenerate = false, towards_source = false;
  MeshAnswers mesh{};  ///< with the options that both ways to judge have
};

/// What the answers may promise, by the word that says it: how coplanar contacts are read, and in the same word most
/// often the boundary, of triangles and of rings alike.
struct Promise {
  std::string word;
  Convention convention = Convention::closed;
  Boundary boundary = Boundary::closed;
};

const std::vector<Promise>& promises() {
  static const std::vector<Promise> table = {{"closed"},
                                             {"transversal", Convention::transversal},
                                             {"open", Convention::transversal, Boundary::open},
                                             {"half-open", Convention::transversal, Boundary::half_open},
                                             {"unspecified", Convention::unspecified}};
  return table;
}

std::vector<std::string> promise_words() {
  std::vector<std::string> words;
  for (const Promise& p : promises()) words.push_back(p.word);
  return words;
}

constexpr std::array boundaries = {Boundary::closed, Boundary::open, Boundary::half_open, Boundary::unspecified};
constexpr std::array all_ends = {Ends::closed, Ends::open, Ends::unspecified};

template <class T, std::size_t n>
std::vector<std::string> words_of(const std::array<T, n>& values) {
  std::vector<std::string> words;
  for (const T value : values) words.emplace_back(name_of(value));
  return words;
}

/// The value of a word that the command line has checked.
template <class T, std::size_t n>
T value_named(const std::array<T, n>& values, const std::string& word) {
  return *std::ranges::find_if(values, [&](T value) { return name_of(value) == word; });
}

/// Rays with bounds are taken if any are asked about, so that the contract of all other answers reads as ever.
Contract contract_of(const Options& o, bool any_bounds) {
  const Promise& p = *std::ranges::find(promises(), o.convention, &Promise::word);
  const Boundary boundary = o.boundary.empty() ? p.boundary : value_named(boundaries, o.boundary);
  return {.probes = {.bounds = any_bounds},
          .triangles = o.no_degenerate ? Triangles::proper : Triangles::any,
          .polygons = Polygons::any,
          .convention = p.convention,
          .boundary = boundary,
          .polygon_boundary = boundary,
          .ends = value_named(all_ends, o.ends),
          .bounds = value_named(all_ends, o.bounds),
          .culling = o.culls ? Culling::back_faces : Culling::none};
}

/// The words that judge the same again: the files in the order given, and what the answers promise.
std::vector<std::string> command_of(const Options& o) {
  std::vector<std::string> words = {"judge"};
  const auto add = [&](const char* option, const std::string& value, const std::string& otherwise = "") {
    if (value != otherwise) words.insert(words.end(), {option, value});
  };
  const auto add_number = [&](const char* option, double value) {
    if (value > 0) add(option, Json(value).dump());
  };
  const auto add_flag = [&](const char* option, bool given) {
    if (given) words.emplace_back(option);
  };
  add("--cases", o.cases);
  add("--mesh", o.mesh.trial.mesh);
  add("--rays", o.mesh.rays);
  add("--answers", o.mesh.answers);
  add("--convention", o.convention, "closed");
  add("--boundary", o.boundary);
  add("--ends", o.ends, "closed");
  add("--bounds", o.bounds, "closed");
  add_flag("--culls", o.culls);
  add_flag("--no-degenerate", o.no_degenerate);
  add_flag("--sorted", o.mesh.promises.sorted);
  add_number("--most-ulps", o.mesh.promises.most_ulps);
  add_number("--most-degrees", o.mesh.promises.most_degrees);
  add_flag("--normals-towards-source", o.towards_source);
  return words;
}

/// The log of a trial that consists of these answers. It is about triangles if there are any.
ChainedLog log_of(const Options& o, const Judgement& judgement, const JudgedAnswers& answers) {
  ChainedLog log;
  const Operands operands = judgement.any_triangles ? Operands::triangles : Operands::polygons;
  log_plan(log, answers.method, operands, "the cases of a file", 0, command_of(o));
  log_own_cases(log, answers.method, answers.counts);
  log.finish();
  return log;
}

/// The name of a directory for a method of this name: letters, digits, '-', '_'.
std::string directory_name(std::string name) {
  for (char& c : name) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '-') c = '_';
  }
  return name;
}

/// Writes one certificate into the directory itself, or several each into a numbered directory of its name; none is
/// put into its place before all are written.
std::string write_report(const std::string& out, std::vector<ChainedLog>& logs, const std::vector<Certificate>& all) {
  std::string text;
  std::vector<OutputSet> sets(logs.size());
  for (std::size_t i = 0; i < logs.size(); ++i) {
    const std::string name = std::to_string(i + 1) + "-" + directory_name(all[i].method());
    const std::string directory = logs.size() == 1 ? out : out + "/" + name;
    make_directory(directory);
    add_certificate(sets[i], directory, logs[i]);
    sets[i].prepare();
    text += "see " + directory + "/certificate.md\n";
  }
  for (OutputSet& set : sets) set.commit();
  return text;
}

int run_cases(const Options& o) {
  if (o.cases == "-" && o.mesh.answers == "-")
    throw Failure(Exit::usage, "--cases and --answers are both standard input");
  const Rereadable cases(o.cases), answers(o.mesh.answers);
  Judgement judgement = judge_files(cases, answers, contract_of(o, true), o.mesh.trial.threads);
  std::vector<ChainedLog> logs;
  std::vector<Certificate> all;
  std::string text;
  Count sum;
  std::uint64_t answered = 0, nonfinite = 0;
  for (JudgedAnswers& of_method : judgement.methods) {
    of_method.method.contract = contract_of(o, judgement.any_bounds);
    logs.push_back(log_of(o, judgement, of_method));
    of_method.counts = {};
    all.push_back(certificate_from(Log(logs.back())));
    sum += all.back().own();
    answered += all.back().all_nonfinite().answered;
    nonfinite += all.back().all_nonfinite().refused;
    text += to_summary(all.back());
  }
  if (sum.judged() + answered + nonfinite == 0) {
    throw bad_input(o.mesh.answers, 0,
                    std::string("no answer is \"ok\" and owed, nothing to judge") +
                        (o.culls ? "; with --culls none is owed about pierced polygons" : ""));
  }
  if (!o.mesh.trial.out.empty()) text += write_report(o.mesh.trial.out, logs, all);
  print(text);
  return code(sum.wrong + answered > 0 ? Exit::disagreement : Exit::ok);
}

int run(const Options& o) {
  const bool rays = !o.mesh.rays.empty(), mesh = !o.mesh.trial.mesh.empty(), cases = !o.cases.empty();
  if (cases == (rays || mesh) || rays != mesh) {
    throw Failure(Exit::usage, "expected --cases, or --mesh and --rays, beside --answers");
  }
  if (cases) return run_cases(o);
  MeshAnswers answers = o.mesh;
  answers.trial.command = command_of(o);
  answers.promises.contract = contract_of(o, false);
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
      .option(
          "--convention", o->convention,
          "what the answers promise: closed; transversal (coplanar contacts are misses); open (so are contacts "
          "with the "
          "boundary); half-open (transversal, and nothing is promised of the boundary of a face alone); unspecified "
          "(nothing is promised of coplanar contacts)")
      .one_of(promise_words())
      .shows_default();
  arguments
      .option("--boundary", o->boundary, "of contacts with edges and vertices, if it is not what --convention says")
      .one_of(words_of(boundaries));
  arguments.option("--ends", o->ends, "of contacts by an end of the probe alone: hits, misses, or nothing is promised")
      .one_of(words_of(all_ends))
      .shows_default();
  arguments.option("--bounds", o->bounds, "the same of tmin and tmax, where a ray has bounds")
      .one_of(words_of(all_ends))
      .shows_default();
  arguments.flag("--no-degenerate", o->no_degenerate,
                 "nothing is promised of triangles without area and of probes that are points");
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
       {"--sorted", "--most-ulps", "--most-degrees", "--normals-towards-source", "--by-aim", "--json"}) {
    arguments.needs(option, "--mesh");
  }
  return [o] { return run(*o); };
}

}  // namespace tribunal
