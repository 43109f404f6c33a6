// tribunal fuzz from a scene: the rays that its picture asks for, and the triangles near them.
#include <algorithm>

#include "exact/base/failure.h"
#include "exact/base/files.h"
#include "exact/base/sha256.h"
#include "exact/methods/methods.h"
#include "tracer/cli/command.h"
#include "tracer/scene/read_scene.h"
#include "tracer/shading/camera_rays.h"
#include "tracer/shading/whitted.h"

namespace tribunal {
namespace {

/// At most so many pixels are traced, spread evenly over the picture, and each probe asks about so many triangles.
constexpr int most_pixels = 4096;
constexpr std::size_t most_faces = 4;

/// Every so many-th column and row.
int step_between(const Camera& camera) {
  int step = 1;
  while ((camera.width / step) * (camera.height / step) > most_pixels) ++step;
  return step;
}

/// All that the picture asks: rays of the camera, shadow segments, reflected and refracted rays.
std::vector<Decision> decisions_of(const World& world) {
  const Camera& camera = world.scene->camera;
  const CameraRays rays(camera);
  std::vector<Decision> log;
  RayTally uncounted;
  WhittedTracer tracer(world, flagship_method(), uncounted, &log);
  const int step = step_between(camera);
  for (int row = step / 2; row < camera.height; row += step) {
    for (int column = step / 2; column < camera.width; column += step) {
      tracer.trace(rays.through(column, row), world.scene->depth);
    }
  }
  return log;
}

/// The triangle that the probe hits first, and some of those whose boxes it meets, from the whole list alike.
std::vector<std::uint32_t> faces_asked(const World& world, const Decision& d) {
  std::vector<std::uint32_t> faces;
  if (d.kind != RayKind::shadow && d.outcome >= 0) faces.push_back(static_cast<std::uint32_t>(d.outcome));
  const std::vector<std::uint32_t> near = candidates(world, d.probe);
  const std::size_t step = std::max<std::size_t>(1, near.size() / most_faces);
  for (std::size_t i = 0; i < near.size() && faces.size() < most_faces; i += step) {
    if (std::ranges::find(faces, near[i]) == faces.end()) faces.push_back(near[i]);
  }
  return faces;
}

OwnData own_scene(const std::string& file) {
  const std::string bytes = read_file(file);
  const Scene scene = parse_scene(bytes, file);
  const World world = make_world(scene, Format::binary64, Accel::bvh, Faces::triangulated);
  const std::vector<Decision> decisions = decisions_of(world);
  const bool hits = std::ranges::any_of(decisions, [](const Decision& d) { return d.outcome >= 0; });
  if (!hits) throw bad_input(file, 0, "no ray of its picture hits a triangle");
  OwnData data{.kind = OwnKind::scene, .file = file, .sha256 = sha256(bytes)};
  for (const Decision& d : decisions) {
    for (const std::uint32_t face : faces_asked(world, d)) {
      const Query query{d.probe, world.triangles[face]};
      if (is_finite(query)) data.queries.push_back({query, Format::binary64});
    }
  }
  return data;
}

}  // namespace

Action declare_fuzz(Arguments& arguments) { return declare_fuzz(arguments, own_scene); }

}  // namespace tribunal
