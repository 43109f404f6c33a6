// A small scope of polygons, exhausted: every ring of 3 to 6 vertices on a 3×3 grid and every quadrilateral with a
// triangular hole there, degenerate ones included, against piercing points on the half grid and segments in the plane.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "core/due.h"
#include "core/polygon.h"
#include "exact/oracles/caratheodory.h"
#include "exact/oracles/point_in_rings.h"

namespace tribunal {

/// The answers of the function under test, compared with those of two oracles, which are compared with each other.
struct PolygonScope {
  std::uint64_t polygons = 0, queries = 0, hits = 0;
  std::uint64_t different = 0;       ///< answers that differ from those of the oracles
  std::uint64_t contradictions = 0;  ///< points on which the two oracles differ
};

/// Which vertex the rings, and so the covering, start with: their lowest, which is on the hull; or the grid's centre.
enum class Start : std::uint8_t { lowest, centre };

/// Which rings, and how fine the piercing points are: half a grid step, over `refinement`.
struct RingScope {
  int most_vertices = 6;
  Start start = Start::lowest;
  int refinement = 1;
};

namespace small_scope_detail {

using Cells = std::vector<int>;  ///< grid points 0..8 of a ring

inline constexpr int grid_points = 9, centre = 4, plane_segments = 45;

/// An integer map of the plane and its normal that leaves no coordinate plane parallel to the grid's.
inline Point3 placed(int u, int v, int w) { return {u + w, v - u + 2 * w, u + v + w}; }

/// The grid and the points around it, in integers: half a grid step is `refinement` units.
struct Grid {
  int refinement;

  int side() const { return 6 * refinement + 1; }
  Vec2<std::int64_t> vertex(int cell) const { return {2 * refinement * (cell % 3), 2 * refinement * (cell / 3)}; }
  Vec2<std::int64_t> point(int i) const { return {i % side() - refinement, i / side() - refinement}; }
};

inline Point3 in_space(const Vec2<std::int64_t>& x, int w = 0) {
  return placed(static_cast<int>(x.u), static_cast<int>(x.v), w);
}

/// Every segment between grid points, those that are points included, and which segments between grid points each
/// meets.
class PlaneSegments {
 public:
  explicit PlaneSegments(const Grid& grid) : grid_(grid) {
    for (int a = 0; a < grid_points; ++a) {
      for (int b = a; b < grid_points; ++b) ends_.push_back({a, b});
    }
    for (int a = 0; a < grid_points; ++a) {
      for (int b = 0; b < grid_points; ++b) {
        const Point3 p = in_space(grid_.vertex(a)), q = in_space(grid_.vertex(b));
        for (std::size_t s = 0; s < ends_.size(); ++s) {
          meets_[a][b][s] = meets_by_caratheodory<std::int64_t>(segment(s), Triangle{p, q, q});
        }
      }
    }
  }
  std::size_t size() const { return ends_.size(); }
  Segment segment(std::size_t s) const {
    return {in_space(grid_.vertex(ends_[s][0])), in_space(grid_.vertex(ends_[s][1]))};
  }
  int source(std::size_t s) const { return ends_[s][0]; }
  bool meets(std::size_t s, int a, int b) const { return meets_[a][b][s]; }

 private:
  Grid grid_;
  std::vector<std::array<int, 2>> ends_;
  bool meets_[grid_points][grid_points][plane_segments]{};
};

/// The segment that meets the polygon's plane in x: through it, from it or up to it, by the turn.
inline Segment piercing(const Vec2<std::int64_t>& x, int turn) {
  const Vec2<std::int64_t> above{x.u + 1, x.v - 2}, below{x.u - 2, x.v + 4};
  const Point3 at = in_space(x), p = in_space(above, 1), q = in_space(below, -2);
  return turn % 3 == 0 ? Segment{p, q} : turn % 3 == 1 ? Segment{at, q} : Segment{p, at};
}

/// Calls `visit` with every ring of n grid points that has this start.
template <class Visit>
void for_each_ring(int n, Start start, const Visit& visit) {
  Cells ring(static_cast<std::size_t>(n));
  for (int first = 0; first < grid_points; ++first) {
    if (start == Start::centre && first != centre) continue;
    const int lowest = start == Start::lowest ? first : 0;
    ring.assign(ring.size(), lowest);
    ring[0] = first;
    while (true) {
      visit(ring);
      std::size_t i = ring.size();
      while (--i > 0 && ring[i] == grid_points - 1) ring[i] = lowest;
      if (i == 0) break;
      ++ring[i];
    }
  }
}

class Scope {
 public:
  explicit Scope(int refinement) : grid_{refinement}, segments_(grid_) {}

  /// Asks all cases of one polygon. `subject(polygon)` returns the function that answers segments.
  template <class Subject>
  void ask(const std::vector<Cells>& rings, const Subject& subject) {
    const auto answer = subject(place(rings));
    visit_cases(rings, ++report.polygons, [&](const Segment& s, Contact due, bool) {
      ++report.queries;
      report.hits += due != Contact::none;
      report.different += answer(s) != (due != Contact::none);
    });
  }

  /// The polygon of these rings, valid until the next call.
  const PolygonData& place(const std::vector<Cells>& rings) {
    polygon_.vertices.clear();
    polygon_.ends.clear();
    for (const Cells& ring : rings) {
      for (const int cell : ring) polygon_.vertices.push_back(in_space(grid_.vertex(cell)));
      polygon_.ends.push_back(polygon_.vertices.size());
    }
    return polygon_;
  }

