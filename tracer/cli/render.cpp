// tribunal render: an image, and with --against the pixels that differ, as an image and as cases.
#include <oneapi/tbb/global_control.h>

#include <charconv>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "exact/base/failure.h"
#include "exact/base/files.h"
#include "exact/base/output.h"
#include "exact/mesh/read_mesh.h"
#include "exact/mesh/topology.h"
#include "exact/record/counterexample.h"
#include "exact/record/environment.h"
#include "tracer/cli/command.h"
#include "tracer/pov/export_pov.h"
#include "tracer/render/findings.h"
#include "tracer/render/heat_map.h"
#include "tracer/scene/framed.h"
#include "tracer/scene/read_scene.h"

namespace tribunal {
namespace {

struct Options {
  std::string scene, method, against, out, stats, pov;
  int depth = 0;  ///< 0 stands for the scene's own depth
  std::string accel = "bvh";
  unsigned threads = default_threads();
  std::size_t max_cases = 1000;
  bool triangulate = false, heat = false;
  std::string size, eye;  ///< "WIDTHxHEIGHT", "X,Y,Z"; empty where the scene, or the framing of a mesh, decides
  std::string up = "y";
  double scale = 1;
};

/// The acceleration of this name; the option's parser has refused all other names.
Accel accel_named(std::string_view name) {
  for (const Accel a : {Accel::none, Accel::boxes}) {
    if (name == name_of(a)) return a;
  }
  return Accel::bvh;
}

/// What stands between commas, or another separator, as numbers; nothing if something there is no number.
template <class N>
std::vector<N> numbers_in(std::string_view text, char separator) {
  std::vector<N> all;
  for (const char* at = text.data();; ++at) {
    N x{};
    const auto [after, error] = std::from_chars(at, text.data() + text.size(), x);
    if (error != std::errc()) return {};
    all.push_back(x);
    at = after;
    if (at == text.data() + text.size()) return all;
    if (*at != separator) return {};
  }
}

/// "640x480" as the pixels of a picture.
void set_size(const std::string& size, int& width, int& height) {
  const std::vector<int> sides = numbers_in<int>(size, 'x');
  const auto fits = [](int n) { return n >= 1 && n <= max_side; };
  if (sides.size() != 2 || !std::ranges::all_of(sides, fits) || long{sides[0]} * sides[1] > max_pixels) {
    throw Failure(Exit::usage,
                  "--size: expected WIDTHxHEIGHT, 1 to 16384 each and at most 2^26 in all, found \"" + size + "\"");
  }
  width = sides[0];
  height = sides[1];
}

Point3 eye_of(const std::string& text) {
  const std::vector<double> x = numbers_in<double>(text, ',');
  if (x.size() != 3 || !is_finite(Point3(x[0], x[1], x[2]))) {
    throw Failure(Exit::usage, "--camera: expected three finite numbers X,Y,Z, found \"" + text + "\"");
  }
  return {x[0], x[1], x[2]};
}

Scene scene_of_mesh(const Options& o) {
  Framing framing{.scale = o.scale, .up = o.up[0]};
  if (!o.size.empty()) set_size(o.size, framing.width, framing.height);
  if (!o.eye.empty()) framing.eye = eye_of(o.eye);
  return framed_scene(o.scene, framing);
}

Scene scene_of_file(const Options& o) {
  if (o.scale != 1 || o.up != "y") {
    throw Failure(Exit::usage, "--scale and --up are for a mesh, and " + o.scene + " is read as a scene");
  }
  Scene scene = read_scene(o.scene);
  if (!o.size.empty()) set_size(o.size, scene.camera.width, scene.camera.height);
  if (!o.eye.empty()) scene.camera.eye = eye_of(o.eye);
  return scene;
}

/// The scene in this file, or one made for the mesh in it.
Scene scene_of(const Options& o) {
  if (!(std::isfinite(o.scale) && o.scale != 0)) throw Failure(Exit::usage, "--scale: expected a number other than 0");
  const Scene scene = is_mesh_name(o.scene) ? scene_of_mesh(o) : scene_of_file(o);
  if (!o.eye.empty()) require_frame(scene.camera, Where{"--camera"});
  return scene;
}

/// "a/image.png" with ".diff.png" → "a/image.diff.png".
std::string beside(const std::string& out, const char* suffix) {
  return std::filesystem::path(out).replace_extension(suffix).string();
}

// --- what a program reads ----------------------------------------------------------------------------------------

double share(std::uint64_t part, std::uint64_t whole) {
  return whole > 0 ? static_cast<double>(part) / static_cast<double>(whole) : 0;
}

/// The number of hit points computed: one for each ray that hits something, but none for shadow rays.
std::uint64_t points_computed(const RayTally& t) { return t.ray_hits[0] + t.ray_hits[2] + t.ray_hits[3]; }

Json to_json(const Method& method, const RayTally& t) {
  Json rays;
  for (const RayKind k : all_ray_kinds) {
    const auto i = static_cast<std::size_t>(k);
    rays[std::string(name_of(k))] = {{"cast", t.rays[i]}, {"hit", t.ray_hits[i]}};
  }
  return {
      {"method", method.name},
      {"rays", rays},
      {"box_tests", t.box_tests},
      {"triangle_tests", t.triangle_tests},
      {"triangle_hits", t.triangle_hits},
      {"polygon_tests", t.polygon_tests},
      {"polygon_hits", t.polygon_hits},
      {"hit_share", share(t.hits(), t.tests())},
      {"answers_by_stage",
       {{"unstaged", t.by_stage[0]}, {"filter", t.by_stage[1]}, {"integers", t.by_stage[2]}, {"exact", t.by_stage[3]}}},
      {"points_computed", points_computed(t)},
      {"starts",
       {{"wanted", t.starts},
        {"candidates", t.start_candidates},
        {"tests", t.start_tests},
        {"unproved", method.contract.exact ? Json(t.starts_unproved) : Json("all")}}}};
}

/// The options that change a picture or its cases and that no other key says, as they were given.
Json options_json(const Options& o) {
  Json given = Json::object();
  if (!o.eye.empty()) given["camera"] = o.eye;
  if (o.scale != 1) given["scale"] = o.scale;
  if (o.up != "y") given["up"] = o.up;
  if (o.triangulate) given["triangulate"] = true;
  if (o.heat) given["heat"] = true;
  given["max-cases"] = o.max_cases;
  return given;
}

/// NAME.diff.json: all that a page about the two pictures needs.
std::string to_text(const Options& o, Json stats, const Findings& f) {
  const auto name = [&](const char* suffix) {
    return std::filesystem::path(beside(o.out, suffix)).filename().string();
  };
  stats["files"] = {{"image", std::filesystem::path(o.out).filename().string()},
                    {"against", name(".against.png")},
                    {"difference", name(".diff.png")},
                    {"cases", name(".cases.jsonl")}};
  stats["options"] = options_json(o);
  if (o.heat) stats["files"].update({{"tests", name(".tests.png")}, {"stages", name(".stages.png")}});
  stats["environment"] = environment();
  stats["pixels"] = pixels_json(f);
  return stats.dump(1) + "\n";
}

// --- what a person reads -----------------------------------------------------------------------------------------

std::string formatted(const char* format, auto... values) {
  char line[400];
  std::snprintf(line, sizeof line, format, values...);
  return line;
}

unsigned long long whole(std::uint64_t n) { return n; }

/// "1 solid", "2 solids".
std::string counted(std::size_t n, const char* what) { return std::to_string(n) + " " + what + (n == 1 ? "" : "s"); }

std::string describe(const World& world, const Options& o, int depth) {
  const Camera& c = world.scene->camera;
  const std::size_t polygons = world.polygons.size();
  std::string text =
      o.scene + formatted(": %d x %d pixels, ", c.width, c.height) + counted(world.scene->solids.size(), "solid") +
      ", " + counted(world.triangles.size() - polygons, "triangle") + ", " + counted(polygons, "polygon") + ", " +
      counted(world.scene->lights.size(), "light") + formatted(", depth %d, accel %s\n", depth, o.accel.c_str());
  if (world.format == Format::binary32) {
    text += "vertices and rays are rounded to binary32 before any method sees them: differences are the methods' own\n";
  }
  return text;
}

/// The topology of the solids: one line with the number of sound ones, and one line for each of the first eight
/// others.
std::string describe_solids(const Scene& scene, const std::vector<Topology>& topologies) {
  constexpr std::size_t most = 8;
  std::string text;
  std::size_t sound = 0, others = 0;
  for (std::size_t i = 0; i < scene.solids.size(); ++i) {
    if (topologies[i].sound()) {
      ++sound;
    } else if (++others <= most) {
      text += scene.solids[i].name + ": " + describe(topologies[i]) + "\n";
    }
  }
  if (others > most) text += "and " + counted(others - most, "solid") + " more, see --stats\n";
  return formatted("closed, oriented outwards, manifold along all edges: %zu of ", sound) +
         counted(scene.solids.size(), "solid") + "\n" + text;
}

Json to_json(const Solid& solid, const Topology& t) {
  return {{"name", solid.name},
          {"vertices", solid.mesh.vertices.size()},
          {"faces", solid.mesh.triangles.size() + solid.mesh.polygons.size()},
          {"edges", t.edges},
          {"closed", t.closed()},
          {"oriented", t.oriented()},
          {"inward", t.inward},
          {"odd_edges", t.odd},
          {"non_manifold_edges", t.crowded},
          {"unmatched_edges", t.unmatched}};
}

std::string table_head() {
  return formatted("\n%-14s %9s %10s %11s %11s %12s %12s %7s %8s\n", "method", "primary", "shadow", "reflection",
                   "refraction", "box tests", "face tests", "hits", "seconds");
}

std::string table_row(const Method& m, const Rendering& r) {
  const RayTally& t = r.tally;
  return formatted("%-14s %9llu %10llu %11llu %11llu %12llu %12llu %6.1f%% %8.2f\n", m.name.c_str(), whole(t.rays[0]),
                   whole(t.rays[1]), whole(t.rays[2]), whole(t.rays[3]), whole(t.box_tests), whole(t.tests()),
                   100 * share(t.hits(), t.tests()), r.seconds);
}

/// What it cost an exact method to prove the starts of secondary rays.
std::string describe_starts(const Method& m, const RayTally& t) {
  if (!m.contract.exact || t.starts == 0) return "";
  return formatted("%s: %llu starts of secondary rays, %llu points tried, %llu face tests, %llu starts unproved\n",
                   m.name.c_str(), whole(t.starts), whole(t.start_candidates), whole(t.start_tests),
                   whole(t.starts_unproved));
}

std::string describe(const Findings& f, const Options& o, std::size_t pixels) {
  std::string text = formatted("\n%s against %s: %zu of %zu pixels differ in colour, %zu in some decision\n",
                               o.method.c_str(), o.against.c_str(), f.colours, pixels, f.pixels.size());
  if (f.pixels.empty()) return text;
  text += formatted("they part on visibility: %zu, shadow: %zu, secondary rays: %zu (reflection %zu, refraction %zu)\n",
                    f.by_kind[0], f.by_kind[1], f.by_kind[2] + f.by_kind[3], f.by_kind[2], f.by_kind[3]);
  text += formatted("of these, only the order of hits differs: %zu; only the starts of the rays differ: %zu\n",
                    f.count(Why::order), f.count(Why::start));
  text += formatted("written as cases: %zu\n", f.cases.size());
  if (f.examined() < f.pixels.size()) text += formatted("(of the first %zu pixels; see --max-cases)\n", f.examined());
  return text;
}

// --- the command -------------------------------------------------------------------------------------------------

bool refuses_rays(const Method& method) {
  const Ray ray{{0.25, 0.25, 1}, {{0, 0, -1}}};
  return method.ray(ray, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}).status == Status::unsupported;
}

/// A method whose contract lacks rays, or triangles where the world has some, would draw an empty picture.
void require_faces(const Method& method, const World& world) {
  const std::size_t triangles = world.solid_of.size() - world.polygons.size();
  if (triangles == 0 || !refuses_rays(method)) return;
  const std::string what =
      method.polygon ? "takes no triangles, and the scene has " + std::to_string(triangles) : "does not take rays";
  throw Failure(Exit::usage, method.name + " " + what + " (its contract: " + in_words(method.contract) + ")");
}

/// The files that the options ask for, in the order in which they are written.
std::vector<Output> outputs_of(const Options& o) {
  std::vector<Output> all{{"-o", o.out}};
  const auto add = [&](const char* option, const std::string& file) { all.push_back({option, file}); };
  if (o.heat) {
    add("--heat", beside(o.out, ".tests.png"));
    add("--heat", beside(o.out, ".stages.png"));
  }
  if (!o.against.empty()) {
    for (const char* suffix : {".against.png", ".diff.png", ".cases.jsonl", ".diff.json"}) {
      add("--against", beside(o.out, suffix));
    }
  }
  if (!o.pov.empty()) {
    add("--export-pov", o.pov);
    add("--export-pov", beside(o.pov, ".ids.png"));
  }
  if (!o.stats.empty()) add("--stats", o.stats);
  return all;
}

/// Refuses output files that cannot be written, before the work is done. The picture may be a device such as
/// /dev/null, unless other files are named after it.
void require_writable(const Options& o, const std::vector<Output>& outputs) {
  const bool names_others = o.heat || !o.against.empty();
  if (std::filesystem::path(o.out).extension() != ".png" && (names_others || !is_special(o.out))) {
    throw Failure(Exit::usage, "-o: expected a name that ends in .png, found \"" + o.out + "\"");
  }
  require_distinct(outputs);
  for (const auto& [option, file] : outputs) {
    require_different(o.scene, file);
    const std::filesystem::path folder = std::filesystem::path(file).parent_path();
    if (!folder.empty() && !is_directory(folder.string())) {
      throw Failure(Exit::output_failed, file + ": cannot write: no folder " + folder.string());
    }
  }
}

/// "a.png, a.diff.png"
std::string names_of(const std::vector<Output>& outputs) {
  std::string text;
  for (const Output& o : outputs) text += (text.empty() ? "" : ", ") + o.file;
  return text;
}

int run(const Options& o) {
  const tbb::global_control builders(tbb::global_control::max_allowed_parallelism, o.threads);
  std::vector<Method> methods{method_on_trial(o.method)};
  if (!o.against.empty()) methods.push_back(method_on_trial(o.against));
  const std::vector<Output> outputs = outputs_of(o);
  require_writable(o, outputs);
  const Scene scene = scene_of(o);
  const auto is_binary32 = [](const Method& m) { return m.contract.format == Format::binary32; };
  const bool narrow = std::any_of(methods.begin(), methods.end(), is_binary32);
  const bool takes_polygons = std::all_of(methods.begin(), methods.end(), [](const Method& m) { return m.polygon; });
  const Faces faces = o.triangulate || !takes_polygons ? Faces::triangulated : Faces::polygons;
  const World world = make_world(scene, narrow ? Format::binary32 : Format::binary64, accel_named(o.accel), faces);
  for (const Method& m : methods) require_faces(m, world);
  const int depth = o.depth > 0 ? o.depth : scene.depth;

  std::vector<Rendering> renderings;
  for (const Method& m : methods) renderings.push_back(render(world, m, {depth, o.threads}));
  Json stats = {{"scene", o.scene},
                {"width", scene.camera.width},
                {"height", scene.camera.height},
                {"triangles", world.triangles.size() - world.polygons.size()},
                {"polygons", world.polygons.size()},
                {"fmt", name_of(world.format)},
                {"accel", o.accel},
                {"depth", depth}};
  std::vector<Topology> topologies;
  for (const Solid& solid : scene.solids) {
    topologies.push_back(topology_of(solid.mesh));
    stats["solids"].push_back(to_json(solid, topologies.back()));
  }
  std::string report = describe(world, o, depth) + describe_solids(scene, topologies) + table_head();
  for (std::size_t i = 0; i < methods.size(); ++i) {
    stats["methods"].push_back(to_json(methods[i], renderings[i].tally));
    report += table_row(methods[i], renderings[i]);
  }
  for (std::size_t i = 0; i < methods.size(); ++i) report += describe_starts(methods[i], renderings[i].tally);
  OutputSet set;
  set.add(o.out, to_png(renderings[0].image));
  if (o.heat) {
    set.add(beside(o.out, ".tests.png"), to_png(tests_heat_map(renderings[0])));
    set.add(beside(o.out, ".stages.png"), to_png(stages_heat_map(renderings[0])));
    report += formatted(
        "heat maps: white is %llu tests a pixel (logarithmic); the deepest stage is filter (blue), "
        "integers (orange), exact (white)\n",
        whole(greatest_tests(renderings[0])));
  }
  if (methods.size() == 2) {
    const std::vector<DifferingPixel> differing = differing_pixels(renderings[0], renderings[1]);
    const Findings f = examine(world, methods[0], methods[1], differing, depth, o.max_cases);
    stats["difference"] = to_json(f, methods[0], methods[1]);
    set.add(beside(o.out, ".against.png"), to_png(renderings[1].image));
    set.add(beside(o.out, ".diff.png"), to_png(difference_image(renderings[0].image, differing)));
    set.add(beside(o.out, ".cases.jsonl"), to_lines(f.cases));
    set.add(beside(o.out, ".diff.json"), to_text(o, stats, f));
    report += describe(f, o, renderings[0].image.pixels.size());
  }
  if (!o.pov.empty()) {
    const World triangles = make_world(scene, world.format, Accel::bvh, Faces::triangulated);
    set.add(o.pov, to_pov(triangles, depth));
    set.add(beside(o.pov, ".ids.png"), to_png(ids_image(triangles, methods[0])));
  }
  if (!o.stats.empty()) set.add(o.stats, stats.dump(2) + "\n");
  set.commit();
  print(report + "\nwritten: " + names_of(outputs) + "\n");
  return code(Exit::ok);
}

}  // namespace

