// A scene made ready for rays.
#pragma once

#include <vector>

#include "core/method.h"
#include "tracer/accel/bvh.h"
#include "tracer/scene/scene.h"

namespace tribunal {

/// All triangles of a scene in one list, in file order, and the boxes over them. The scene must outlive it.
///
/// If a method that sees this world computes in binary32, the format is binary32: vertices are rounded once, here, and
/// every probe before any method sees it. Two methods in comparison share one world, so no difference between them
/// comes from the rounding of input.
struct World {
  const Scene* scene;
  Format format;
  std::vector<Triangle> triangles;
  std::vector<std::uint32_t> solid_of;
  BoxTree tree;
  double step;  ///< by which secondary rays leave a surface: bias × the greatest |coordinate|

  const Material& material_of(std::uint32_t id) const { return scene->solids[solid_of[id]].material; }
};

/// Fails with Exit::bad_input if a vertex overflows binary32.
World make_world(const Scene& scene, Format format, Accel accel);

}  // namespace tribunal
