#include "exact/polygon/shrink.h"

#include <algorithm>
#include <span>

#include "exact/harness/coordinate_rules.h"

namespace tribunal {
namespace {

/// All points of a query, directions last: those do not translate.
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

class PolygonShrinker {
 public:
  PolygonShrinker(const Method& method, const PolygonQuery& query, Format format, int budget)
      : method_(method),
        format_(format),
        budget_(budget),
        best_(query),
        cost_(cost_of(query)),
        truth_(exact_truth(query)),
        wrong_(method.ask(query)) {}

  PolygonQuery run() {
    while (pass() && budget_ > 0) {
    }
    return best_;
  }

 private:
  /// Takes the candidate if it is simpler and still the same counterexample.
  bool offer(const PolygonQuery& candidate) {
    const Cost cost = cost_of(candidate);
    if (cost >= cost_ || budget_ <= 0 || candidate.polygon.vertices.empty()) return false;
    --budget_;
    const PolygonAnswer answer = method_.ask(candidate);
    if (answer.answer.status != Status::ok || answer.answer.hit != wrong_.answer.hit) return false;
    const PolygonTruth truth = exact_truth(candidate);
    if (truth.contact != truth_.contact || truth.planar != truth_.planar) return false;
    if (judge(method_, truth, answer) != Judgement::wrong) return false;
    best_ = candidate;
    cost_ = cost;
    return true;
  }

  bool pass() {
    bool simpler = drop_runs();
    for (int axis = 0; axis < 3; ++axis) {
      for (std::size_t vertex = 0; vertex < coordinates_of(best_).points; ++vertex) simpler |= translate(axis, vertex);
      simpler |= scale(axis);
      simpler |= negate(axis);
    }
    for (int axis = 0; axis < 3; ++axis) {
      for (const double value : distinct_values(coordinates_of(best_).v, axis)) simpler |= simplify(axis, value);
    }
    return simpler;
  }

  /// Whole rings first, then ever shorter runs of vertices.
  bool drop_runs() {
    bool simpler = false;
    for (std::size_t r = best_.polygon.ends.size(); r-- > 0;) {
      for (std::size_t count = Polygon(best_.polygon).ring(r).size(); count > 0; count /= 2) {
        if (r >= best_.polygon.ends.size()) break;
        for (std::size_t first = 0; first + count <= size_of(r);) {
          if (!drop(r, first, count))
            ++first;
          else
            simpler = true;
        }
      }
    }
    return simpler;
  }

  std::size_t size_of(std::size_t r) const {
    return r < best_.polygon.ends.size() ? Polygon(best_.polygon).ring(r).size() : 0;
  }

  bool drop(std::size_t r, std::size_t first, std::size_t count) {
    return offer({best_.probe, without(best_.polygon, r, first, count)});
  }

  bool translate(int axis, std::size_t vertex) {
    PolygonQuery candidate = best_;
    const Coordinates c = coordinates_of(candidate);
    const std::span points(c.v.data(), c.points);
    return translate_exactly(points, axis, (*c.v[vertex])[axis], format_) && offer(candidate);
  }

  bool scale(int axis) {
    PolygonQuery candidate = best_;
    return scale_exactly(coordinates_of(candidate).v, axis, format_) && offer(candidate);
  }

  bool negate(int axis) {
    PolygonQuery candidate = best_;
    for (Point3* v : coordinates_of(candidate).v) (*v)[axis] = 0.0 - (*v)[axis];
    return offer(candidate);
  }

  /// All coordinates of this value on the axis move together.
  bool simplify(int axis, double value) {
    const std::vector<double> simpler = simpler_values(value);
    return std::ranges::any_of(simpler, [&](double by) { return replace(axis, value, by); });
  }

  bool replace(int axis, double value, double by) {
    PolygonQuery candidate = best_;
    return replace_value(coordinates_of(candidate).v, axis, value, by, format_) && offer(candidate);
  }

  const Method& method_;
  const Format format_;
  int budget_;
  PolygonQuery best_;
  Cost cost_;
  const PolygonTruth truth_;
  const PolygonAnswer wrong_;
};

}  // namespace

PolygonQuery shrink(const Method& method, const PolygonQuery& query, Format format, int budget) {
  return PolygonShrinker(method, query, format, budget).run();
}

bool is_simpler(const PolygonQuery& a, const PolygonQuery& b) { return cost_of(a) < cost_of(b); }

}  // namespace tribunal
