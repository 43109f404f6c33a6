// What shrinking is, whatever the operands. Included by the files that have the rules: harness/shrink.cpp and
// polygon/shrink.cpp.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "exact/harness/coordinate_rules.h"
#include "exact/harness/fuzz.h"
#include "exact/harness/observe.h"

namespace tribunal {

/// Holds the simplest counterexample so far and takes simpler ones. Every step lowers the cost, of which there are
/// finitely many, so a run ends; and it ends only when no rule finds a step, so its result is its own fixed point.
///
/// `On` has Query and Truth; `cost_of(query)`; `vectors_of(query)`, whose `v` are all vectors, to be changed in place,
/// of which the first `points` are points (directions do not translate); and `same_case(truth, truth)`.
template <class On>
class Shrinker {
 public:
  using Query = typename On::Query;

  Shrinker(const Method& method, const Query& query, Format format)
      : method_(method),
        format_(format),
        best_(query),
        cost_(On::cost_of(query)),
        truth_(exact_truth(query)),
        wrong_(plain(try_ask(method, query).answer)) {}

  const Query& best() const { return best_; }
  const auto& cost() const { return cost_; }

  /// Takes the candidate if it is simpler and still the same counterexample.
  bool offer(const Query& candidate) {
    const auto cost = On::cost_of(candidate);
    if (cost >= cost_) return false;
    const auto asked = try_ask(method_, candidate);
    if (asked.fault || plain(asked.answer).status != Status::ok || plain(asked.answer).hit != wrong_.hit) return false;
    const typename On::Truth truth = exact_truth(candidate);
    if (!On::same_case(truth, truth_) || judge(method_, truth, asked.answer) != Judgement::wrong) return false;
    best_ = candidate;
    cost_ = cost;
    return true;
  }

  /// Moves the vertex to the origin of the axis, and all with it.
  bool translate(int axis, std::size_t vertex) {
    Query candidate = best_;
    const auto c = On::vectors_of(candidate);
    const std::span points(c.v.data(), static_cast<std::size_t>(c.points));
    return translate_exactly(points, axis, (*c.v[vertex])[axis], format_) && offer(candidate);
  }

  bool scale(int axis) {
    Query candidate = best_;
    return scale_exactly(On::vectors_of(candidate).v, axis, format_) && offer(candidate);
  }

  /// All coordinates of one value on an axis move together.
  bool simplify_values() {
    bool simpler = false;
    for (int axis = 0; axis < 3; ++axis) {
      for (const double value : distinct_values(On::vectors_of(best_).v, axis)) simpler |= simplify(axis, value);
    }
    return simpler;
  }

 private:
  bool simplify(int axis, double value) {
    const std::vector<double> simpler = simpler_values(value);
    return std::ranges::any_of(simpler, [&](double by) { return replace(axis, value, by); });
  }

  bool replace(int axis, double value, double by) {
    Query candidate = best_;
    return replace_value(On::vectors_of(candidate).v, axis, value, by, format_) && offer(candidate);
  }

  const Method& method_;
  const Format format_;
  Query best_;
  decltype(On::cost_of(best_)) cost_;
  const typename On::Truth truth_;
  const Answer wrong_;
};

}  // namespace tribunal
