// A scene made ready for rays.
#pragma once

#include <vector>

#include "core/method.h"
#include "tracer/accel/boxed_faces.h"
#include "tracer/scene/scene.h"

namespace tribunal {

/// All faces of a scene in one list, in file order (of each solid the triangles first), and the boxes over them. The
/// scene must outlive it.
///
/// A face that is no triangle becomes a polygon if its vertices, rounded to the world's format, lie exactly in one
/// plane; otherwise, and for all faces of a world made triangulated, the triangles of its triangulation take its
/// place.
///
/// The format is binary32 if any method that uses this world computes in binary32: vertices are then rounded here,
/// once, and every probe before any method gets it. Two methods that are compared share one world, so no difference
/// between them comes from the rounding of input.
struct World {
  const Scene* scene;
  Format format;
  BoxedFaces triangles;  ///< of face i: the face itself, or three vertices that span the polygon's plane; and the boxes
  std::vector<std::uint32_t> solid_of;
  std::vector<std::int32_t> polygon_of;  ///< of face i: an index into polygons, −1 for triangles
  std::vector<PolygonData> polygons;
  std::vector<Box> polygon_boxes;
  double step;  ///< by which inexact methods' secondary rays leave a surface: bias × the greatest |coordinate|

  const PolygonData* polygon(std::uint32_t id) const {
    return polygon_of[id] < 0 ? nullptr : &polygons[static_cast<std::size_t>(polygon_of[id])];
  }
  Box box(std::uint32_t id) const {
    return polygon_of[id] < 0 ? box_of(triangles[id]) : polygon_boxes[static_cast<std::size_t>(polygon_of[id])];
  }

  const Material& material_of(std::uint32_t id) const { return scene->solids[solid_of[id]].material; }
};

enum class Faces : std::uint8_t { polygons, triangulated };

/// Fails with Exit::bad_input if a vertex overflows binary32, or a face that must be triangulated cannot be.
World make_world(const Scene& scene, Format format, Accel accel, Faces faces = Faces::polygons);

}  // namespace tribunal
