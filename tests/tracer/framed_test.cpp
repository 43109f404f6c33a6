// A picture of a mesh without a scene file: the mesh fills it, whatever its size and place.
#include "tracer/scene/framed.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <glm/geometric.hpp>

#include "exact/base/failure.h"
#include "tracer/scene/read_scene.h"

namespace tribunal {
namespace {

/// The largest coordinates of the mesh in the picture, in units of half its width and half its height.
Point3 reach(const Scene& scene) {
  const Camera& c = scene.camera;
  const Point3 back = glm::normalize(c.eye - c.look_at);
  const Point3 right = glm::normalize(glm::cross(c.up, back)), above = glm::cross(back, right);
  const double tall = c.view_height / 2, wide = tall * c.width / c.height;
  Point3 most(0);
  for (const Point3& v : scene.solids.front().mesh.vertices) {
    const Point3 x = v - c.eye;
    const double ahead = -glm::dot(x, back);
    EXPECT_GT(ahead, 0);
    most.x = std::max(most.x, std::fabs(glm::dot(x, right)) / ahead / wide);
    most.y = std::max(most.y, std::fabs(glm::dot(x, above)) / ahead / tall);
  }
  return most;
}

TEST(FramedScene, IsFilledByTheMesh) {
  for (const char* mesh : {"elephant", "camel", "3torus", "sphere", "fandisk"}) {
    for (const double scale : {1.0, 1e-6, -3.0, 1e100, 1e-100}) {
      for (const char up : {'x', 'y', 'z'}) {
        for (const auto& [width, height] : {std::pair(400, 300), std::pair(100, 700)}) {
          const Framing framing{.scale = scale, .up = up, .width = width, .height = height};
          const Scene scene = framed_scene(std::string("data/meshes/") + mesh + ".off", framing);
          const Point3 most = reach(scene);
          EXPECT_LT(std::max(most.x, most.y), 1.0) << mesh << scale << up << width;
          EXPECT_GT(std::max(most.x, most.y), 0.75) << mesh << scale << up << width;
          EXPECT_NO_THROW(require_frame(scene.camera, Where{"camera"}));
          EXPECT_EQ(scene.camera.width, width);
        }
      }
    }
  }
}

TEST(FramedScene, TakesAnEyeEvenAboveTheMesh) {
  const Point3 above(0, 3, 0);
  Framing framing{.eye = above};
  const Scene scene = framed_scene("data/meshes/octahedron.off", framing);
  EXPECT_EQ(scene.camera.eye, above);
  EXPECT_NO_THROW(require_frame(scene.camera, Where{"camera"}));
}

TEST(FramedScene, RefusesAPointAndWhatLeavesBinary64) {
  const std::string file = ::testing::TempDir() + "framed_point.off";
  std::ofstream(file) << "OFF\n3 1 0\n1 2 3\n1 2 3\n1 2 3\n3 0 1 2\n";
  EXPECT_THROW(framed_scene(file, {}), Failure);
  EXPECT_NO_THROW(framed_scene("data/meshes/elephant.off", {.scale = 1e200})) << "the mesh is there";
  EXPECT_THROW(framed_scene("data/meshes/elephant.off", {.scale = 1e308 * 1e1}), Failure);
  EXPECT_THROW(framed_scene("data/meshes/elephant.off", {.scale = 1e303}), Failure);
}

}  // namespace
}  // namespace tribunal
