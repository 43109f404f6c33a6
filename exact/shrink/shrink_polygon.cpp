#include <algorithm>
#include <vector>

#include "exact/shrink/shrinker.h"

namespace tribunal {
namespace {

/// The polygon without `count` vertices of a ring from `first` on; without the ring if none is left.
PolygonData without(const PolygonData& polygon, std::size_t r, std::size_t first, std::size_t count) {
  PolygonData rest;
  const Polygon view = polygon;
  for (std::size_t i = 0; i < view.rings(); ++i) {
    std::vector<Point3> ring(view.ring(i).begin(), view.ring(i).end());
    if (i == r) {
      const auto begin = ring.begin() + static_cast<std::ptrdiff_t>(first);
      ring.erase(begin, begin + static_cast<std::ptrdiff_t>(count));
    }
    if (!ring.empty()) rest.add(ring);
  }
  return rest;
}

std::size_t size_of(const Shrinker& s, std::size_t r) {
  const Polygon polygon = s.best().polygon();
  return r < polygon.rings() ? polygon.ring(r).size() : 0;
}

bool drop(Shrinker& s, std::size_t r, std::size_t first, std::size_t count) {
  return s.offer({s.best().probe, without(s.best().polygon(), r, first, count)});
}

/// Drops whole rings first, then ever shorter runs of vertices. Runs of sixteen vertices and more start at multiples of
/// an eighth of their length, so that a ring of thousands soon becomes short.
bool drop_runs(Shrinker& s) {
  bool simpler = false;
  for (std::size_t r = s.best().polygon().ends.size(); r-- > 0;) {
    for (std::size_t count = size_of(s, r); count > 0; count /= 2) {
      const std::size_t step = std::max<std::size_t>(1, count / 8);
      for (std::size_t first = 0; first + count <= size_of(s, r);) {
        if (drop(s, r, first, count)) {
          simpler = true;
        } else {
          first += step;
        }
      }
    }
  }
  return simpler;
}

bool negate(Shrinker& s, int axis) {
  Query candidate = s.best();
  for (Point3* v : vectors_in(candidate).v) (*v)[axis] = 0.0 - (*v)[axis];
  return s.offer(candidate);
}

std::size_t points_of(const Shrinker& s) { return s.best().polygon().vertices.size() + (is_of_ray(s.best()) ? 1 : 2); }

}  // namespace

bool simplify_polygon(Shrinker& s) {
  bool simpler = drop_runs(s);
  for (int axis = 0; axis < 3; ++axis) {
    for (std::size_t vertex = 0; vertex < points_of(s); ++vertex) simpler |= s.translate(axis, vertex);
    simpler |= s.scale(axis);
    simpler |= negate(s, axis);
  }
  return s.simplify_values() || simpler;
}

}  // namespace tribunal
