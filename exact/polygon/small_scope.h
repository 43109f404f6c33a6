// A small scope of polygons, exhausted: every ring of 3 to 6 vertices on a 3×3 grid and every quadrilateral with a
// triangular hole there, degenerate ones included, against piercing points on the half grid and segments in the plane.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/polygon.h"
#include "exact/oracles/caratheodory.h"
#include "exact/oracles/point_in_rings.h"

namespace tribunal {

/// A subject's answers held against those of two oracles, which are held against each other.
struct PolygonScope {
  std::uint64_t polygons = 0, queries = 0, hits = 0;
  std::uint64_t different = 0;       ///< answers of the subject that are not the oracles'
  std::uint64_t contradictions = 0;  ///< points on which the two oracles differ
};

namespace small_scope_detail {

using Cells = std::vector<int>;  ///< grid points 0..8 of a ring

inline constexpr int grid_points = 9, side = 7, piercing_points = side * side, plane_segments = 45;

/// Grid coordinates in half steps, then an integer map that leaves no coordinate plane parallel to the grid's.
inline Point3 placed(int u, int v, int w) { return {u + w, v - u + 2 * w, u + v + w}; }

inline Vec2<std::int64_t> grid_point(int cell) { return {2 * (cell % 3), 2 * (cell / 3)}; }

inline Vec2<std::int64_t> half_grid_point(int i) { return {i % side - 1, i / side - 1}; }

inline Point3 in_space(const Vec2<std::int64_t>& x, int w = 0) {
  return placed(static_cast<int>(x.u), static_cast<int>(x.v), w);
}

/// Every segment between grid points, points included, and the grid edges that each meets.
class PlaneSegments {
 public:
  PlaneSegments() {
    for (int a = 0; a < grid_points; ++a) {
      for (int b = a; b < grid_points; ++b) ends_.push_back({a, b});
    }
    for (int a = 0; a < grid_points; ++a) {
      for (int b = 0; b < grid_points; ++b) {
        const Point3 p = in_space(grid_point(a)), q = in_space(grid_point(b));
        for (std::size_t s = 0; s < ends_.size(); ++s) {
          meets_[a][b][s] = meets_by_caratheodory<std::int64_t>(segment(s), Segment{p, q});
        }
      }
    }
  }
  std::size_t size() const { return ends_.size(); }
  Segment segment(std::size_t s) const {
    return {in_space(grid_point(ends_[s][0])), in_space(grid_point(ends_[s][1]))};
  }
  int source(std::size_t s) const { return ends_[s][0]; }
  bool meets(std::size_t s, int a, int b) const { return meets_[a][b][s]; }

 private:
  std::vector<std::array<int, 2>> ends_;
  bool meets_[grid_points][grid_points][plane_segments]{};
};

/// The probe that has x in the polygon's plane: through it, from it, up to it, in turn.
inline Segment piercing(const Vec2<std::int64_t>& x, int turn) {
  const Vec2<std::int64_t> above{x.u + 1, x.v - 2}, below{x.u - 2, x.v + 4};
  const Point3 at = in_space(x), p = in_space(above, 1), q = in_space(below, -2);
  return turn % 3 == 0 ? Segment{p, q} : turn % 3 == 1 ? Segment{at, q} : Segment{p, at};
}

/// Every ring of n grid points whose first is its lowest.
template <class Visit>
void for_each_ring(int n, const Visit& visit) {
  Cells ring(static_cast<std::size_t>(n));
  for (int first = 0; first < grid_points; ++first) {
    ring.assign(ring.size(), first);
    while (true) {
      visit(ring);
      std::size_t i = ring.size();
      while (--i > 0 && ring[i] == grid_points - 1) ring[i] = first;
      if (i == 0) break;
      ++ring[i];
    }
  }
}

class Scope {
 public:
  /// One polygon, asked in full. `subject(polygon)` gives the function that answers segments.
  template <class Subject>
  void ask(const std::vector<Cells>& rings, const Subject& subject) {
    place(rings);
    ++report.polygons;
    const auto answer = subject(static_cast<const Polygon&>(Polygon(polygon_)));
    for (int i = 0; i < piercing_points; ++i) {
      const Vec2<std::int64_t> x = half_grid_point(i);
      const int turn = i + static_cast<int>(report.polygons % 3);
      count(answer(piercing(x, turn)), see(rings, x) || inside());
    }
    std::array<bool, grid_points> start_inside;
    for (int c = 0; c < grid_points; ++c)
      start_inside[static_cast<std::size_t>(c)] = !see(rings, grid_point(c)) && inside();
    for (std::size_t s = 0; s < segments_.size(); ++s) {
      const bool meets = start_inside[static_cast<std::size_t>(segments_.source(s))] || meets_edge(rings, s);
      count(answer(segments_.segment(s)), meets);
    }
  }

  PolygonScope report;

 private:
  void place(const std::vector<Cells>& rings) {
    polygon_.vertices.clear();
    polygon_.ends.clear();
    for (const Cells& ring : rings) {
      for (const int cell : ring) polygon_.vertices.push_back(in_space(grid_point(cell)));
      polygon_.ends.push_back(polygon_.vertices.size());
    }
  }

  /// Looks at the rings from x; true if x lies on an edge.
  bool see(const std::vector<Cells>& rings, const Vec2<std::int64_t>& x) {
    seen_.clear();
    const auto seen = [&](int cell) {
      const Vec2<std::int64_t> v = grid_point(cell);
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

  void count(bool answered, bool meets) {
    ++report.queries;
    report.hits += meets;
    report.different += answered != meets;
  }

  PlaneSegments segments_;
  PolygonData polygon_;
  std::vector<SeenEdge<std::int64_t>> seen_;
};

}  // namespace small_scope_detail

/// All rings of 3 … most vertices.
template <class Subject>
PolygonScope exhaust_rings(const Subject& subject, int most = 6) {
  small_scope_detail::Scope scope;
  for (int n = 3; n <= most; ++n) {
    small_scope_detail::for_each_ring(n, [&](const small_scope_detail::Cells& ring) { scope.ask({ring}, subject); });
  }
  return scope.report;
}

/// All rings of four vertices, each with every triangle of three different grid points as a hole; or the first few.
template <class Subject>
PolygonScope exhaust_holes(const Subject& subject, std::uint64_t most = UINT64_MAX) {
  using small_scope_detail::grid_points;
  small_scope_detail::Scope scope;
  small_scope_detail::for_each_ring(4, [&](const small_scope_detail::Cells& ring) {
    for (int a = 0; a < grid_points; ++a) {
      for (int b = a + 1; b < grid_points; ++b) {
        for (int c = b + 1; c < grid_points; ++c) {
          if (scope.report.polygons < most) scope.ask({ring, {a, b, c}}, subject);
        }
      }
    }
  });
  return scope.report;
}

}  // namespace tribunal
