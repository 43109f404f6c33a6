#include "tests/exact/mesh/ear_clipping.h"

#include <algorithm>
#include <cmath>

#include "exact/filtered/filtered_kernel.h"

namespace tribunal {
namespace {

using IndexRing = std::vector<std::uint32_t>;

/// Twice the area vector of a ring, in double. It says which axis to drop, and which way the ring runs.
Point3 area_vector(const IndexRing& ring, const std::vector<Point3>& points) {
  Point3 sum(0);
  const Point3& o = points[ring[0]];
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
    const Point3 u = points[ring[i]] - o, v = points[ring[i + 1]] - o;
    sum += Point3(u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x);
  }
  return sum;
}

Axis widest(const Point3& area) {
  const Point3 a(std::fabs(area.x), std::fabs(area.y), std::fabs(area.z));
  return a.x >= a.y && a.x >= a.z ? Axis::x : a.y >= a.z ? Axis::y : Axis::z;
}

/// The outer ring and the holes as one closed ring, in which each bridge between them is passed twice, there and back.
/// The face lies to its left.
class Walk {
 public:
  Walk(const Rings& face, const std::vector<Point3>& points)
      : points_(points), dropped_(widest(area_vector(face[0], points))), ring_(face[0]) {
    left_ = sign_of(area_vector(ring_, points)[static_cast<int>(dropped_)]);
    for (std::size_t i = 1; i < face.size(); ++i) {
      holes_.push_back(face[i]);
      const Sign turn = sign_of(area_vector(face[i], points)[static_cast<int>(dropped_)]);
      if (turn == left_) std::reverse(holes_.back().begin(), holes_.back().end());
    }
  }

  /// Whether no two edges cross at an inner point of both.
  bool is_simple() const {
    std::vector<std::array<std::uint32_t, 2>> edges;
    const auto add = [&](const IndexRing& ring) {
      for (std::size_t i = 0; i < ring.size(); ++i) edges.push_back({ring[i], ring[(i + 1) % ring.size()]});
    };
    add(ring_);
    for (const IndexRing& hole : holes_) add(hole);
    for (const auto& e : edges) {
      const auto crosses_e = [&](const auto& f) { return crosses(e[0], e[1], f[0], f[1]); };
      if (std::any_of(edges.begin(), edges.end(), crosses_e)) return false;
    }
    return true;
  }

  /// Whether a vertex lies on an edge that it does not belong to. Of the rings as given: ask before holes are joined.
  bool touches_itself() const {
    return touches_some_vertex(ring_) ||
           std::any_of(holes_.begin(), holes_.end(), [&](const IndexRing& hole) { return touches_some_vertex(hole); });
  }

  bool join_holes() {
    while (!holes_.empty()) {
      if (!join_one()) return false;
    }
    return true;
  }

  /// Cuts the first ear found until a triangle is left. Each triangle turns as the outer ring does, so together they
  /// cover each point as often as the rings wind around it.
  std::optional<std::vector<std::array<std::uint32_t, 3>>> cut() {
    std::vector<std::array<std::uint32_t, 3>> triangles;
    while (ring_.size() > 3) {
      const std::size_t i = next_ear();
      if (i == ring_.size()) return std::nullopt;
      if (turn(at(i - 1), at(i), at(i + 1)) != Sign::zero) triangles.push_back({at(i - 1), at(i), at(i + 1)});
      ring_.erase(ring_.begin() + static_cast<std::ptrdiff_t>(i));
    }
    const Sign rest = turn(at(0), at(1), at(2));
    if (rest == Sign::negative) return std::nullopt;
    if (rest == Sign::positive) triangles.push_back({at(0), at(1), at(2)});
    return triangles;
  }

