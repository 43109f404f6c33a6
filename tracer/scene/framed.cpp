#include "tracer/scene/framed.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "exact/base/failure.h"
#include "exact/mesh/read_mesh.h"

namespace tribunal {
namespace {

/// Twice the tangent of half of 30 degrees.
constexpr double view_height = 0.5358983848622454;
constexpr double margin = 1.08;

struct Box {
  Point3 lo, hi;

  Point3 middle() const { return lo / 2.0 + hi / 2.0; }
};

/// The box of the mesh's points, each mapped by `of`.
template <class Map>
Box box_of(const Mesh& mesh, const Map& of) {
  Box box{of(mesh.vertices.front()), of(mesh.vertices.front())};
  for (const Point3& v : mesh.vertices) {
    const Point3 x = of(v);
    box = {glm::min(box.lo, x), glm::max(box.hi, x)};
  }
  return box;
}

/// The direction in the mesh's coordinates whose part to the right, up and to the viewer is given.
Point3 seen(char up, double right, double above, double front) {
  if (up == 'x') return {above, front, right};
  if (up == 'z') return {right, -front, above};
  return {right, above, front};
}

/// The axes of a picture, of length one: to the right, up, and to the eye.
struct Frame {
  Point3 right, above, back;

  Point3 of(const Point3& v) const { return {glm::dot(v, right), glm::dot(v, above), glm::dot(v, back)}; }
};

Frame frame_of(const Point3& up, const Point3& back) {
  const Point3 right = glm::normalize(glm::cross(up, back));
  return {right, glm::cross(back, right), back};
}

/// How far the eye must be from the origin, for every point of the mesh to be in the picture, each mapped by `of` to
/// coordinates in the frame.
template <class Map>
double distance_for(const Mesh& mesh, const Map& of, const Framing& f) {
  const double tall = view_height / 2, wide = tall * f.width / f.height;
  double distance = 0;
  for (const Point3& v : mesh.vertices) {
    const Point3 x = of(v);
    distance = std::max(distance, margin * std::max(std::fabs(x.x) / wide, std::fabs(x.y) / tall) + x.z);
  }
  return distance;
}

void scale(Mesh& mesh, double factor, const std::string& file) {
  for (Point3& v : mesh.vertices) {
    v *= factor;
    if (!is_finite(v)) throw bad_input(file, 0, "leaves binary64 when scaled, expected finite vertices");
  }
  if (factor > 0) return;
  for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
  for (Rings& face : mesh.polygons) {
    for (auto& ring : face) std::reverse(ring.begin() + 1, ring.end());
  }
}

}  // namespace

Scene framed_scene(const std::string& mesh_file, const Framing& f) {
  Scene scene;
  scene.file = mesh_file;
  scene.background = {0.75, 0.83, 0.92};
  scene.solids.push_back({"mesh", read_mesh(mesh_file), {.colour = {0.72, 0.66, 0.56}, .ambient = 0.2}});
  Mesh& mesh = scene.solids.front().mesh;
  scale(mesh, f.scale, mesh_file);

  const Box box = box_of(mesh, [](const Point3& v) { return v; });
  const Point3 middle = box.middle(), extent = box.hi - box.lo;
  const double size = std::max({extent.x, extent.y, extent.z});
  if (!(size > 0)) throw bad_input(mesh_file, 0, "is a point, expected a mesh with an extent");
  if (!(size < 0x1p1000)) throw bad_input(mesh_file, 0, "is too large to be framed, expected an extent below 2^1000");

  // In the frame around the middle, in units of `size`; then around the middle of what is seen.
  const Point3 up = seen(f.up, 0, 1, 0);
  const Frame frame = frame_of(up, glm::normalize(seen(f.up, 0.55, 0.45, 1)));
  const auto around_middle = [&](const Point3& v) { return frame.of((v - middle) / size); };
  Point3 shift = box_of(mesh, around_middle).middle();
  shift.z = 0;
  const double distance = distance_for(
      mesh, [&](const Point3& v) { return around_middle(v) - shift; }, f);
  Camera& camera = scene.camera;
  const Point3 look_at = middle + (frame.right * shift.x + frame.above * shift.y) * size;
  camera = {look_at + frame.back * distance * size, look_at, up, view_height, f.width, f.height};
  if (f.eye) {
    camera.eye = *f.eye;
    camera.look_at = middle;
    const Point3 view = (middle - camera.eye) / size;
    if (glm::length(glm::cross(glm::normalize(view), up)) < 0x1p-20) camera.up = seen(f.up, 0, 0, -1);
  }
  scene.lights = {{middle + seen(f.up, 1, 4, 5) * size, {0.9, 0.88, 0.82}},
                  {middle + seen(f.up, 6, 1, -1) * size, {0.25, 0.28, 0.35}}};
  return scene;
}

}  // namespace tribunal
