// The simplest counterexample so far, and the steps that are the same for all operands.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "exact/shrink/coordinate_rules.h"
#include "exact/trial/judge.h"

namespace tribunal {

/// All vectors of a query, to be changed in place: the target's, then the probe's. The first `points` are points; a
/// direction, which does not translate, is last.
struct QueryVectors {
  std::vector<Point3*> v;
  std::size_t points;
};

QueryVectors vectors_in(Query& query);

/// How simple a query is, the first difference decides: fewer vertices; fewer significand bits in all; exponents nearer
/// to 0; fewer minus signs; of triangles, last, the lexicographic order of the coordinates.
struct QueryCost {
  std::size_t vertices = 0;
  CoordinateCost simplicity{};
  std::array<double, 15> coordinates{};
  auto operator<=>(const QueryCost&) const = default;
};

QueryCost cost_of(Query query);

/// Holds the simplest counterexample so far and takes simpler ones. Every step lowers the cost, of which there are
/// finitely many, so a run ends; and it ends only when no rule finds a step, so its result is its own fixed point.
class Shrinker {
 public:
  Shrinker(const Method& method, const Query& query, Format format);

  const Query& best() const { return best_; }
  const QueryCost& cost() const { return cost_; }
  Format format() const { return format_; }

  /// Takes the candidate if it is simpler and still the same counterexample: the same exact class, contact and
  /// `planar`, wrong in the same way, and no less severe.
  bool offer(const Query& candidate);

  /// Translates all points along the axis so that this one gets the coordinate 0.
  bool translate(int axis, std::size_t vector);

  /// Divides the axis by a power of two.
  bool scale(int axis);

  /// All coordinates of one value on an axis move together, to 0, ±1 or fewer significand bits.
  bool simplify_values();

  /// Drops the bounds of a ray, or gives them simpler values.
  bool simplify_bounds();

 private:
  bool replace_bound(double Bounds::*end, double by);
  bool simplify(int axis, double value);
  bool replace(int axis, double value, double by);

  const Method& method_;
  const Format format_;
  Query best_;
  QueryCost cost_;
  const Truth truth_;
  const Answer wrong_;
  const Outcome outcome_;
  const Severity severity_;
};

/// Tries all rules once, each where it applies. Returns whether one made the query simpler.
bool simplify_triangle(Shrinker& shrinker);
bool simplify_polygon(Shrinker& shrinker);

}  // namespace tribunal
