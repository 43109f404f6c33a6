// tribunal leak: is a test watertight on this mesh?
#include <algorithm>
#include <memory>

#include "exact/base/failure.h"
#include "exact/base/files.h"
#include "exact/base/output.h"
#include "exact/cli/command.h"
#include "exact/mesh/read_mesh.h"
#include "exact/mesh/triangulate.h"
#include "exact/methods/methods.h"
#include "exact/plugin/load.h"
#include "tracer/cli/command.h"
#include "tracer/cli/mesh_trial.h"
#include "tracer/leak/mesh_subject.h"
#include "tracer/leak/ray_files.h"

namespace tribunal {
namespace {

using namespace leak;

struct Options {
  MeshTrialOptions trial{};
  std::string methods{}, format = "both", rays_out{};
  std::uint64_t rays = 0;
  bool every_face = false;
};

/// The methods on trial; without names and plugins, the flagship and all methods that are not exact.
std::vector<Method> methods_of(const Options& o) {
  if (o.methods.empty() && !loaded_meshes().empty() && loaded_methods().empty()) return {};
  if (!o.methods.empty() || !loaded_methods().empty()) return methods_on_trial(o.methods);
  std::vector<Method> methods;
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

/// A line for each method that was left out because it takes no rays.
std::string not_asked(const std::vector<Method>& methods) {
  std::string text;
  for (const Method& m : methods) {
    if (!takes_rays(m)) text += m.name + " takes no rays of triangles: not asked\n";
  }
  return text;
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

/// Adds the trial of one format, if there is anybody to ask. Returns the signal that ended it early, or 0.
int run_format(MeshTrial& trial, const Options& o, const Mesh& mesh, const std::vector<Method>& methods,
               Format format) {
  const Surface surface(mesh, format, o.trial.mesh);
  const std::vector<Subject> subjects = subjects_on(surface, methods);
  if (subjects.empty()) return 0;
  const LeakReport report = run_leak_trial(surface, subjects,
                                           {.seed = o.trial.seed,
                                            .rays = rays_of(o, surface),
                                            .threads = o.trial.threads,
                                            .every_face = o.every_face,
                                            .keep = o.trial.keep});
  if (report.complete) add(trial, o.trial, surface, subjects, report);
  return report.signal;
}

/// Writes the rays of each format, and the mesh that they were aimed at. Nobody is asked.
int write_rays(const Options& o, const Mesh& mesh) {
  make_directory(o.rays_out);
  OutputSet set;
  std::string written;
  for (const Format format : formats_of(o)) {
    const Surface surface(mesh, format, o.trial.mesh);
    std::string lines;
    std::size_t count = 0;
    for (std::uint64_t k = 0; k < rays_of(o, surface); ++k) {
      const std::optional<AimedRay> aimed = aimed_ray(surface, o.trial.seed, k);
      if (!aimed) continue;
      lines += to_line(surface, *aimed, k);
      ++count;
    }
    if (count == 0) throw Failure(Exit::resources, o.trial.mesh + ": no start off the surface was found");
    const std::string name = o.rays_out + "/" + std::string(name_of(format));
    set.add(name + ".off", to_off(surface));
    set.add(name + ".jsonl", lines);
    written += std::to_string(count) + " rays in " + name + ".jsonl, aimed at " + name + ".off\n";
  }
  set.commit();
  print(written);
  return 0;
}

/// The words that make the same trial. Of the methods that were named, those that could be asked.
std::vector<std::string> command_of(const Options& o, const std::vector<Method>& methods) {
  std::vector<std::string> words = {"leak", o.trial.mesh};
  std::string asked;
  for (const Method& m : methods) {
    if (takes_rays(m)) asked += (asked.empty() ? "" : ",") + m.name;
  }
  if (!o.methods.empty()) words.insert(words.end(), {"--method", asked});
  words.insert(words.end(), {"--format", o.format, "--seed", std::to_string(o.trial.seed)});
  if (o.rays > 0) words.insert(words.end(), {"--rays", std::to_string(o.rays)});
  if (o.every_face) words.emplace_back("--every-face");
  return words;
}

int run(Options o) {
  const Mesh mesh = triangulated(read_mesh(o.trial.mesh), o.trial.mesh);
  if (!o.rays_out.empty()) return write_rays(o, mesh);
  const std::vector<Method> methods = methods_of(o);
  if (loaded_meshes().empty() && std::ranges::none_of(methods, takes_rays))
    throw Failure(Exit::usage, "no method given that takes rays of triangles");
  o.trial.command = command_of(o, methods);
  MeshTrial trial;
  for (const Format format : formats_of(o)) {
    const int signal = run_format(trial, o, mesh, methods, format);
    if (signal != 0) return print("INTERRUPTED\n"), exit_code_after(code(Exit::ok), signal);
  }
  if (trial.text.empty()) throw Failure(Exit::usage, "no method given that takes rays of " + o.format);
  return finish(trial, o.trial, not_asked(methods));
}

}  // namespace

Action declare_leak(Arguments& arguments) {
  const auto o = std::make_shared<Options>();
  arguments.option("MESH", o->trial.mesh, "mesh file (OFF, OBJ, PLY, STL)").required();
  add_methods_option(arguments, o->methods, "the certified one and all that are not exact");
  arguments.option("--format", o->format, "of the rays, and of the mesh, which is rounded to it")
      .one_of({"binary64", "binary32", "both"})
      .shows_default();
  arguments.option("--rays", o->rays, "rays, of each format (default: four for each vertex, edge and face)")
      .above_zero();
  arguments.option("--seed", o->trial.seed, "seed of the rays").shows_default();
  add_threads_option(arguments, o->trial.threads);
  arguments.option("--out", o->trial.out, "directory for summary.json, cases.jsonl and painted meshes (PLY)");
  arguments.option("--keep", o->trial.keep, "cases to write, a method and kind of error").shows_default();
  arguments.flag("--by-aim", o->trial.by_aim, "show rays aimed at vertices, edges and faces apart");
  arguments.flag("--every-face", o->every_face, "ask about every face, not only those whose boxes the ray meets");
  arguments.option("--rays-out", o->rays_out,
                   "directory for the rays of each format and the mesh that they are aimed at, as files; nobody is "
                   "asked: answer the rays where you are, and see `tribunal judge --mesh`");
  arguments.flag("--json", o->trial.json, "all counts as JSON instead of the table");
  Action action = with_plugins(arguments, [o] { return run(*o); });
  for (const char* other : {"--method", "--plugin", "--out", "--json"}) arguments.excludes("--rays-out", other);
  return action;
}

}  // namespace tribunal
