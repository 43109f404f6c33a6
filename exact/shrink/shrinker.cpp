#include "exact/shrink/shrinker.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "exact/base/interrupt.h"
#include "exact/trial/observe.h"
#include "exact/trial/severity.h"

namespace tribunal {
namespace {

void add_vectors(QueryVectors& c, Triangle& t) { c.v.insert(c.v.end(), {&t.a, &t.b, &t.c}); }

void add_vectors(QueryVectors& c, PolygonData& polygon) {
  for (Point3& v : polygon.vertices) c.v.push_back(&v);
}

void add_vectors(QueryVectors& c, Segment& s) { c.v.insert(c.v.end(), {&s.p, &s.q}); }
void add_vectors(QueryVectors& c, Ray& r) { c.v.insert(c.v.end(), {&r.o, &r.d.v}); }

/// Neither bound, or a simpler number.
std::vector<double> simpler_values_of_bound(double t) {
  std::vector<double> values{0, std::numeric_limits<double>::infinity()};
  if (!std::isfinite(t)) return values;
  const std::vector<double> finite = simpler_values(t);
  values.insert(values.end(), finite.begin(), finite.end());
  return values;
}

bool is_same_case(const Truth& a, const Truth& b) {
  return a.class_id == b.class_id && a.contact == b.contact && a.planar == b.planar && a.at == b.at;
}

}  // namespace

QueryVectors vectors_in(Query& query) {
  QueryVectors c{};
  const auto add = [&](auto& operand) { add_vectors(c, operand); };
  std::visit(add, query.target);
  std::visit(add, query.probe);
  c.points = c.v.size() - (is_of_ray(query) ? 1 : 0);
  return c;
}

QueryCost cost_of(Query query) {
  const bool triangle = query.operands() == Operands::triangles;
  const QueryVectors c = vectors_in(query);
  QueryCost cost{.vertices = c.v.size()};
  if (query.bounds) {
    cost.vertices += 1 + (query.bounds->tmin != 0) + std::isfinite(query.bounds->tmax);
    for (const double t : {query.bounds->tmin, query.bounds->tmax}) {
      if (std::isfinite(t)) cost.simplicity.add(t);
    }
  }
  std::size_t i = 0;
  for (const Point3* v : c.v) {
    for (int axis = 0; axis < 3; ++axis) {
      cost.simplicity.add((*v)[axis]);
      if (triangle) cost.coordinates[i++] = (*v)[axis];
    }
  }
  return cost;
}

Shrinker::Shrinker(const Method& method, const Query& query, Format format)
    : method_(method),
      format_(format),
      best_(query),
      cost_(cost_of(query)),
      truth_(exact_truth(query)),
      wrong_(try_ask(method, query).answer),
      outcome_(judge(method, truth_, wrong_)),
      severity_(severity_of(query, truth_)) {}

bool Shrinker::offer(const Query& candidate) {
  fail_if_interrupted("a counterexample was being shrunk");
  const QueryCost cost = cost_of(candidate);
  if (cost >= cost_) return false;
  const Asked asked = try_ask(method_, candidate);
  if (asked.fault || asked.answer.status != Status::ok || asked.answer.hit != wrong_.hit) return false;
  const Truth truth = exact_truth(candidate);
  const Outcome outcome = judge(method_, truth, asked.answer);
  if (!is_same_case(truth, truth_) || !is_wrong(outcome) || outcome != outcome_) return false;
  if (severity_of(candidate, truth) > severity_) return false;
  best_ = candidate;
  cost_ = cost;
  return true;
}

bool Shrinker::translate(int axis, std::size_t vector) {
  Query candidate = best_;
  const QueryVectors c = vectors_in(candidate);
  const std::span points(c.v.data(), c.points);
  return translate_exactly(points, axis, (*c.v[vector])[axis], format_) && offer(candidate);
}

bool Shrinker::scale(int axis) {
  Query candidate = best_;
  return scale_exactly(vectors_in(candidate).v, axis, format_) && offer(candidate);
}

bool Shrinker::simplify_values() {
  bool simpler = false;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double value : distinct_values(vectors_in(best_).v, axis)) simpler |= simplify(axis, value);
  }
  return simpler;
}

bool Shrinker::simplify_bounds() {
  bool simpler = false;
  for (double Bounds::*const end : {&Bounds::tmin, &Bounds::tmax}) {
    if (!best_.bounds) return simpler;
    std::vector<double> values = simpler_values_of_bound((*best_.bounds).*end);
    simpler |= std::ranges::any_of(values, [&](double by) { return replace_bound(end, by); });
  }
  return simpler;
}

bool Shrinker::replace_bound(double Bounds::*end, double by) {
  Query candidate = best_;
  Bounds& bounds = *candidate.bounds;
  bounds.*end = by;
  if (!(bounds.tmin >= 0 && bounds.tmin <= bounds.tmax) || std::isinf(bounds.tmin) || !is_exact_in(by, format_)) {
    return false;
  }
  return offer(candidate);
}

bool Shrinker::simplify(int axis, double value) {
  const std::vector<double> simpler = simpler_values(value);
  return std::ranges::any_of(simpler, [&](double by) { return replace(axis, value, by); });
}

bool Shrinker::replace(int axis, double value, double by) {
  Query candidate = best_;
  return replace_value(vectors_in(candidate).v, axis, value, by, format_) && offer(candidate);
}

}  // namespace tribunal
