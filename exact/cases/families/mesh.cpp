// Closed meshes met at vertices and edge midpoints.
#include <array>
#include <vector>

#include "exact/cases/families/affine.h"
#include "exact/cases/families/probe.h"
#include "exact/cases/families/shapes.h"
#include "exact/cases/families/table.h"

namespace tribunal {
namespace {

constexpr auto levels = lattice_bits;

struct Solid {
  std::vector<std::array<int, 3>> vertices;
  std::vector<std::array<std::size_t, 3>> faces;
};

const Solid& solid(bool cube) {
  static const Solid octahedron{
      {{2, 0, 0}, {-2, 0, 0}, {0, 2, 0}, {0, -2, 0}, {0, 0, 2}, {0, 0, -2}},
      {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
  static const Solid box{{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {2, 2, 0}, {0, 0, 2}, {2, 0, 2}, {0, 2, 2}, {2, 2, 2}},
                         {{0, 2, 3},
                          {0, 3, 1},
                          {4, 5, 7},
                          {4, 7, 6},
                          {0, 1, 5},
                          {0, 5, 4},
                          {2, 6, 7},
                          {2, 7, 3},
                          {0, 4, 6},
                          {0, 6, 2},
                          {1, 3, 7},
                          {1, 7, 5}}};
  return cube ? box : octahedron;
}

Point3 mapped(const AffineMap& map, const std::array<int, 3>& x) {
  Point3 y;
  for (int i = 0; i < 3; ++i) {
    const auto& row = map.m[static_cast<std::size_t>(i)];
    y[i] = static_cast<double>(row[0] * x[0] + row[1] * x[1] + row[2] * x[2]);
  }
  return y;
}

Trial make(Format format, std::uint64_t seed, std::uint64_t k) {
  Draw draw(stream_of("family mesh"), seed, k);
  const auto [is_ray, level] = turn_of(k, levels(format).size());
  const AffineMap map = draw_map(draw, levels(format)[level]);
  const Solid& shape = solid(draw.below(2) == 0);
  const auto vertex = [&](std::size_t i) { return mapped(map, shape.vertices[i]); };
  const auto& face = shape.faces[draw.below(shape.faces.size())];
  const std::uint64_t corner = draw.below(3);
  const Point3 at = vertex(face[corner]), next = vertex(face[(corner + 1) % 3]);
  const Point3 target = draw.below(2) == 0 ? at : (at + next) * 0.5;
  const Segment s = through_exactly(target, draw_lattice_point(draw, levels(format)[level], 1));
  const auto& asked = shape.faces[draw.below(shape.faces.size())];
  const Triangle t{vertex(asked[0]), vertex(asked[1]), vertex(asked[2])};
  return unclassified(format, level, draw_probe(is_ray, s, format, draw), t, draw);
}

}  // namespace

/// A closed mesh (octahedron or cube under an integer map of `level` bits) and a probe aimed exactly at one of its
/// vertices or edge midpoints. Each case draws its own map, its own aim and one of the faces.
Family mesh_family() {
  return {.name = "mesh",
          .stresses = "closed meshes, met exactly at vertices and edge midpoints",
          .population = "integer images of an octahedron and a cube, probes aimed at vertices and edge midpoints",
          .axis = "bits of the map's entries",
          .constructs = false,
          .levels = levels,
          .make = make};
}

}  // namespace tribunal
