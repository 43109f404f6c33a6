// A triangle mesh in memory.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/query.h"

namespace tribunal {

/// Vertices in the file's own units and triangles as three indices into them, all in range and all coordinates
/// finite. Repeated and degenerate triangles are allowed: a face without area is never hit.
struct Mesh {
  std::vector<Point3> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;

  Triangle triangle(std::size_t i) const {
    const auto& t = triangles[i];
    return {vertices[t[0]], vertices[t[1]], vertices[t[2]]};
  }
};

/// Faces as a file has them, with any number of vertices.
struct PolygonSoup {
  std::vector<Point3> points;
  std::vector<std::vector<std::size_t>> polygons;
};

}  // namespace tribunal
