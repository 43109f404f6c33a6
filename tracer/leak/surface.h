// The mesh on which methods stand trial, in the coordinates of one format.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/format.h"
#include "exact/mesh/mesh.h"
#include "exact/mesh/topology.h"
#include "tracer/accel/triangle_tree.h"
#include "tracer/leak/face_boxes.h"

namespace tribunal::leak {

/// Rows of indices, stored one after the other: for example the faces around each vertex.
class Incidence {
 public:
  Incidence() = default;
  /// Appends values[i] to row rows[i], for each i in turn.
  Incidence(std::size_t row_count, std::span<const std::uint32_t> rows, std::span<const std::uint32_t> values);

  std::span<const std::uint32_t> operator[](std::size_t row) const {
    return std::span(values_).subspan(first_[row], first_[row + 1] - first_[row]);
  }

 private:
  std::vector<std::size_t> first_;
  std::vector<std::uint32_t> values_;
};

/// Triangles whose vertices at the same place are one vertex. Coordinates are exact in the format.
class Surface {
 public:
  using Corners = std::array<std::uint32_t, 3>;
  using Edge = std::array<std::uint32_t, 2>;

  /// Fails with Exit::bad_input, naming the file, if the mesh has no triangles, or a coordinate beyond the format.
  Surface(const Mesh& triangles, Format format, const std::string& file);

  Format format() const { return format_; }
  const Topology& topology() const { return topology_; }
  const Box& bounds() const { return bounds_; }
  const FaceBoxes& boxes() const { return boxes_; }  ///< each is wider than its face by far more than a test may round
  const TriangleTree& tree() const { return tree_; }

  const std::vector<Point3>& vertices() const { return vertices_; }
  const std::vector<Edge>& edges() const { return edges_; }  ///< each once, the lower vertex first
  std::size_t face_count() const { return corners_.size(); }
  const Corners& corners(std::uint32_t face) const { return corners_[face]; }
  const Triangle& triangle(std::uint32_t face) const { return triangles_[face]; }
  std::span<const Triangle> triangles() const { return triangles_; }

  /// Whether the face has no area.
  bool is_flat(std::uint32_t face) const { return flat_[face]; }
  /// Whether the vertex is an end of an edge that belongs to an odd number of faces.
  bool is_at_opening(std::uint32_t vertex) const { return at_opening_[vertex]; }
  bool has_vertex(std::uint32_t face, std::uint32_t vertex) const;
  bool share_vertex(std::uint32_t face, std::uint32_t other) const;

  std::span<const std::uint32_t> faces_of_vertex(std::size_t vertex) const { return of_vertex_[vertex]; }
  std::span<const std::uint32_t> faces_of_edge(std::size_t edge) const { return of_edge_[edge]; }

 private:
  void add_faces(const Mesh& mesh, const std::string& file);
  void find_edges();
  void mark_openings();

  Format format_;
  std::vector<Point3> vertices_;
  std::vector<Corners> corners_;
  std::vector<Triangle> triangles_;
  std::vector<Edge> edges_;
  std::vector<bool> flat_, at_opening_;
  Incidence of_vertex_, of_edge_;
  Topology topology_;
  Box bounds_;
  FaceBoxes boxes_;
  TriangleTree tree_{{}};
};

}  // namespace tribunal::leak