Action declare_render(Arguments& arguments) {
  const auto o = std::make_shared<Options>();
  arguments.option("scene", o->scene, "scene file (JSON), or a mesh (.off, .obj, .ply, .stl), which is then framed")
      .required();
  arguments.option("--method,--methods", o->method,
                   "the method that decides what rays hit (default: that of a plugin)");
  arguments.option("--against", o->against, "a second method: report, draw and export the pixels that differ");
  arguments.option("-o,--out", o->out, "image file (PNG)").required();
  arguments.option("--size", o->size, "pixels, e.g. 640x480, instead of the scene's");
  arguments.option("--camera", o->eye, "X,Y,Z: the place of the eye, instead of the scene's or the chosen one");
  arguments.option("--scale", o->scale, "factor of the vertices of a mesh, e.g. 1e-6").of_either_sign();
  arguments.option("--up", o->up, "the axis of a mesh that points up in the picture")
      .one_of({"x", "y", "z"})
      .shows_default();
  arguments.option("--stats", o->stats, "counts of rays, tests and hits (JSON)");
  arguments.option("--depth", o->depth, "generations of rays, instead of the scene's").between(1, 16);
  arguments.option("--accel", o->accel, "none, boxes (one a solid) or bvh")
      .one_of({"none", "boxes", "bvh"})
      .shows_default();
  arguments.option("--threads", o->threads, "worker threads, of the tree's building too")
      .between(1u, 1024u)
      .shows_default();
  arguments.option("--export-pov", o->pov, "the scene for POV-Ray, and beside it the solid each pixel sees (.ids.png)");
  arguments.flag("--heat", o->heat, "also what each pixel cost: NAME.tests.png and NAME.stages.png");
  arguments.flag("--triangulate", o->triangulate,
                 "polygonal faces as triangles (as they always are for methods without a polygon test)");
  arguments.option("--max-cases", o->max_cases, "at most so many cases with --against").shows_default();
  return with_plugins(
      arguments, [o] { return run(*o); }, MayIsolate::no);
}

}  // namespace tribunal
