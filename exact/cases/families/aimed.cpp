#include "exact/cases/families/aimed.h"

#include <algorithm>
#include <memory>

#include "exact/cases/families/probe.h"
#include "exact/cases/families/shapes.h"

namespace tribunal {
namespace {

constexpr int aims[] = {0, 1, 2, 3, 4, 5};

std::span<const int> levels(Format) { return aims; }

/// A number of the size of the largest coordinate, so that probes start within a few times the extent of the mesh.
double extent_of(const std::vector<Triangle>& triangles) {
  double largest = 0;
  for (const Triangle& t : triangles) {
    for (const Point3& v : {t.a, t.b, t.c}) {
      largest = std::max({largest, std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
    }
  }
  return largest;
}

Segment aim(std::size_t level, const Triangle& t, const Triangle& other, const Point3& far, Draw& draw, Format format) {
  switch (level) {
    case 0:
      return {far, t.a};
    case 1:
      return through(t.a, far, far);
    case 2:
      return through((t.a + t.b) * 0.5, far, far);
    case 3:
      return through(draw_in_plane(draw, format, t), far, far);
    case 4:
      return {t.a + (t.a - t.b), t.b + (t.b - t.a)};
    default:
      return {other.a, t.a};
  }
}

}  // namespace

Family aimed_at(std::vector<Triangle> triangles) {
  const double extent = extent_of(triangles);
  const auto mesh = std::make_shared<const std::vector<Triangle>>(std::move(triangles));
  const auto make = [mesh, extent](Format format, std::uint64_t seed, std::uint64_t k) {
    Draw draw(stream_of("family aimed"), seed, k);
    const auto [is_ray, level] = turn_of(k, std::size(aims));
    const Triangle exact = (*mesh)[draw.below(mesh->size())], other = (*mesh)[draw.below(mesh->size())];
    const Triangle t{in_format(exact.a, format), in_format(exact.b, format), in_format(exact.c, format)};
    const Point3 far = draw_point(draw, format) * extent;
    const Segment s = aim(level, t, other, far, draw, format);
    return unclassified(format, level, draw_probe(is_ray, s, format, draw), t, draw);
  };
  return {.name = mesh_family,
          .stresses = "the triangles of a mesh of your own, met at vertices, edges and in their planes",
          .population =
              "segments and rays aimed at the triangles of your mesh, one triangle a case: how often a single "
              "answer is wrong is no leak rate, which `tribunal leak` measures",
          .axis =
              "(0 ends at a vertex, 1 through one, 2 through an edge, 3 through a face, 4 along an edge, "
              "5 from vertex to vertex)",
          .constructs = false,
          .levels = levels,
          .make = make};
}

}  // namespace tribunal
