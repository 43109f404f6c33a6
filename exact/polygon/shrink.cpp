#include "exact/polygon/shrink.h"

#include <algorithm>
#include <vector>

#include "exact/harness/shrink_run.h"

namespace tribunal {
namespace {

/// All vectors of a query, the direction last: it does not translate.
struct Coordinates {
  std::vector<Point3*> v;
  std::size_t points;
};

Coordinates coordinates_of(PolygonQuery& query) {
  Coordinates c;
  for (Point3& v : query.polygon.vertices) c.v.push_back(&v);
  if (auto* s = std::get_if<Segment>(&query.probe)) {
    c.v.insert(c.v.end(), {&s->p, &s->q});
    c.points = c.v.size();
  } else {
    Ray& r = std::get<Ray>(query.probe);
    c.v.insert(c.v.end(), {&r.o, &r.d.v});
    c.points = c.v.size() - 1;
  }
  return c;
}

struct Cost {
  std::size_t vertices = 0;
  CoordinateCost simplicity{};
  auto operator<=>(const Cost&) const = default;
};

Cost cost_of(PolygonQuery query) {
  Cost cost{.vertices = query.polygon.vertices.size()};
  for (const Point3* v : coordinates_of(query).v) {
    for (int axis = 0; axis < 3; ++axis) cost.simplicity.add((*v)[axis]);
  }
  return cost;
}

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

struct PolygonShrinking {
  using Query = PolygonQuery;
  using Truth = PolygonTruth;

  static Cost cost_of(const Query& query) { return tribunal::cost_of(query); }
  static Coordinates vectors_of(Query& query) { return coordinates_of(query); }
  static bool same_case(const Truth& a, const Truth& b) { return a.contact == b.contact && a.planar == b.planar; }
};

class PolygonShrinker : public Shrinker<PolygonShrinking> {
 public:
  using Shrinker::Shrinker;

  bool pass() {
    bool simpler = drop_runs();
    for (int axis = 0; axis < 3; ++axis) {
      for (std::size_t vertex = 0; vertex < points(); ++vertex) simpler |= translate(axis, vertex);
      simpler |= scale(axis);
      simpler |= negate(axis);
    }
    return simplify_values() || simpler;
  }

 private:
  std::size_t points() const {
    return best().polygon.vertices.size() + (std::holds_alternative<Ray>(best().probe) ? 1 : 2);
  }

  /// Whole rings first, then ever shorter runs of vertices. Runs of sixteen vertices and more start at every eighth
  /// part of their length, so that a ring of thousands is soon a short one.
  bool drop_runs() {
    bool simpler = false;
    for (std::size_t r = best().polygon.ends.size(); r-- > 0;) {
      for (std::size_t count = Polygon(best().polygon).ring(r).size(); count > 0; count /= 2) {
        const std::size_t step = std::max<std::size_t>(1, count / 8);
        for (std::size_t first = 0; first + count <= size_of(r);) {
          if (drop(r, first, count)) {
            simpler = true;
          } else {
            first += step;
          }
        }
      }
    }
    return simpler;
  }

  std::size_t size_of(std::size_t r) const {
    return r < best().polygon.ends.size() ? Polygon(best().polygon).ring(r).size() : 0;
  }

  bool drop(std::size_t r, std::size_t first, std::size_t count) {
    return offer({best().probe, without(best().polygon, r, first, count)});
  }

  bool negate(int axis) {
    PolygonQuery candidate = best();
    for (Point3* v : coordinates_of(candidate).v) (*v)[axis] = 0.0 - (*v)[axis];
    return offer(candidate);
  }
};

}  // namespace

PolygonQuery shrink(const Method& method, const PolygonQuery& query, Format format) {
  PolygonShrinker shrinker(method, query, format);
  while (shrinker.pass()) {
  }
  return shrinker.best();
}

bool is_simpler(const PolygonQuery& a, const PolygonQuery& b) { return cost_of(a) < cost_of(b); }

}  // namespace tribunal
