// tribunal leak: is a test watertight on this mesh?
#include <algorithm>
#include <filesystem>
#include <memory>

#include "exact/base/failure.h"
#include "exact/base/files.h"
#include "exact/cli/command.h"
#include "exact/mesh/read_mesh.h"
#include "exact/mesh/triangulate.h"
#include "exact/methods/methods.h"
#include "exact/plugin/load.h"
#include "exact/record/counterexample.h"
#include "exact/record/environment.h"
#include "tracer/cli/command.h"
#include "tracer/leak/mesh_subject.h"
#include "tracer/leak/report.h"

namespace tribunal {
namespace {

using namespace leak;

struct Options {
  std::string mesh, methods, format = "both", out;
  std::uint64_t seed = 1, rays = 0;
  unsigned threads = 1;
  std::size_t keep = 4;
  bool every_face = false, by_aim = false, json = false;
};

bool takes_rays(const Method& m) { return m.contract.probes.rays && m.contract.triangles != Triangles::none; }

/// The methods named on the command line; if none, those of the plugins; if there are no plugins, the flagship and
/// all methods that are not exact.
std::vector<Method> methods_of(const Options& o) {
  if (!o.methods.empty()) return methods_named(o.methods);
  std::vector<Method> methods;
  for (const std::string& name : loaded_methods()) methods.push_back(*find_method(name));
  if (!loaded_methods().empty() || !loaded_meshes().empty()) return methods;
  methods.push_back(flagship_method());
  for (const Method& m : all_methods()) {
    if (!m.contract.exact && m.contract.triangles != Triangles::none) methods.push_back(m);
  }
  return methods;
}

std::vector<Format> formats_of(const Options& o) {
  if (o.format == name_of(Format::binary32)) return {Format::binary32};
  if (o.format == name_of(Format::binary64)) return {Format::binary64};
  return {Format::binary64, Format::binary32};
}

/// Four rays for each vertex, edge and face, but no fewer than 200,000 and no more than 2 million.
std::uint64_t rays_of(const Options& o, const Surface& s) {
  if (o.rays > 0) return o.rays;
  const std::uint64_t marks = s.vertices().size() + s.edges().size() + s.face_count();
  return std::clamp<std::uint64_t>(4 * marks, 200'000, 2'000'000);
}

std::string about(const Surface& s, const LeakReport& r) {
  std::string text = std::string(name_of(s.format())) + ": " + std::to_string(s.face_count()) + " faces, " +
                     describe(s.topology()) + "; " + std::to_string(r.rays) + " rays, " + std::to_string(r.inside) +
                     " from inside, " + std::to_string(r.exactly) + " exactly through an edge or a vertex";
  if (r.skipped > 0) text += "; " + std::to_string(r.skipped) + " not judged: no start off the surface was found";
  if (!s.topology().closed()) text += "\nthe mesh is not closed: it has no inside, and parity is not judged";
  return text + "\n";
}

/// A line for each method that was left out because it takes no rays.
std::string not_asked(const std::vector<Method>& methods) {
  std::string text;
  for (const Method& m : methods) {
    if (!takes_rays(m)) text += m.name + " takes no rays of triangles: not asked\n";
  }
  return text;
}

/// One format's trial, and what is to be shown and written of it.
struct Trial {
  std::string text{}, verdicts{};
  Json summary{};
  std::vector<Case> cases{};
  std::vector<std::pair<std::string, std::string>> pictures{};  ///< file names and contents
  bool erred = false, complete = true;
  int signal = 0;
};

/// "my-tree/closest" as part of a file's name.
std::string file_name(const Subject& subject) {
  std::string name = subject.name;
  std::ranges::replace(name, '/', '-');
  return name;
}

void add_findings(Trial& trial, const Options& o, const Surface& surface, const Subject& subject,
                  const SubjectReport& report) {
  const auto cases = cases_of(surface, subject, report, std::filesystem::path(o.mesh).filename().string(), o.seed);
  trial.cases.insert(trial.cases.end(), cases.begin(), cases.end());
  const std::string file = file_name(subject) + "-" + std::string(name_of(surface.format())) + ".ply";
  if (has_erred(report)) trial.pictures.emplace_back(file, painted(surface, report));
}

/// All that take the surface's format: methods, face by face, and the trees of plugins.
std::vector<Subject> subjects_on(const Surface& surface, const std::vector<Method>& methods) {
  const auto takes_format = [&](const Contract& c) {
    return c.format == Format::binary64 || surface.format() == Format::binary32;
  };
  std::vector<Subject> subjects;
  for (const Method& m : methods) {
    if (takes_rays(m) && takes_format(m.contract)) subjects.push_back(subject_of(m, surface));
  }
  for (const MeshPlugin& plugin : loaded_meshes()) {
    if (!takes_format(plugin.contract)) continue;
    for (Subject& s : subjects_of(plugin, surface)) subjects.push_back(std::move(s));
  }
  return subjects;
}

Trial run_format(const Options& o, const Mesh& mesh, const std::vector<Method>& methods, Format format) {
  const Surface surface(mesh, format, o.mesh);
  const std::vector<Subject> subjects = subjects_on(surface, methods);
  if (subjects.empty()) return {};
  const LeakReport report = run_leak_trial(
      surface, subjects,
      {.seed = o.seed, .rays = rays_of(o, surface), .threads = o.threads, .every_face = o.every_face, .keep = o.keep});
  Trial trial{.complete = report.complete, .signal = report.signal};
  if (report.complete && report.rays == 0) throw Failure(Exit::resources, o.mesh + ": no ray could be judged");
  trial.text = about(surface, report) + table(subjects, report, format, o.by_aim);
  trial.summary = summary(surface, subjects, report);
  for (std::size_t i = 0; i < subjects.size(); ++i) {
    const SubjectReport& s = report.subjects[i];
    trial.erred |= has_erred(s);
    trial.verdicts += verdict(subjects[i], s, format) + worst_faces(s, 3);
    if (!o.out.empty()) add_findings(trial, o, surface, subjects[i], s);
  }
  return trial;
}

void write(const Options& o, const std::vector<Trial>& trials, const Json& summary) {
  make_directory(o.out);
  std::vector<Case> cases;
  for (const Trial& t : trials) {
    cases.insert(cases.end(), t.cases.begin(), t.cases.end());
    for (const auto& [file, bytes] : t.pictures) write_file(o.out + "/" + file, bytes);
  }
  write_file(o.out + "/summary.json", summary.dump(1) + "\n");
  write_file(o.out + "/cases.jsonl", to_lines(cases));
}

Json summary_of(const Options& o, const std::vector<Trial>& trials) {
  Json formats = Json::array();
  for (const Trial& t : trials) formats.push_back(t.summary);
  return {{"mesh", std::filesystem::path(o.mesh).filename().string()},
          {"seed", o.seed},
          {"trials", formats},
          {"environment", environment()}};
}

void show(const Options& o, const std::vector<Trial>& trials, const Json& summary, const std::string& first) {
  if (o.json) return print(summary.dump(1) + "\n");
  print(first);
  for (const Trial& t : trials) print(t.text + "\n");
  for (const Trial& t : trials) print(t.verdicts);
  if (o.out.empty()) return;
  std::size_t cases = 0;
  for (const Trial& t : trials) cases += t.cases.size();
  print(std::to_string(cases) + " cases in " + o.out + "/cases.jsonl" +
        (cases == 0 ? "" : "; `tribunal replay` shows them") + "\n");
}

int run(const Options& o) {
  const Mesh mesh = triangulated(read_mesh(o.mesh), o.mesh);
  const std::vector<Method> methods = methods_of(o);
  if (loaded_meshes().empty() && std::ranges::none_of(methods, takes_rays))
    throw Failure(Exit::usage, "no method given that takes rays of triangles");
  std::vector<Trial> trials;
  for (const Format format : formats_of(o)) {
    Trial trial = run_format(o, mesh, methods, format);
    if (!trial.complete) return print("INTERRUPTED\n"), exit_code_after(code(Exit::ok), trial.signal);
    if (!trial.text.empty()) trials.push_back(std::move(trial));
  }
  if (trials.empty()) throw Failure(Exit::usage, "no method given that takes rays of " + o.format);
  const Json summary = summary_of(o, trials);
  if (!o.out.empty()) write(o, trials, summary);
  show(o, trials, summary, not_asked(methods));
  const bool erred = std::ranges::any_of(trials, &Trial::erred);
  return code(erred ? Exit::disagreement : Exit::ok);
}

}  // namespace

Action declare_leak(Arguments& arguments) {
  const auto o = std::make_shared<Options>();
  arguments.option("MESH", o->mesh, "mesh file (OFF, OBJ, PLY, STL)").required();
  arguments.option("--method", o->methods,
                   "methods, separated by commas (default: those of plugins; without any, the certified one and all "
                   "that are not exact)");
  arguments.option("--format", o->format, "of the rays, and of the mesh, which is rounded to it")
      .one_of({"binary64", "binary32", "both"})
      .shows_default();
  arguments.option("--rays", o->rays, "rays, of each format (default: four for each vertex, edge and face)")
      .whole_number()
      .above_zero();
  arguments.option("--seed", o->seed, "seed of the rays").whole_number().shows_default();
  add_threads_option(arguments, o->threads);
  arguments.option("--out", o->out, "directory for summary.json, cases.jsonl and painted meshes (PLY)");
  arguments.option("--keep", o->keep, "cases to write, a method and kind of error").whole_number().shows_default();
  arguments.flag("--by-aim", o->by_aim, "show rays aimed at vertices, edges and faces apart");
  arguments.flag("--every-face", o->every_face, "ask about every face, not only those whose boxes the ray meets");
  arguments.flag("--json", o->json, "all counts as JSON instead of the table");
  return with_plugins(
      arguments, [o] { return run(*o); }, MayIsolate::no);
}

}  // namespace tribunal
