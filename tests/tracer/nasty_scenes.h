// The most difficult scenes that we know, and rays at their vertices, edges and face planes.
#pragma once

#include <cmath>

#include "tests/tracer/support.h"
#include "tracer/world/world.h"

namespace tribunal::testing {

/// An octahedron: rays at its corners meet four faces at once.
inline Solid octahedron(const Point3& centre, double size) {
  Solid s;
  for (const double side : {-1.0, 1.0}) {
    for (int axis = 0; axis < 3; ++axis) {
      Point3 v(0);
      v[axis] = side * size;
      s.mesh.vertices.push_back(centre + v);
    }
  }
  for (std::uint32_t x : {0u, 3u}) {
    for (std::uint32_t y : {1u, 4u}) {
      for (std::uint32_t z : {2u, 5u}) s.mesh.triangles.push_back({x, y, z});
    }
  }
  return s;
}

/// A soup of lattice triangles, some without area: full of axis-parallel faces, shared planes and repeated corners.
inline Solid lattice_soup(Random& random, const Point3& offset, double scale, int triangles) {
  Solid s;
  for (int i = 0; i < 3 * triangles; ++i) {
    const int x = random.within(0, 4), y = random.within(0, 4), z = random.within(0, 4);
    s.mesh.vertices.push_back(offset + scale * Point3(x, y, z));
  }
  for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(triangles); ++i) {
    s.mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  return s;
}

inline Solid slivers(Random& random, const Point3& offset, int triangles) {
  Solid s;
  for (int i = 0; i < triangles; ++i) {
    const Point3 a = offset + random.point(4);
    const Point3 b = offset + random.point(4);
    s.mesh.vertices.insert(s.mesh.vertices.end(), {a, b, 0.5 * (a + b) + random.point(0x1p-30)});
    const std::uint32_t first = 3 * static_cast<std::uint32_t>(i);
    s.mesh.triangles.push_back({first, first + 1, first + 2});
  }
  return s;
}

inline Scene nasty_scene(std::uint64_t seed) {
  constexpr double offsets[] = {0, 1, 0x1p20, 0x1p40};
  Random random(seed);
  const double offset = offsets[seed % 4];
  const Point3 o(offset, -offset, offset);
  Scene scene;
  scene.solids = {octahedron(o, 4), lattice_soup(random, o, 1, 40), slivers(random, o, 30),
                  lattice_soup(random, o - Point3(2, 2, 2), 1, 20)};
  scene.solids.push_back(scene.solids[1]);  // every triangle of the soup twice: ties
  return scene;
}

/// A ray at a vertex, at the midpoint of an edge or at a point of a face; along an axis, from a corner, or in the
/// plane of a face.
inline Ray aimed(Random& random, const BoxedFaces& triangles) {
  const Triangle t = triangles[static_cast<std::uint32_t>(random.below(triangles.size()))];
  const Triangle u = triangles[static_cast<std::uint32_t>(random.below(triangles.size()))];
  const Point3 targets[] = {t.a, 0.5 * (t.a + t.b), t.a + 0.25 * (t.b - t.a) + 0.25 * (t.c - t.a), t.b};
  const Point3 target = targets[random.below(4)];
  const Point3 corner = u.a;
  const Point3 elsewhere = target + random.point(16);
  Point3 axis(0.0);
  axis[static_cast<int>(random.below(3))] = random.below(2) == 0 ? 1.0 : -1.0;
  if (random.below(2) == 0) axis = Point3(axis.x == 0 ? -0.0 : axis.x, axis.y == 0 ? -0.0 : axis.y, axis.z);
  switch (random.below(4)) {
    case 0:
      return {target - 8.0 * axis, {axis}};
    case 1:
      return {corner, {target - corner}};
    case 2:
      return {elsewhere, {target - elsewhere}};
    default:
      return {t.b, {t.a - t.b}};
  }
}

struct Worlds {
  explicit Worlds(const Scene& scene)
      : none(make_world(scene, Format::binary64, Accel::none)),
        boxes(make_world(scene, Format::binary64, Accel::boxes)),
        bvh(make_world(scene, Format::binary64, Accel::bvh)) {}
  World none, boxes, bvh;
};

}  // namespace tribunal::testing
