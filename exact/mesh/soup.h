// The faces and points of a mesh file as they stand in it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/query.h"

namespace tribunal {

/// Faces as a mesh file has them, one ring each, with any number of vertices from three on. All rings stand in one
/// array, so that a soup takes a small multiple of its file's size.
struct PolygonSoup {
  std::vector<Point3> points;
  std::vector<std::uint32_t> corners;  ///< the corners of all faces, as indices into points
  std::vector<std::uint32_t> ends;     ///< for each face, where its corners end in that array

  std::size_t size() const { return ends.size(); }

  std::span<const std::uint32_t> face(std::size_t f) const {
    const std::size_t first = f > 0 ? ends[f - 1] : 0;
    return std::span(corners).subspan(first, ends[f] - first);
  }

  void end_face() { ends.push_back(static_cast<std::uint32_t>(corners.size())); }
};

}  // namespace tribunal
