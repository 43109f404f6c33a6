// tribunal sweep: what becomes of every method's answers along stress axes.
#include "exact/sweep/sweep.h"

#include <algorithm>
#include <memory>

#include "exact/base/embedded.h"
#include "exact/base/failure.h"
#include "exact/base/figures.h"
#include "exact/base/files.h"
#include "exact/base/output.h"
#include "exact/base/suggestion.h"
#include "exact/cases/case_io.h"
#include "exact/cli/command.h"
#include "exact/compilers/compare.h"
#include "exact/report/shapes.h"
#include "exact/sweep/map.h"
#include "exact/sweep/record.h"

namespace tribunal {
namespace {

/// The axis whose values are builds of one source: it changes the methods, not the cases, so it has a run of its own.
constexpr std::string_view compiler_axis = "compiler";

/// Asked where the axis takes them, if no method is named.
constexpr const char* default_methods = "sf-float,sf-double,mt-double,sf-filtered";

struct Options {
  std::string methods, axes, mesh, out = "sweep", redraw, map, probe = "segment", pixel;
  int map_size = 256;
  SweepPlan plan;
  MeshAxisMaker of_mesh;
};

[[noreturn]] void fail_unknown_axis(const std::string& name, const Options& o) {
  std::vector<std::string> names;
  for (const StressAxis& a : all_stress_axes()) names.emplace_back(a.name);
  names.emplace_back(o.of_mesh.name);
  names.emplace_back(compiler_axis);
  throw Failure(Exit::usage,
                "unknown axis \"" + name + "\"" + suggestion(name, names, "one that `tribunal sweep --help` lists"));
}

/// The axis of this name; that of the mesh is made when it is first asked for.
const StressAxis* axis_named(const std::string& name, const Options& o, SweepPlan& plan) {
  if (const StressAxis* found = find_stress_axis(name)) return found;
  if (name != o.of_mesh.name) fail_unknown_axis(name, o);
  if (!plan.of_mesh) plan.of_mesh = o.of_mesh.of_file(o.mesh);
  return plan.of_mesh->axis.get();
}

/// All axes, if none is named.
void set_axes(SweepPlan& plan, const Options& o) {
  std::vector<std::string> names = split(o.axes);
  if (o.axes.empty()) {
    names.clear();
    for (const StressAxis& a : all_stress_axes()) names.emplace_back(a.name);
    names.emplace_back(o.of_mesh.name);
  }
  for (const std::string& name : names) {
    const StressAxis* axis = axis_named(name, o, plan);
    if (std::ranges::find(plan.axes, axis) != plan.axes.end())
      throw Failure(Exit::usage, "axis " + name + " is named twice");
    plan.axes.push_back(axis);
  }
  if (!o.mesh.empty() && !plan.of_mesh)
    throw Failure(Exit::usage,
                  "--mesh: none of the axes aims at a mesh, expected --axis " + std::string(o.of_mesh.name));
}

std::string axis_help(const MeshAxisMaker& of_mesh) {
  const auto entry = [](std::string_view name, std::string_view quantity) {
    return " " + std::string(name) + " (" + std::string(quantity) + ")";
  };
  std::string text = "axes, separated by commas (default all):";
  for (const StressAxis& a : all_stress_axes()) text += entry(a.name, a.quantity);
  text += entry(of_mesh.name, of_mesh.quantity);
  return text + "; or alone: " + std::string(compiler_axis) + " (the naive methods, built otherwise)";
}

bool is_asked(const SweepPlan& plan, const Method& m) {
  return std::ranges::any_of(plan.axes, [&](const StressAxis* a) { return takes(m, *a); });
}

/// A method that takes the operands and probes of none of the axes would be asked nothing, and that is no success.
void require_asked(const SweepPlan& plan) {
  for (const Method& m : plan.methods) {
    if (is_asked(plan, m)) continue;
    throw Failure(Exit::usage, m.name + ": none of the axes asks what it takes (" + in_words(m.contract) + ")");
  }
}

/// The figures that are drawn of a record.
FigureNames figures_of(const std::string& record) {
  if (record == "sweep.json") return sweep_figures;
  return {record.substr(0, record.size() - std::string_view(".json").size())};
}

/// A record that is a file by itself, and its figure.
void write_and_draw(const std::string& directory, const std::string& record, const std::string& text) {
  OutputSet set;
  drop_figures(set, directory, figures_of(record));
  set.add(directory + "/" + record, text);
  set.commit();
  draw_figures(directory, embedded_sweep_script, record, figures_of(record));
}

// --- failure maps ---------------------------------------------------------------------------------------------------

std::vector<std::string> map_names() {
  std::vector<std::string> names;
  for (const MapContact& c : all_map_contacts()) names.emplace_back(c.name);
  return names;
}

std::string file_of(const MapKind& map) { return "map-" + map.name() + ".json"; }

constexpr ProbeKind probe_kinds[] = {ProbeKind::segment, ProbeKind::ray};

MapKind map_of(const Options& o) {
  const bool is_ray = o.probe == name_of(ProbeKind::ray);
  return {find_map_contact(o.map), is_ray ? ProbeKind::ray : ProbeKind::segment, o.map_size};
}

MapPlan map_plan_of(const Options& o, const MapKind& map) {
  MapPlan plan{.methods = methods_on_trial(o.methods, default_methods), .map = map, .threads = o.plan.threads};
  for (const Method& m : plan.methods) {
    const Probes& probes = m.contract.probes;
    const bool takes_probe = map.probe == ProbeKind::ray ? probes.rays : probes.segments;
    if (takes_probe && m.contract.triangles != Triangles::none) continue;
    throw Failure(Exit::usage, m.name + ": this map asks " + o.probe + "s and triangles, which it does not take (" +
                                   in_words(m.contract) + ")");
  }
  return plan;
}

int coordinate_of(const std::string& text, int size) {
  const bool is_number = !text.empty() && text.size() < 6 && text.find_first_not_of("0123456789") == std::string::npos;
  const int value = is_number ? std::stoi(text) : -1;
  if (value >= 0 && value < size) return value;
  throw Failure(Exit::usage, "--pixel: \"" + text + "\", expected a number from 0 to " + std::to_string(size - 1));
}

/// The pixel as a case, with what the exact answer is.
int print_pixel(const Options& o, const MapKind& map) {
  const std::vector<std::string> parts = split(o.pixel);
  if (parts.size() != 3) throw Failure(Exit::usage, "--pixel: \"" + o.pixel + "\", expected METHOD,X,Y");
  const Method method = methods_named(parts[0]).front();
  const Format format = method.contract.format;
  Case c{
      .format = format,
      .query = query_of_pixel(map, format, coordinate_of(parts[1], o.map_size), coordinate_of(parts[2], o.map_size))};
  const Truth truth = exact_truth(c.query);
  c.id = "map-" + map.name() + "-" + std::string(name_of(format)) + "-" + parts[1] + "-" + parts[2];
  c.expect = truth.hit();
  c.class_id = truth.class_id;
  c.source = "failure map " + map.name() + ", " + std::to_string(o.map_size) + " pixels a side";
  print(from_case(c).dump() + "\n");
  return 0;
}

int run_map(const Options& o) {
  const MapKind kind = map_of(o);
  if (!o.pixel.empty()) return print_pixel(o, kind);
  const MapPlan plan = map_plan_of(o, kind);
  make_directory(o.out);
  const FailureMap map = failure_map(plan);
  print(to_table(plan, map));
  write_and_draw(o.out, file_of(kind), to_json_text(plan, map));
  const std::string name = "map-" + kind.name();
  print("written: " + o.out + "/" + name + ".json, " + name + ".svg, " + name + ".png, plot.py\n");
  return 0;
}

// --- compilers ------------------------------------------------------------------------------------------------------

int run_compilers(const Options& o) {
  ComparePlan plan{
      .builds = all_builds(), .methods = {}, .seed = o.plan.seed, .cases = o.plan.cases, .threads = o.plan.threads};
  if (plan.builds.empty()) {
    throw Failure(Exit::resources, "no builds of the naive methods: expected a folder compilers/ beside the program");
  }
  if (o.methods.empty()) {
    for (const Method& m : plan.builds.front().methods) plan.methods.push_back(m.name);
  } else {
    for (const Method& m : methods_named(o.methods)) plan.methods.push_back(m.name);
  }
  make_directory(o.out);
  const std::vector<BuildRow> rows = compare_builds(plan);
  print(to_table(plan, rows));
  write_and_draw(o.out, "compilers.json", to_json(plan, rows).dump(1) + "\n");
  print("\nwritten: " + o.out + "/compilers.json, compilers.svg, compilers.png, plot.py\n");
  return 0;
}

/// What `report` requires of it too: the script would draw figures that cannot be.
void require_record(const std::string& directory, const std::string& file) {
  const std::string path = directory + "/" + file;
  const Json record = parse_json(read_file(path), {path});
  const auto require = file == "sweep.json"       ? require_sweep_record
                       : file == "compilers.json" ? require_compilers_record
                                                  : require_map_record;
  require({record, {path}});
}

/// Every record that the directory has.
int redraw(const std::string& directory) {
  std::vector<std::string> records;
  const auto add = [&](const std::string& file) {
    if (exists(directory + "/" + file)) records.push_back(file);
  };
  add("sweep.json");
  add("compilers.json");
  for (const MapContact& c : all_map_contacts()) {
    for (const ProbeKind probe : probe_kinds) add(file_of({&c, probe}));
  }
  if (records.empty()) throw bad_input(directory, 0, "no record, expected sweep.json, compilers.json or map-NAME.json");
  for (const std::string& file : records) require_record(directory, file);
  for (const std::string& file : records) {
    draw_figures(directory, embedded_sweep_script, file, figures_of(file));
    print("drawn again from " + directory + "/" + file + "\n");
  }
  return 0;
}

int run(const Options& o) {
  if (!o.redraw.empty()) return redraw(o.redraw);
  if (!o.map.empty()) return run_map(o);
  if (o.axes == compiler_axis) return run_compilers(o);
  SweepPlan plan = o.plan;
  set_axes(plan, o);
  plan.methods = methods_on_trial(o.methods, default_methods);
  if (o.methods.empty()) std::erase_if(plan.methods, [&](const Method& m) { return !is_asked(plan, m); });
  require_asked(plan);
  make_directory(o.out);
  const Sweep result = sweep(plan);
  const std::vector<Threshold> thresholds = thresholds_of(plan, result);
  print(to_table(plan, result, thresholds));
  write_record(o.out, plan, result, with_witnesses(plan, result, thresholds));
  draw_figures(o.out, embedded_sweep_script, "sweep.json", sweep_figures);
  print("written: " + o.out + "/sweep.json, sweep.csv, witnesses.jsonl, " +
        (plan.of_mesh ? mesh_file(plan) + ", " : "") + "thresholds.svg, a figure for each axis, plot.py\n");
  return 0;
}

}  // namespace

Action declare_sweep(Arguments& arguments, const MeshAxisMaker& maker) {
  const auto o = std::make_shared<Options>();
  o->of_mesh = maker;
  add_methods_option(arguments, o->methods, default_methods);
  arguments.option("--axis,--axes", o->axes, axis_help(maker));
  arguments.option("--mesh", o->mesh,
                   "closed mesh (OFF, OBJ, PLY, STL) for the axis " + std::string(maker.name) + " (default: a torus)");
  arguments.option("--seed", o->plan.seed, "seed of the cases").shows_default();
  arguments.option("--count", o->plan.cases, "cases at each value of each axis, in each format")
      .between(std::uint64_t{1}, std::uint64_t{1} << 32)
      .shows_default();
  add_threads_option(arguments, o->plan.threads);
  arguments.option("--out", o->out, "directory for the record and the figures").shows_default();
  arguments.option("--redraw", o->redraw, "draw the figures of the record in this directory again; nothing is run");
  arguments
      .option("--map", o->map,
              "instead: a failure map. A probe's source is moved around a contact by units in the last place; each "
              "pixel is an answer")
      .one_of(map_names());
  arguments.option("--probe", o->probe, "of a map: what is asked").one_of({"segment", "ray"}).shows_default();
  arguments.option("--map-size", o->map_size, "pixels on each side of a map").between(2, 4096).shows_default();
  arguments.option("--pixel", o->pixel, "METHOD,X,Y: print this pixel of the map as a case, for `tribunal replay`");
  arguments.needs("--pixel", "--map");
  arguments.needs("--probe", "--map");
  arguments.excludes("--map", "--axis");
  arguments.excludes("--mesh", "--map");
  arguments.excludes("--mesh", "--redraw");
  arguments.excludes("--redraw", "--map");
  return with_plugins(arguments, [o] { return run(*o); });
}

}  // namespace tribunal
