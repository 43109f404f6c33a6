// A scene made for a mesh, so that a picture of it needs no scene file.
#pragma once

#include <optional>
#include <string>

#include "tracer/scene/scene.h"

namespace tribunal {

/// From where a mesh is seen. What is not given is chosen.
struct Framing {
  double scale = 1;             ///< factor of all vertices, which rounds once
  std::optional<Point3> eye{};  ///< the place of the eye, after scaling; it looks at the middle of the bounding box
  char up = 'y';                ///< the axis that points up in the picture: x, y or z
  int width = 640, height = 480;
};

/// One solid of the mesh in this file, two lights, and a camera. Where the framing gives no eye, the mesh is seen from
/// its front, right and top, and fills the picture but for a margin, whatever its size. Fails with Exit::bad_input
/// where the mesh cannot be read, is a point, or leaves binary64 when scaled.
Scene framed_scene(const std::string& mesh_file, const Framing& framing);

}  // namespace tribunal
