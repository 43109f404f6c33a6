// A mesh in memory: triangles, and faces that are hit as polygons.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/operands.h"

namespace tribunal {

/// The rings of a polygonal face as vertex indices, the outer one first, then the holes.
using Rings = std::vector<std::vector<std::uint32_t>>;

/// Vertices in the file's own units; triangles as three indices into them, other faces as rings of indices. All in
/// range, all coordinates finite. Repeated and degenerate faces are allowed: a face without area is never hit.
struct Mesh {
  std::vector<Point3> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<Rings> polygons{};

  Triangle triangle(std::size_t i) const {
    const auto& t = triangles[i];
    return {vertices[t[0]], vertices[t[1]], vertices[t[2]]};
  }
};

}  // namespace tribunal
