#include "exact/harness/shrink.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "exact/kernels/dyadic.h"

namespace tribunal {
namespace {

/// The fifteen coordinates, and which five of them belong to points: a direction does not translate.
struct Coordinates {
  std::array<Point3*, 5> v;
  int points;
};

Coordinates coordinates_of(Query& query) {
  Triangle& t = query.triangle;
  if (auto* s = std::get_if<Segment>(&query.probe)) return {{&t.a, &t.b, &t.c, &s->p, &s->q}, 5};
  Ray& r = std::get<Ray>(query.probe);
  return {{&t.a, &t.b, &t.c, &r.o, &r.d.v}, 4};
}

int significand_bits(double x) {
  if (x == 0) return 0;
  int exponent = 0;
  auto m = static_cast<std::uint64_t>(std::ldexp(std::frexp(std::fabs(x), &exponent), 53));
  while ((m & 1) == 0) m >>= 1;
  return 64 - __builtin_clzll(m);
}

struct Cost {
  int bits = 0, exponents = 0, negatives = 0;
  auto operator<=>(const Cost&) const = default;
};

Cost cost_of(Query query) {
  Cost cost;
  for (const Point3* v : coordinates_of(query).v) {
    for (int axis = 0; axis < 3; ++axis) {
      const double x = (*v)[axis];
      cost.bits += significand_bits(x);
      cost.exponents += x == 0 ? 0 : std::abs(std::ilogb(x));
      cost.negatives += std::signbit(x);
    }
  }
  return cost;
}

bool representable(double x, Format format) { return std::isfinite(x) && is_exact_in(x, format); }

class Shrinker {
 public:
  Shrinker(const Method& method, const Query& query, Format format, int budget)
      : method_(method),
        format_(format),
        budget_(budget),
        best_(query),
        cost_(cost_of(query)),
        truth_(exact_truth(query)),
        wrong_(method.ask(query).hit) {}

  Query run() {
    while (pass() && budget_ > 0) {
    }
    return best_;
  }

 private:
  /// Takes the candidate if it is simpler and still the same counterexample.
  bool offer(const Query& candidate) {
    const Cost cost = cost_of(candidate);
    if (cost >= cost_ || budget_ <= 0) return false;
    --budget_;
    const Answer answer = method_.ask(candidate);
    if (answer.status != Status::ok || answer.hit != wrong_) return false;
    const Truth truth = exact_truth(candidate);
    if (truth.class_id != truth_.class_id || truth.contact != truth_.contact) return false;
    best_ = candidate;
    cost_ = cost;
    return true;
  }

  bool pass() {
    bool simpler = false;
    for (int axis = 0; axis < 3; ++axis) {
      for (int vertex = 0; vertex < 4; ++vertex) simpler |= translate(axis, vertex);
      simpler |= scale(axis);
      simpler |= negate(axis);
    }
    for (int axis = 0; axis < 3; ++axis) {
      for (const double value : distinct(axis)) simpler |= simplify(axis, value);
    }
    return simpler;
  }

  /// Exactly, or not at all.
  bool translate(int axis, int vertex) {
    Query candidate = best_;
    const Coordinates c = coordinates_of(candidate);
    const double by = (*c.v[static_cast<std::size_t>(vertex)])[axis];
    for (std::size_t i = 0; i < static_cast<std::size_t>(c.points); ++i) {
      double& x = (*c.v[i])[axis];
      const double moved = x - by;
      if (!representable(moved, format_) || sign_of(Dyadic(x) - Dyadic(by) - Dyadic(moved)) != Sign::zero) return false;
      x = moved;
    }
    return offer(candidate);
  }

  bool scale(int axis) {
    Query candidate = best_;
    int largest = 0;
    bool any = false;
    for (const Point3* v : coordinates_of(candidate).v) {
      if ((*v)[axis] == 0) continue;
      const int e = std::ilogb((*v)[axis]);
      largest = any ? std::max(largest, e) : e;
      any = true;
    }
    if (!any || largest == 0) return false;
    for (Point3* v : coordinates_of(candidate).v) {
      const double scaled = std::ldexp((*v)[axis], -largest);
      if (!representable(scaled, format_) || std::ldexp(scaled, largest) != (*v)[axis]) return false;
      (*v)[axis] = scaled;
    }
    return offer(candidate);
  }

  bool negate(int axis) {
    Query candidate = best_;
    for (Point3* v : coordinates_of(candidate).v) (*v)[axis] = 0.0 - (*v)[axis];
    return offer(candidate);
  }

  std::vector<double> distinct(int axis) {
    std::vector<double> values;
    for (const Point3* v : coordinates_of(best_).v) values.push_back((*v)[axis]);
    std::ranges::sort(values);
    values.erase(std::unique(values.begin(), values.end()), values.end());
    return values;
  }

  /// All coordinates of this value on the axis move together: 0, ±1, then ever more significand bits.
  bool simplify(int axis, double value) {
    for (const double simple : {0.0, 1.0, -1.0}) {
      if (replace(axis, value, simple)) return true;
    }
    const int bits = significand_bits(value);
    for (int keep = 1; keep < bits; ++keep) {
      const int drop = std::ilogb(value) + 1 - keep;
      if (replace(axis, value, std::ldexp(std::nearbyint(std::ldexp(value, -drop)), drop))) return true;
    }
    return false;
  }

  bool replace(int axis, double value, double by) {
    if (by == value && !std::signbit(value)) return false;
    Query candidate = best_;
    for (Point3* v : coordinates_of(candidate).v) {
      if ((*v)[axis] == value) (*v)[axis] = by;
    }
    return representable(by, format_) && offer(candidate);
  }

  const Method& method_;
  const Format format_;
  int budget_;
  Query best_;
  Cost cost_;
  const Truth truth_;
  const bool wrong_;
};

}  // namespace

Query shrink(const Method& method, const Query& query, Format format, int budget) {
  return Shrinker(method, query, format, budget).run();
}

}  // namespace tribunal
