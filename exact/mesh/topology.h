// Whether a mesh is closed, oriented and manifold, by its edges. None of this is required: faces are hit one by one.
#pragma once

#include <cstddef>
#include <string>

#include "exact/mesh/mesh.h"

namespace tribunal {

/// Counts over the edges of all faces, triangles and rings alike. Vertices at the same place are one vertex, so a list
/// of loose triangles can be closed; an edge from a vertex to itself is none.
struct Topology {
  std::size_t edges = 0;
  std::size_t odd = 0;        ///< used by an odd number of faces: the boundary is open there
  std::size_t crowded = 0;    ///< used by more than two faces: non-manifold edges
  std::size_t unmatched = 0;  ///< not odd, but not used as often in one direction as in the other
  bool inward = false;        ///< oriented, and the volume is certainly negative: faces see their outside from within

  /// Each generic ray from far away crosses it an even number of times: there is an inside.
  bool closed() const { return odd == 0; }

  /// All faces around see their outside, or all their inside, on the same side.
  bool oriented() const { return closed() && unmatched == 0; }

  /// Closed, oriented, not inwards, and manifold along every edge. (Vertices are not looked at.)
  bool sound() const { return oriented() && !inward && crowded == 0; }
};

/// The topology of a mesh. Cost: n log n in the number of edges.
Topology topology_of(const Mesh& mesh);

/// One line for people, e.g. "open: 4 of 12 edges have an odd number of faces".
std::string describe(const Topology& topology);

}  // namespace tribunal
