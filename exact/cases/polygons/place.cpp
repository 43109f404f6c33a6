// Decides the kind of place of a point among rings, in integers.
#include <map>

#include "exact/cases/polygons/shapes.h"

namespace tribunal {
namespace {

PlanePoint operator-(const PlanePoint& a, const PlanePoint& b) { return {a.u - b.u, a.v - b.v}; }

int cross(const PlanePoint& a, const PlanePoint& b) { return a.u * b.v - a.v * b.u; }

int dot(const PlanePoint& a, const PlanePoint& b) { return a.u * b.u + a.v * b.v; }

bool in_line(const PlanePoint& x, const PlanePoint& a, const PlanePoint& b) { return cross(a - x, b - x) == 0; }

bool strictly_between(const PlanePoint& x, const PlanePoint& a, const PlanePoint& b) {
  return in_line(x, a, b) && dot(a - x, b - x) < 0;
}

const PlanePoint& next(const PlaneRing& ring, std::size_t i) { return ring[(i + 1) % ring.size()]; }

const PlanePoint& previous(const PlaneRing& ring, std::size_t i) { return ring[(i + ring.size() - 1) % ring.size()]; }

/// Signed crossings of the ray from x along (1, 0); x lies on no edge.
int winding(const PlanePoint& x, const PlaneRing& ring) {
  int turns = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const PlanePoint a = ring[i] - x, b = next(ring, i) - x;
    if ((a.v > 0) == (b.v > 0)) continue;
    const int side = cross(a, b);
    if (b.v > 0 && side > 0) ++turns;
    if (a.v > 0 && side < 0) --turns;
  }
  return turns;
}

/// The vertices at x and the edges through x.
struct Touched {
  std::vector<std::size_t> rings, vertices;  ///< the indices of ring and vertex, for each vertex at x
  std::vector<PlanePoint> directions;        ///< the direction of each edge through x
  std::size_t edge_ring = 0;                 ///< the ring of the last of these edges
  bool edge_at_first = false;
};

Touched touched(const PlanePoint& x, std::span<const PlaneRing> rings) {
  Touched t;
  for (std::size_t r = 0; r < rings.size(); ++r) {
    for (std::size_t i = 0; i < rings[r].size(); ++i) {
      const PlanePoint &a = rings[r][i], &b = next(rings[r], i);
      if (a == x) {
        t.rings.push_back(r);
        t.vertices.push_back(i);
      }
      if (!strictly_between(x, a, b)) continue;
      t.directions.push_back(b - a);
      t.edge_ring = r;
      t.edge_at_first = a == rings[0][0] || b == rings[0][0];
    }
  }
  return t;
}

/// Whether the vertices at x are consecutive vertices of one ring.
bool one_run(const Touched& t, std::span<const PlaneRing> rings) {
  std::size_t starts = 0;
  for (std::size_t i = 0; i < t.rings.size(); ++i) {
    if (t.rings[i] != t.rings[0]) return false;
    const PlaneRing& ring = rings[t.rings[i]];
    starts += previous(ring, t.vertices[i]) != ring[t.vertices[i]];
  }
  return starts <= 1;
}

PolygonPlace place_of_vertex(const PlanePoint& x, const Touched& t, std::span<const PlaneRing> rings) {
  if (x == rings[0][0]) return PolygonPlace::first_vertex;
  if (t.vertices.size() > 1) return one_run(t, rings) ? PolygonPlace::repeated_vertex : PolygonPlace::touching_vertices;
  if (!t.directions.empty()) return PolygonPlace::vertex_on_edge;
  const PlaneRing& ring = rings[t.rings[0]];
  if (ring.size() == 1) return PolygonPlace::lone_vertex;
  const PlanePoint to = next(ring, t.vertices[0]) - x, from = previous(ring, t.vertices[0]) - x;
  if (cross(to, from) == 0) return dot(to, from) > 0 ? PolygonPlace::spike_tip : PolygonPlace::flat_vertex;
  return t.rings[0] == 0 ? PolygonPlace::outer_corner : PolygonPlace::hole_corner;
}

PolygonPlace place_on_edge(const Touched& t) {
  for (const PlanePoint& d : t.directions) {
    if (cross(d, t.directions[0]) != 0) return PolygonPlace::crossing_edges;
  }
  if (t.directions.size() > 1) return PolygonPlace::overlapping_edges;
  if (t.edge_at_first) return PolygonPlace::edge_at_first;
  return t.edge_ring == 0 ? PolygonPlace::outer_edge : PolygonPlace::hole_edge;
}

/// The triangles of the covering that contain x, and on which of their spokes it lies.
struct Covered {
  int triangles = 0;
  std::vector<int> on_spoke;  ///< the turn of each triangle with x on a spoke
  bool in_line_with_edge = false, in_line_with_spoke = false;
};

Covered covered(const PlanePoint& x, std::span<const PlaneRing> rings) {
  Covered c;
  const PlanePoint& o = rings[0][0];
  for (const PlaneRing& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const PlanePoint &a = ring[i], &b = next(ring, i);
      c.in_line_with_edge |= a != b && in_line(x, a, b);
      c.in_line_with_spoke |= a != o && in_line(x, o, a);
      const int turn = cross(a - o, b - o) > 0 ? 1 : -1;
      if (cross(a - o, b - o) == 0) continue;
      const int oa = turn * cross(o - x, a - x), ab = turn * cross(a - x, b - x), bo = turn * cross(b - x, o - x);
      if (oa < 0 || ab < 0 || bo < 0) continue;
      ++c.triangles;
      if (oa == 0 || bo == 0) c.on_spoke.push_back(turn);
    }
  }
  return c;
}

