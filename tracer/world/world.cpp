#include "tracer/world/world.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "exact/base/failure.h"
#include "exact/filtered/filtered_kernel.h"
#include "exact/mesh/triangulate.h"

namespace tribunal {
namespace {

/// Twice the area vector of a ring, in double.
Point3 area_vector(Ring ring) {
  Point3 sum(0);
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) sum += glm::cross(ring[i] - ring[0], ring[i + 1] - ring[0]);
  return sum;
}

/// A triangle that spans the polygon's plane: the largest triangle (o, pᵢ, pᵢ₊₁) of the outer ring, which is the best
/// conditioned, with the ring's orientation.
Triangle spanning_triangle(const PolygonData& polygon) {
  const Ring ring = Polygon(polygon).ring(0);
  Triangle best{ring[0], ring[0], ring[0]};
  Point3 normal(0);
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
    const Point3 n = glm::cross(ring[i] - ring[0], ring[i + 1] - ring[0]);
    if (glm::dot(n, n) > glm::dot(normal, normal)) normal = n, best = {ring[0], ring[i], ring[i + 1]};
  }
  if (glm::dot(normal, area_vector(ring)) < 0) std::swap(best.b, best.c);
  return best;
}

/// Whether all vertices of the polygon lie exactly in the plane of t. False if t has no area: the
/// polygon's triangles then take its place.
bool lies_in_plane(const PolygonData& polygon, const Triangle& t) {
  const FilteredKernel k;
  const bool spans = std::any_of(std::begin(all_axes), std::end(all_axes),
                                 [&](Axis axis) { return k.orient2d(axis, t.a, t.b, t.c) != Sign::zero; });
  return spans && std::all_of(polygon.vertices.begin(), polygon.vertices.end(),
                              [&](const Point3& v) { return k.orient3d(t.a, t.b, t.c, v) == Sign::zero; });
}

/// Fills the lists of a world, solid by solid, and gathers the triangles.
class Gatherer {
 public:
  Gatherer(World& world, std::vector<Triangle>& triangles, Faces faces)
      : world_(world), triangles_(triangles), faces_(faces) {}

  void add(std::uint32_t solid) {
    const Mesh& mesh = world_.scene->solids[solid].mesh;
    std::vector<Point3> points;
    points.reserve(mesh.vertices.size());
    for (const Point3& v : mesh.vertices) points.push_back(rounded(v, solid));
    for (const auto& t : mesh.triangles) add_triangle(points, t, solid);
    for (std::size_t f = 0; f < mesh.polygons.size(); ++f) add_face(points, mesh.polygons[f], f, solid);
  }

 private:
  [[noreturn]] void fail(std::uint32_t solid, const std::string& what) const {
    throw bad_input(world_.scene->file, 0, "solids[" + std::to_string(solid) + "]: " + what);
  }

  Point3 rounded(const Point3& v, std::uint32_t solid) const {
    const Point3 p = in_format(v, world_.format);
    if (!is_finite(p)) fail(solid, "a vertex is beyond binary32, expected one that the method can represent");
    return p;
  }

  void add(const Triangle& t, std::int32_t polygon, std::uint32_t solid) {
    triangles_.push_back(t);
    world_.polygon_of.push_back(polygon);
    world_.solid_of.push_back(solid);
  }

  void add_triangle(const std::vector<Point3>& points, const std::array<std::uint32_t, 3>& t, std::uint32_t solid) {
    add(Triangle{points[t[0]], points[t[1]], points[t[2]]}, -1, solid);
  }

  void add_face(const std::vector<Point3>& points, const Rings& face, std::size_t number, std::uint32_t solid) {
    PolygonData polygon;
    for (const auto& indices : face) {
      std::vector<Point3> ring;
      for (const std::uint32_t i : indices) ring.push_back(points[i]);
      polygon.add(ring);
    }
    const Triangle plane = spanning_triangle(polygon);
    if (faces_ == Faces::polygons && lies_in_plane(polygon, plane)) {
      add(plane, static_cast<std::int32_t>(world_.polygons.size()), solid);
      world_.polygon_boxes.push_back(box_of(polygon));
      world_.polygons.push_back(std::move(polygon));
      return;
    }
    const auto triangles = triangulate(face, points);
    if (!triangles) {
      fail(solid,
           "polygonal face " + std::to_string(number) +
               " is not planar, or must be triangulated for this method, and its rings cross or wind around a point "
               "twice; expected simple rings, the holes inside the outer one");
    }
    for (const auto& t : *triangles) add_triangle(points, t, solid);
  }

  World& world_;
  std::vector<Triangle>& triangles_;
  Faces faces_;
};

double greatest_coordinate(const FaceList& faces) {
  double greatest = 0;
  for (std::size_t id = 0; id < faces.triangles.size(); ++id) {
    const Box b = faces.box(id);
    for (const Point3& v : {b.lo, b.hi}) {
      greatest = std::max({greatest, std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
    }
  }
  return greatest;
}

}  // namespace

World make_world(const Scene& scene, Format format, Accel accel, Faces faces) {
  World world{.scene = &scene,
              .format = format,
              .triangles = {},
              .solid_of = {},
              .polygon_of = {},
              .polygons = {},
              .polygon_boxes = {},
              .step = 0};
  std::vector<Triangle> triangles;
  Gatherer gatherer(world, triangles, faces);
  for (std::uint32_t s = 0; s < scene.solids.size(); ++s) gatherer.add(s);
  const FaceList list{triangles, world.solid_of, world.polygon_of, world.polygon_boxes};
  world.step = scene.bias * greatest_coordinate(list);
  world.triangles = BoxedFaces(accel, list);
  return world;
}

}  // namespace tribunal
