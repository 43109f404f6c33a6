#include "tracer/shading/known_faces.h"

#include "tracer/shading/camera_rays.h"

namespace tribunal {

namespace {

/// The unit normal of a triangle. Where the product of the edges may overflow or underflow, they are normalised
/// first.
Point3 normal_of(const Triangle& t) {
  const Point3 normal = glm::cross(t.b - t.a, t.c - t.a);
  const double square = glm::dot(normal, normal);
  if (square > 0x1p-900 && square < 0x1p900) return normal / std::sqrt(square);
  return normalised(glm::cross(normalised(t.b - t.a), normalised(t.c - t.a)));
}

}  // namespace

void KnownFaces::fill(KnownFace& face, std::uint32_t id) const {
  face.id = id;
  face.triangle = world_.triangles[id];
  face.box = world_.box(id);
  face.normal = normal_of(face.triangle);
  face.material = &world_.material_of(id);
  face.plane = PlaneFilter(face.triangle);
}

}  // namespace tribunal