  /// Whether no two of these, which turn as the outer ring does, have an inner point in common.
  bool are_disjoint(const std::vector<std::array<std::uint32_t, 3>>& triangles) const {
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if (!separates(triangles[i], triangles[j]) && !separates(triangles[j], triangles[i])) return false;
      }
    }
    return true;
  }

 private:
  std::uint32_t at(std::size_t i) const { return ring_[(i + ring_.size()) % ring_.size()]; }
  bool same(std::uint32_t a, std::uint32_t b) const { return points_[a] == points_[b]; }

  /// Positive where a, b, c turn as the outer ring does.
  Sign turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    return left_ * FilteredKernel().orient2d(dropped_, points_[a], points_[b], points_[c]);
  }

  bool in_triangle(std::uint32_t x, std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    return turn(a, b, x) != Sign::negative && turn(b, c, x) != Sign::negative && turn(c, a, x) != Sign::negative;
  }

  /// Whether the corner i can be cut. A spike (the ring turns back on itself) is cut without a triangle; a flat corner
  /// is not cut before it has become another.
  bool is_ear(std::size_t i) const {
    const std::uint32_t a = at(i - 1), b = at(i), c = at(i + 1);
    if (same(a, b) || same(b, c) || same(a, c)) return true;
    if (turn(a, b, c) != Sign::positive) return false;
    return std::none_of(ring_.begin(), ring_.end(), [&](std::uint32_t x) {
      return !same(x, a) && !same(x, b) && !same(x, c) && in_triangle(x, a, b, c);
    });
  }

  std::size_t next_ear() const {
    for (std::size_t i = 0; i < ring_.size(); ++i) {
      if (is_ear(i)) return i;
    }
    return ring_.size();
  }

  /// Whether x lies strictly between the edges of the corner a, b, c, on the side of the face.
  bool in_corner(std::uint32_t x, std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    const bool left_of_ab = turn(a, b, x) == Sign::positive, left_of_bc = turn(b, c, x) == Sign::positive;
    return turn(a, b, c) == Sign::positive ? left_of_ab && left_of_bc : left_of_ab || left_of_bc;
  }

  /// Whether all of g lies beyond one edge of f, or on its line.
  bool separates(const std::array<std::uint32_t, 3>& f, const std::array<std::uint32_t, 3>& g) const {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto beyond = [&](std::uint32_t x) { return turn(f[i], f[(i + 1) % 3], x) != Sign::positive; };
      if (std::all_of(g.begin(), g.end(), beyond)) return true;
    }
    return false;
  }

  /// Whether x, seen along the dropped axis, is on the closed segment ab.
  bool is_on(std::uint32_t x, std::uint32_t a, std::uint32_t b) const {
    const auto between = [&](Axis axis) {
      const auto i = static_cast<int>(axis);
      const auto [low, high] = std::minmax(points_[a][i], points_[b][i]);
      return axis == dropped_ || (low <= points_[x][i] && points_[x][i] <= high);
    };
    return std::all_of(std::begin(all_axes), std::end(all_axes), between) && turn(a, b, x) == Sign::zero;
  }

  bool touches_some_vertex(const IndexRing& edges) const {
    const auto touches_vertex_of = [&](const IndexRing& ring) {
      for (std::size_t i = 0; i < edges.size(); ++i) {
        const std::size_t next = (i + 1) % edges.size();
        for (std::size_t j = 0; j < ring.size(); ++j) {
          if (&ring == &edges && (j == i || j == next)) continue;
          if (is_on(ring[j], edges[i], edges[next])) return true;
        }
      }
      return false;
    };
    return touches_vertex_of(ring_) || std::any_of(holes_.begin(), holes_.end(), touches_vertex_of);
  }

  bool crosses(std::uint32_t p, std::uint32_t q, std::uint32_t a, std::uint32_t b) const {
    return turn(p, q, a) * turn(p, q, b) == Sign::negative && turn(a, b, p) * turn(a, b, q) == Sign::negative;
  }

  /// Whether the bridge pq meets the edge ab anywhere but at a common end.
  bool meets(std::uint32_t p, std::uint32_t q, std::uint32_t a, std::uint32_t b) const {
    const bool shares_a = same(p, a) || same(q, a), shares_b = same(p, b) || same(q, b);
    const Sign a_side = turn(p, q, a), b_side = turn(p, q, b);
    if (shares_a || shares_b) return (shares_a ? b_side : a_side) == Sign::zero;
    return a_side * b_side != Sign::positive && turn(a, b, p) * turn(a, b, q) != Sign::positive;
  }

  bool meets_ring(std::uint32_t p, std::uint32_t q, const IndexRing& ring) const {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      if (meets(p, q, ring[i], ring[(i + 1) % ring.size()])) return true;
    }
    return false;
  }

  bool is_bridge(std::size_t i, const IndexRing& hole, std::size_t j) const {
    const std::size_t n = hole.size();
    if (!in_corner(hole[j], at(i - 1), at(i), at(i + 1))) return false;
    if (!in_corner(at(i), hole[(j + n - 1) % n], hole[j], hole[(j + 1) % n])) return false;
    return !meets_ring(at(i), hole[j], ring_) && std::none_of(holes_.begin(), holes_.end(), [&](const IndexRing& h) {
      return meets_ring(at(i), hole[j], h);
    });
  }

  /// Whether corner j of the hole is at corner i of the ring, with the hole inside: a bridge without length.
  bool touches(std::size_t i, const IndexRing& hole, std::size_t j) const {
    const std::size_t n = hole.size();
    return same(at(i), hole[j]) && in_corner(hole[(j + 1) % n], at(i - 1), at(i), at(i + 1)) &&
           in_corner(hole[(j + n - 1) % n], at(i - 1), at(i), at(i + 1));
  }

  /// Joins one hole to the ring. Holes that touch it come first, since no bridge can pass where they touch.
  bool join_one() {
    return join([this](std::size_t i, const IndexRing& hole, std::size_t j) { return touches(i, hole, j); }) ||
           join([this](std::size_t i, const IndexRing& hole, std::size_t j) { return is_bridge(i, hole, j); });
  }

  template <class Joins>
  bool join(const Joins& joins) {
    for (std::size_t h = 0; h < holes_.size(); ++h) {
      for (std::size_t i = 0; i < ring_.size(); ++i) {
        for (std::size_t j = 0; j < holes_[h].size(); ++j) {
          if (!joins(i, holes_[h], j)) continue;
          splice(i, h, j);
          return true;
        }
      }
    }
    return false;
  }

  /// Inserts the hole after rᵢ: …, rᵢ, hⱼ, hⱼ₊₁, …, hⱼ, rᵢ, …
  void splice(std::size_t i, std::size_t h, std::size_t j) {
    IndexRing detour(holes_[h].begin() + static_cast<std::ptrdiff_t>(j), holes_[h].end());
    detour.insert(detour.end(), holes_[h].begin(), holes_[h].begin() + static_cast<std::ptrdiff_t>(j) + 1);
    detour.push_back(ring_[i]);
    ring_.insert(ring_.begin() + static_cast<std::ptrdiff_t>(i) + 1, detour.begin(), detour.end());
    holes_.erase(holes_.begin() + static_cast<std::ptrdiff_t>(h));
  }

  const std::vector<Point3>& points_;
  Axis dropped_;
  IndexRing ring_;
  std::vector<IndexRing> holes_;
  Sign left_ = Sign::positive;
};

}  // namespace

std::optional<std::vector<std::array<std::uint32_t, 3>>> clip_ears(const Rings& face,
                                                                   const std::vector<Point3>& points) {
  Walk walk(face, points);
  if (!walk.is_simple()) return std::nullopt;
  const bool touches = walk.touches_itself();
  if (!walk.join_holes()) return std::nullopt;
  auto triangles = walk.cut();
  // Rings that touch may wind around some points twice; others do not.
  if (triangles && touches && !walk.are_disjoint(*triangles)) return std::nullopt;
  return triangles;
}

}  // namespace tribunal
