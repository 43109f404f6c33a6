#include "exact/base/json.h"
#include "tests/fuzz/memory_file.h"
#include "tests/fuzz/targets.h"
#include "tracer/scene/read_scene.h"

namespace tribunal::fuzzing {
namespace {

void demand_whole(const Mesh& mesh) {
  for (const Point3& p : mesh.vertices) demand(is_finite(p), "a vertex that is not finite");
  for (const auto& t : mesh.triangles) {
    for (const std::uint32_t i : t) demand(i < mesh.vertices.size(), "a corner that is no vertex");
  }
  for (const Rings& face : mesh.polygons) {
    for (const auto& ring : face) {
      demand(ring.size() >= 3, "a ring with less than three corners");
      for (const std::uint32_t i : ring) demand(i < mesh.vertices.size(), "a corner that is no vertex");
    }
  }
}

void read(const std::string& text) {
  accepts([&] {
    const Scene scene = parse_scene(text, "/nowhere/scene.json");
    demand(!scene.solids.empty(), "a scene without solids");
    demand(scene.camera.width > 0 && scene.camera.height > 0, "an image without pixels");
    for (const Solid& solid : scene.solids) demand_whole(solid.mesh);
  });
}

}  // namespace

void scene(std::string_view bytes) {
  // A name of a file would have the fuzzer read what lies about.
  if (bytes.find("\"mesh\"") != bytes.npos || bytes.find("\"solid\"") != bytes.npos) return;
  if (bytes.find("\\u") != bytes.npos) return;
  read(std::string(bytes));
}

void solid(std::string_view bytes) {
  const MemoryFile file(bytes);
  const Json scene = {
      {"camera",
       {{"eye", {0, 0, 5}}, {"look_at", {0, 0, 0}}, {"up", {0, 1, 0}}, {"fov", 40}, {"width", 4}, {"height", 4}}},
      {"solids", {{{"solid", file.path()}}}}};
  read(scene.dump());
}

}  // namespace tribunal::fuzzing
