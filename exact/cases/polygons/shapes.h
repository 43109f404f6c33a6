// Ring configurations of flat polygons, and the kinds of place that a point of the plane can have among them.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace tribunal {

/// A point of the plane with small integer coordinates.
struct PlanePoint {
  int u = 0, v = 0;
  friend bool operator==(const PlanePoint&, const PlanePoint&) = default;
};

using PlaneRing = std::vector<PlanePoint>;

/// A flat polygon within 0 ≤ u, v ≤ 12.
struct Shape {
  std::string_view name;
  std::vector<PlaneRing> rings;
};

inline constexpr int shape_count = 22;

/// One of each configuration: convex, concave, crossing itself, spiked, degenerate, with holes of every relation.
std::span<const Shape> all_shapes();

/// Where a point lies: 14 kinds on the boundary, 5 inside, 7 outside, among rings and among the covering's triangles.
/// A spoke is an internal edge of the covering.
enum class PolygonPlace : std::uint8_t {
  first_vertex,        ///< the vertex from which the covering is made
  repeated_vertex,     ///< consecutive equal vertices
  touching_vertices,   ///< vertices of two rings, or of two passages of one
  vertex_on_edge,      ///< a vertex inside another edge
  lone_vertex,         ///< a ring of one vertex
  spike_tip,           ///< the ring turns back
  flat_vertex,         ///< the ring goes straight on
  outer_corner,        ///< any other vertex of the first ring
  hole_corner,         ///< any other vertex of another ring
  edge_at_first,       ///< inside an edge of the first vertex
  outer_edge,          ///< inside any other edge of the first ring
  hole_edge,           ///< inside any other edge of another ring
  overlapping_edges,   ///< inside several edges on one line
  crossing_edges,      ///< inside several edges that cross
  inside_plain,        ///< inside one triangle
  inside_overlapping,  ///< inside several triangles, some of which cancel
  inside_on_spoke,     ///< between two triangles that lie on both sides of their spoke
  inside_on_fold,      ///< on a spoke whose two triangles lie on one side, and cancel
  inside_on_spokes,    ///< on several spokes
  outside_wound,       ///< wound around an even number of times, not zero
  outside_in_hole,     ///< inside the outer ring, and inside a hole
  outside_cancelled,   ///< in triangles that cancel
  outside_on_spoke,    ///< on one or more spokes
  outside_in_line,     ///< on the line of a ring edge, in no triangle
  outside_off_spoke,   ///< on the line of a spoke, in no triangle
  outside_far,         ///< none of these
};

inline constexpr int place_count = 26;

std::string_view name_of(PolygonPlace place);

/// Whether points of this kind belong to the closed polygon.
constexpr bool is_met(PolygonPlace place) { return place < PolygonPlace::outside_wound; }

constexpr bool is_vertex(PolygonPlace place) { return place <= PolygonPlace::hole_corner; }

constexpr bool is_boundary(PolygonPlace place) { return place <= PolygonPlace::crossing_edges; }

/// The place of x among the rings, by integers. Its winding numbers are summed ray by ray, not triangle by triangle.
PolygonPlace place_of(const PlanePoint& x, std::span<const PlaneRing> rings);

/// All integer points within two units of the shape's square, by their place.
using Places = std::array<std::vector<PlanePoint>, place_count>;

const Places& places_of(const Shape& shape);

}  // namespace tribunal