PolygonPlace place_inside(const Covered& c) {
  if (c.on_spoke.size() > 2) return PolygonPlace::inside_on_spokes;
  if (c.on_spoke.size() == 2) {
    return c.on_spoke[0] == c.on_spoke[1] ? PolygonPlace::inside_on_spoke : PolygonPlace::inside_on_fold;
  }
  return c.triangles > 1 ? PolygonPlace::inside_overlapping : PolygonPlace::inside_plain;
}

PolygonPlace place_outside(const Covered& c, int turns, bool in_outer_ring) {
  if (!c.on_spoke.empty()) return PolygonPlace::outside_on_spoke;
  if (in_outer_ring) return PolygonPlace::outside_in_hole;
  if (turns != 0) return PolygonPlace::outside_wound;
  if (c.triangles > 0) return PolygonPlace::outside_cancelled;
  return c.in_line_with_edge    ? PolygonPlace::outside_in_line
         : c.in_line_with_spoke ? PolygonPlace::outside_off_spoke
                                : PolygonPlace::outside_far;
}

}  // namespace

PolygonPlace place_of(const PlanePoint& x, std::span<const PlaneRing> rings) {
  const Touched t = touched(x, rings);
  if (!t.vertices.empty()) return place_of_vertex(x, t, rings);
  if (!t.directions.empty()) return place_on_edge(t);
  int turns = 0;
  for (const PlaneRing& ring : rings) turns += winding(x, ring);
  const Covered c = covered(x, rings);
  if (turns % 2 != 0) return place_inside(c);
  return place_outside(c, turns, winding(x, rings[0]) % 2 != 0);
}

std::string_view name_of(PolygonPlace place) {
  constexpr std::string_view names[place_count] = {"first vertex",
                                                   "repeated vertex",
                                                   "touching vertices",
                                                   "vertex on an edge",
                                                   "lone vertex",
                                                   "spike tip",
                                                   "flat vertex",
                                                   "outer corner",
                                                   "hole corner",
                                                   "edge at first vertex",
                                                   "outer edge",
                                                   "hole edge",
                                                   "overlapping edges",
                                                   "crossing edges",
                                                   "inside",
                                                   "inside, overlapping",
                                                   "inside, on spoke",
                                                   "inside, on a fold",
                                                   "inside, on spokes",
                                                   "outside, wound",
                                                   "outside, in a hole",
                                                   "outside, in cancelling triangles",
                                                   "outside, on a spoke",
                                                   "outside, in line with an edge",
                                                   "outside, in line with a spoke",
                                                   "outside, far"};
  return names[static_cast<int>(place)];
}

const Places& places_of(const Shape& shape) {
  constexpr int lowest = -2, highest = 14;
  static const auto tables = [] {
    std::map<std::string_view, Places> all;
    for (const Shape& s : all_shapes()) {
      for (int u = lowest; u <= highest; ++u) {
        for (int v = lowest; v <= highest; ++v) {
          all[s.name][static_cast<std::size_t>(place_of({u, v}, s.rings))].push_back({u, v});
        }
      }
    }
    return all;
  }();
  return tables.at(shape.name);
}

}  // namespace tribunal