  /// Every case of the polygon: calls `visit(segment, exact contact, whether a ring edge is met)`. `number` is
  /// that of the polygon, which says whose turn it is: segments through, from or up to a point.
  template <class Visit>
  void visit_cases(const std::vector<Cells>& rings, std::uint64_t number, const Visit& visit) {
    const bool flat = is_flat(rings);
    for (int i = 0; i < points(); ++i) {
      const Vec2<std::int64_t> x = grid_.point(i);
      const Contact due = contact_at(rings, x, flat);
      visit(piercing(x, i + static_cast<int>(number % 3)), due, due != Contact::none && due != Contact::interior);
    }
    std::array<bool, grid_points> start_inside;
    for (int c = 0; c < grid_points; ++c)
      start_inside[static_cast<std::size_t>(c)] = !see(rings, grid_.vertex(c)) && inside();
    for (std::size_t s = 0; s < segments_.size(); ++s) {
      const bool boundary = meets_edge(rings, s);
      const bool meets = boundary || start_inside[static_cast<std::size_t>(segments_.source(s))];
      visit(segments_.segment(s), meets ? Contact::coplanar : Contact::none, boundary);
    }
  }

  int points() const { return grid_.side() * grid_.side(); }

  PolygonScope report;

 private:
  /// Whether all vertices lie on a line.
  bool is_flat(const std::vector<Cells>& rings) const {
    const Vec2<std::int64_t> o = grid_.vertex(rings[0][0]);
    Vec2<std::int64_t> along{0, 0};
    for (const Cells& ring : rings) {
      for (const int cell : ring) {
        const Vec2<std::int64_t> v = grid_.vertex(cell), to{v.u - o.u, v.v - o.v};
        if (along.u * to.v != along.v * to.u) return false;
        if (along.u == 0 && along.v == 0) along = to;
      }
    }
    return true;
  }

  /// The contact of a segment that leaves the plane and meets it in x.
  Contact contact_at(const std::vector<Cells>& rings, const Vec2<std::int64_t>& x, bool flat) {
    if (!see(rings, x)) return inside() ? Contact::interior : Contact::none;
    if (flat) return Contact::coplanar;
    const auto at_end = [](const SeenEdge<std::int64_t>& e) { return e.b.u == 0 && e.b.v == 0; };
    return std::any_of(seen_.begin(), seen_.end(), at_end) ? Contact::vertex : Contact::edge;
  }

  /// Puts the ring edges as seen from x into `seen_`; true if x lies on an edge.
  bool see(const std::vector<Cells>& rings, const Vec2<std::int64_t>& x) {
    seen_.clear();
    const auto seen = [&](int cell) {
      const Vec2<std::int64_t> v = grid_.vertex(cell);
      return Vec2<std::int64_t>{v.u - x.u, v.v - x.v};
    };
    for (const Cells& ring : rings) {
      int a = ring.back();
      for (const int b : ring) {
        seen_.push_back({seen(a), seen(b)});
        a = b;
      }
    }
    return on_ring_edge(seen_);
  }

  bool inside() {
    const bool by_ray = inside_by_generic_ray(seen_);
    report.contradictions += by_ray != inside_by_half_open_crossings(seen_);
    return by_ray;
  }

  bool meets_edge(const std::vector<Cells>& rings, std::size_t s) const {
    for (const Cells& ring : rings) {
      int a = ring.back();
      for (const int b : ring) {
        if (segments_.meets(s, a, b)) return true;
        a = b;
      }
    }
    return false;
  }

  Grid grid_;
  PlaneSegments segments_;
  PolygonData polygon_;
  std::vector<SeenEdge<std::int64_t>> seen_;
};

}  // namespace small_scope_detail

/// Asks about all rings of 3 to `rings.most_vertices` vertices.
template <class Subject>
PolygonScope exhaust_rings(const Subject& subject, const RingScope& rings = {}) {
  small_scope_detail::Scope scope(rings.refinement);
  for (int n = 3; n <= rings.most_vertices; ++n) {
    small_scope_detail::for_each_ring(n, rings.start,
                                      [&](const small_scope_detail::Cells& ring) { scope.ask({ring}, subject); });
  }
  return scope.report;
}

/// Calls `visit` with every triangle of three different grid points.
template <class Visit>
void for_each_hole(const Visit& visit) {
  using small_scope_detail::grid_points;
  for (int a = 0; a < grid_points; ++a) {
    for (int b = a + 1; b < grid_points; ++b) {
      for (int c = b + 1; c < grid_points; ++c) visit(small_scope_detail::Cells{a, b, c});
    }
  }
}

/// Asks about all rings of four vertices, each with every triangle as a hole; or about the first `most` of these.
template <class Subject>
PolygonScope exhaust_holes(const Subject& subject, std::uint64_t most = UINT64_MAX) {
  small_scope_detail::Scope scope(1);
  small_scope_detail::for_each_ring(4, Start::lowest, [&](const small_scope_detail::Cells& ring) {
    for_each_hole([&](const small_scope_detail::Cells& hole) {
      if (scope.report.polygons < most) scope.ask({ring, hole}, subject);
    });
  });
  return scope.report;
}

}  // namespace tribunal
