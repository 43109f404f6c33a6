// tribunal chart: speed and accuracy on the same cases, as figures and as the numbers behind them.
#include "exact/chart/chart.h"

#include <algorithm>
#include <iterator>
#include <memory>
#include <vector>

#include "exact/base/failure.h"
#include "exact/base/files.h"
#include "exact/base/interrupt.h"
#include "exact/base/json.h"
#include "exact/base/output.h"
#include "exact/mesh/read_mesh.h"
#include "exact/mesh/triangulate.h"
#include "exact/methods/methods.h"
#include "exact/report/shapes.h"
#include "tracer/chart/leaks.h"
#include "tracer/chart/pictures.h"
#include "tracer/cli/command.h"
#include "tracer/scene/read_scene.h"

namespace tribunal {
namespace {

/// Where the scenes and the mesh are that are taken if none are named, seen from the repository.
constexpr const char* shipped_scenes = "data/scenes";
constexpr const char* shipped_mesh = "data/meshes/cow.off";
constexpr const char* nothing = "none";

struct Options {
  std::string methods, out = "charts", redraw, scenes, mesh;
  ChartPlan plan;
  std::uint64_t rays = 50'000;
  bool quick = false;
};

bool takes_pairs(const Method& m) {
  return std::ranges::any_of(all_populations(), [&](const Population& p) { return takes(m, p); });
}

/// Figures with all rivals cannot be read: of the methods with an exact twin only those with the role are drawn.
bool is_charted(const Method& m) { return !has(m, Capability::exact_twin) || has_role(m, Role::charted); }

ChartPlan plan_of(const Options& o) {
  ChartPlan plan = o.plan;
  if (o.quick) {
    plan.cases = std::min<std::uint64_t>(plan.cases, 3'260);
    plan.repetitions = std::min(plan.repetitions, 9);
  }
  if (o.methods.empty() || o.methods == "all") {
    std::ranges::copy_if(all_methods(), std::back_inserter(plan.methods),
                         [&](const Method& m) { return takes_pairs(m) && (!o.methods.empty() || is_charted(m)); });
  } else {
    plan.methods = methods_named(o.methods);
  }
  for (const Method& m : plan.methods) {
    if (!takes_pairs(m)) {
      throw Failure(Exit::usage, m.name +
                                     ": a chart asks segments and triangles, or polygons, which it does not take (" +
                                     in_words(m.contract) + ")");
    }
  }
  return plan;
}

/// A method of which no answer was judged has no accuracy to draw.
void require_judged(const ChartPlan& plan, const Chart& chart) {
  for (std::size_t m = 0; m < plan.methods.size(); ++m) {
    const auto judged = [&](const ChartRow& row) { return row.method == m && row.count.judged() > 0; };
    if (std::ranges::any_of(chart.rows, judged)) continue;
    throw Failure(Exit::usage, plan.methods[m].name + ": nothing was judged, its contract owes an answer to no case");
  }
}

// --- scenes and a mesh ----------------------------------------------------------------------------------------------

/// The files of a folder of scenes, or the one file.
std::vector<std::string> scene_files(const std::string& path) {
  if (!is_directory(path)) return {path};
  std::vector<std::string> files = files_in(path);
  std::erase_if(files, [](const std::string& file) { return !file.ends_with(".json"); });
  if (files.empty()) throw bad_input(path, 0, "no scene, expected files that end in .json");
  return files;
}

/// What is named, or what is shipped if it is there; nothing if it is not wanted.
std::string source_of(const std::string& named, const char* shipped) {
  if (named == nothing) return {};
  if (!named.empty()) return named;
  return exists(shipped) ? shipped : "";
}

/// Scenes are read before anything is measured, so that a fault in one costs no time.
std::vector<Scene> scenes_of(const Options& o) {
  std::vector<Scene> scenes;
  const std::string source = source_of(o.scenes, shipped_scenes);
  if (source.empty()) return scenes;
  for (const std::string& file : scene_files(source)) {
    scenes.push_back(read_scene(file));
    if (!o.quick) continue;
    for (int* side : {&scenes.back().camera.width, &scenes.back().camera.height}) *side = std::max(1, *side / 8);
  }
  return scenes;
}

/// So is the mesh, in either format; none if it is not wanted.
std::vector<leak::Surface> mesh_of(const Options& o) {
  const std::string file = source_of(o.mesh, shipped_mesh);
  if (file.empty()) return {};
  return surfaces_of(triangulated(read_mesh(file), file), file);
}

void add_pictures(const Options& o, const ChartPlan& plan, std::vector<Scene> scenes, Json& record) {
  if (scenes.empty()) return print("no scenes: rays a second against wrong pixels is not drawn\n");
  const PicturePlan pictures{
      .methods = plan.methods, .scenes = std::move(scenes), .repetitions = o.quick ? 1 : 6, .threads = plan.threads};
  const std::vector<PictureRow> rows = measure_pictures(pictures);
  record["pictures"] = to_json(pictures, rows);
  print(to_table(pictures, rows));
}

void add_leaks(const Options& o, const ChartPlan& plan, std::span<const leak::Surface> surfaces, Json& record) {
  if (surfaces.empty()) return print("no mesh: leaks are not drawn\n");
  const LeakChartPlan leaks{.methods = plan.methods,
                            .mesh = source_of(o.mesh, shipped_mesh),
                            .seed = plan.seed,
                            .rays = o.quick ? std::min<std::uint64_t>(o.rays, 2'000) : o.rays,
                            .threads = plan.threads};
  const std::vector<LeakRow> rows = measure_leaks(leaks, surfaces);
  record["leaks"] = to_json(leaks, rows);
  print(to_table(leaks, rows));
}

/// The record is written after each part: what was measured stays if a later part fails or is interrupted.
template <class Measure>
void add_part(const Options& o, Json& record, const Measure& measure) {
  const std::string kept = o.out + "/chart.json holds the parts before, and --redraw draws them";
  const IfInterrupted note(kept);
  try {
    measure();
  } catch (const Failure& failure) {
    throw Failure(failure.exit(), std::string(failure.what()) + "; " + kept);
  }
  write_chart(o.out, record);
}

// --- the command ----------------------------------------------------------------------------------------------------

int draw(const std::string& directory, const std::string& also) {
  std::string names;
  for (const std::string& figure : plot(directory)) names += (names.empty() ? "" : ", ") + figure;
  print("written to " + directory + ": " + names + ", each as .svg, .pdf and .png; " + also + "plot.py\n");
  return 0;
}

/// From the record alone; nothing is measured.
int redraw(const std::string& directory) {
  const std::string file = directory + "/chart.json";
  const Json record = parse_json(read_file(file), {file});
  require_chart_record({record, {file}});
  return draw(directory, "");
}

/// The words that measure the same again, but for --out and for --threads, which change nothing that is measured.
Json command_of(const Options& o, const ChartPlan& plan) {
  const auto or_none = [](const std::string& file) { return file.empty() ? nothing : file; };
  std::vector<std::string> words = {"chart"};
  if (!o.methods.empty()) words.insert(words.end(), {"--method", o.methods});
  words.insert(words.end(),
               {"--seed", std::to_string(plan.seed), "--count", std::to_string(plan.cases), "--repetitions",
                std::to_string(plan.repetitions), "--scenes", or_none(source_of(o.scenes, shipped_scenes)), "--mesh",
                or_none(source_of(o.mesh, shipped_mesh)), "--rays", std::to_string(o.rays)});
  if (o.quick) words.emplace_back("--quick");
  return words;
}

int run(const Options& o) {
  if (!o.redraw.empty()) return redraw(o.redraw);
  const ChartPlan plan = plan_of(o);
  std::vector<Scene> scenes = scenes_of(o);
  const std::vector<leak::Surface> surfaces = mesh_of(o);
  make_directory(o.out);
  const Chart chart = measure(plan);
  require_judged(plan, chart);
  print(to_table(plan, chart));
  Json record = to_json(plan, chart);
  record["command"] = command_of(o, plan);
  write_chart(o.out, record);
  add_part(o, record, [&] { add_pictures(o, plan, std::move(scenes), record); });
  add_part(o, record, [&] { add_leaks(o, plan, surfaces, record); });
  return draw(o.out, "chart.json, ");
}

}  // namespace

Action declare_chart(Arguments& arguments) {
  const auto o = std::make_shared<Options>();
  arguments.option("--method,--methods", o->methods,
                   "methods, separated by commas, or all (default all but most rivals)");
  arguments.option("--seed", o->plan.seed, "seed of the cases").shows_default();
  arguments.option("--count", o->plan.cases, "cases judged and timed, of each population and format")
      .above_zero()
      .shows_default();
  arguments
      .option("--repetitions", o->plan.repetitions,
              "times that every method is timed on cases; scenes are drawn six times, slow methods once, with --quick "
              "all once")
      .between(9, 10'000)
      .shows_default();
  arguments.option(
      "--scenes", o->scenes,
      std::string("folder of scenes, or one scene, to draw; or none (default ") + shipped_scenes + " if it is there)");
  arguments.option(
      "--mesh", o->mesh,
      std::string("mesh on which leaks are counted; or none (default ") + shipped_mesh + " if it is there)");
  arguments.option("--rays", o->rays, "rays of each format at the mesh").above_zero().shows_default();
  arguments.flag("--quick", o->quick, "a first look in under a minute: fewer cases, small pictures, fewer rays");
  add_threads_option(arguments, o->plan.threads);
  arguments.option("--out", o->out, "directory for the figures and chart.json").shows_default();
  arguments.option("--redraw", o->redraw,
                   "draw the figures of chart.json in this directory again; nothing is measured");
  for (const char* other : {"--method", "--seed", "--count", "--repetitions", "--scenes", "--mesh", "--rays", "--quick",
                            "--threads", "--out"})
    arguments.excludes("--redraw", other);
  return with_plugins(
      arguments, [o] { return run(*o); }, MayIsolate::no);
}

}  // namespace tribunal
