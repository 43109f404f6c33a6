#include "exact/polygon/relations.h"

#include <algorithm>
#include <cmath>

#include "exact/harness/observe.h"
#include "exact/kernels/dyadic.h"
#include "exact/oracles/polygon_oracles.h"

namespace tribunal {
namespace {

using Rings = std::vector<std::vector<Point3>>;

Rings rings_of(const Polygon& polygon) {
  Rings rings;
  for (std::size_t r = 0; r < polygon.rings(); ++r) rings.emplace_back(polygon.ring(r).begin(), polygon.ring(r).end());
  return rings;
}

PolygonQuery with_rings(const PolygonQuery& query, const Rings& rings) {
  PolygonQuery changed{query.probe, {}};
  for (const auto& ring : rings) changed.polygon.add(ring);
  return changed;
}

std::vector<Point3>& any_ring(Rings& rings, Draw& draw) { return rings[draw.below(rings.size())]; }

using Changed = std::optional<PolygonQuery>;

Changed start_vertex(const PolygonQuery& query, Format, Draw& draw) {
  Rings rings = rings_of(query.polygon);
  for (auto& ring : rings) {
    const auto by = static_cast<std::ptrdiff_t>(draw.below(ring.size()));
    std::rotate(ring.begin(), ring.begin() + by, ring.end());
  }
  return with_rings(query, rings);
}

Changed ring_direction(const PolygonQuery& query, Format, Draw& draw) {
  Rings rings = rings_of(query.polygon);
  auto& ring = any_ring(rings, draw);
  std::reverse(ring.begin(), ring.end());
  return with_rings(query, rings);
}

Changed ring_order(const PolygonQuery& query, Format, Draw& draw) {
  Rings rings = rings_of(query.polygon);
  if (rings.size() < 2) return std::nullopt;
  const auto by = static_cast<std::ptrdiff_t>(1 + draw.below(rings.size() - 1));
  std::rotate(rings.begin(), rings.begin() + by, rings.end());
  return with_rings(query, rings);
}

Changed repeated_vertex(const PolygonQuery& query, Format, Draw& draw) {
  Rings rings = rings_of(query.polygon);
  auto& ring = any_ring(rings, draw);
  const auto at = static_cast<std::ptrdiff_t>(draw.below(ring.size()));
  const Point3 v = ring[static_cast<std::size_t>(at)];
  ring.insert(ring.begin() + at, v);
  return with_rings(query, rings);
}

/// m is the midpoint of ab, exactly.
bool is_midpoint(const Point3& a, const Point3& b, const Point3& m) {
  for (int axis = 0; axis < 3; ++axis) {
    const Dyadic excess = Dyadic(a[axis]) + Dyadic(b[axis]) - Dyadic(m[axis]) - Dyadic(m[axis]);
    if (sign_of(excess) != Sign::zero) return false;
  }
  return true;
}

/// The midpoint of an edge becomes a vertex.
Changed flat_vertex(const PolygonQuery& query, Format format, Draw& draw) {
  Rings rings = rings_of(query.polygon);
  auto& ring = any_ring(rings, draw);
  const std::size_t i = draw.below(ring.size());
  const Point3 a = ring[i], b = ring[(i + 1) % ring.size()];
  const Point3 middle = in_format(a / 2.0 + b / 2.0, format);
  if (!is_finite(middle) || !is_midpoint(a, b, middle)) return std::nullopt;
  ring.insert(ring.begin() + static_cast<std::ptrdiff_t>(i) + 1, middle);
  return with_rings(query, rings);
}

Changed reversed_segment(const PolygonQuery& query, Format, Draw&) {
  const auto* s = std::get_if<Segment>(&query.probe);
  if (s == nullptr) return std::nullopt;
  return PolygonQuery{Segment{s->q, s->p}, query.polygon};
}

/// Applies f to every point and direction.
template <class F>
PolygonQuery moved(PolygonQuery query, const F& f) {
  for (Point3& v : query.polygon.vertices) v = f(v);
  if (auto* s = std::get_if<Segment>(&query.probe)) {
    s->p = f(s->p);
    s->q = f(s->q);
  } else {
    Ray& r = std::get<Ray>(query.probe);
    r.o = f(r.o);
    r.d.v = f(r.d.v);
  }
  return query;
}

/// One of the 48 signed permutations of the axes.
Changed signed_axes(const PolygonQuery& query, Format, Draw& draw) {
  const auto turn = static_cast<int>(draw.below(3));
  const bool swap = draw.below(2) == 0;
  const std::uint64_t signs = draw.below(8);
  return moved(query, [&](const Point3& v) {
    Point3 w{v[turn], v[(turn + 1) % 3], v[(turn + 2) % 3]};
    if (swap) std::swap(w.x, w.y);
    for (int axis = 0; axis < 3; ++axis) w[axis] = (signs >> axis & 1) != 0 ? -w[axis] : w[axis];
    return w;
  });
}

/// Each axis by a power of two of its own, where no bit is lost.
Changed powers_of_two(const PolygonQuery& query, Format format, Draw& draw) {
  int by[3];
  for (int& e : by) e = static_cast<int>(draw.between(-20, 20));
  bool exact = true;
  const PolygonQuery changed = moved(query, [&](const Point3& v) {
    Point3 w;
    for (int axis = 0; axis < 3; ++axis) {
      w[axis] = std::ldexp(v[axis], by[axis]);
      exact =
          exact && std::isfinite(w[axis]) && is_exact_in(w[axis], format) && std::ldexp(w[axis], -by[axis]) == v[axis];
    }
    return w;
  });
  return exact ? Changed(changed) : std::nullopt;
}

bool keeps(const PolygonRelation& relation, const PolygonAnswer& before, const PolygonAnswer& after) {
  if (before.answer.hit != after.answer.hit || before.planar != after.planar) return false;
  return !relation.keeps_contact || before.answer.contact == after.answer.contact;
}

bool promises_all(const PolygonPromise& promise) { return promise.boundary && promise.surface; }

/// Whether the method owes an answer to the query: asked exactly, where it does not promise all.
bool owes(const Method& method, const PolygonTrial& trial) {
  if (!takes(method, trial.format)) return false;
  return promises_all(method.polygon_promise) || is_promised(method.polygon_promise, exact_truth(trial.query));
}

void ask(const Method& method, const PolygonRelation& relation, const PolygonQuery& query, const PolygonQuery& changed,
         std::uint64_t g, PolygonRelationCount& count) {
  const PolygonAnswer before = ask_or_fail(method, query), after = ask_or_fail(method, changed);
  if (before.answer.status != Status::ok || after.answer.status != Status::ok) return;
  count.add(keeps(relation, before, after), g, {query, changed});
}

/// The change of a relation is a function of the case and the relation, so every method sees the same queries.
void run_case(const PolygonFuzzPlan& plan, std::uint64_t g, std::vector<PolygonRelationCount>& counts) {
  const PolygonStream& source = plan.streams[g % plan.streams.size()];
  const PolygonTrial trial = source.family->make(source.format, plan.seed, g / plan.streams.size());
  const bool planar = is_planar_by_normal<Dyadic>(trial.query.polygon);
  const std::span<const PolygonRelation> relations = all_polygon_relations();
  for (std::size_t m = 0; m < plan.methods.size(); ++m) {
    if (!owes(plan.methods[m], trial)) continue;
    for (std::size_t r = 0; r < relations.size(); ++r) {
      Draw draw(static_cast<std::uint32_t>(200 + r), plan.seed, g);
      if (relations[r].planar_only && !planar) continue;
      const Changed changed = relations[r].change(trial.query, source.format, draw);
      if (changed) ask(plan.methods[m], relations[r], trial.query, *changed, g, counts[m * relations.size() + r]);
    }
  }
}

}  // namespace

std::span<const PolygonRelation> all_polygon_relations() {
  static constexpr PolygonRelation table[] = {
      {"start-vertex", "where the rings of a planar polygon start does not matter", true, true, start_vertex},
      {"ring-direction", "nor which way they run", true, true, ring_direction},
      {"ring-order", "nor which of them is the outer one", true, true, ring_order},
      {"repeated-vertex", "a vertex may be repeated", false, true, repeated_vertex},
      {"flat-vertex", "the exact middle of an edge may be a vertex", false, false, flat_vertex},
      {"segment-reversal", "the direction of the segment does not matter", false, true, reversed_segment},
      {"signed-axes", "the 48 signed axis permutations change nothing", false, true, signed_axes},
      {"powers-of-two", "a power of two on each axis changes nothing", false, true, powers_of_two},
  };
  return table;
}

std::vector<PolygonRelationCount> check_relations(const PolygonFuzzPlan& plan) {
  return count_relations(
      plan, all_polygon_relations().size(),
      [&](std::uint64_t g, std::vector<PolygonRelationCount>& counts) { run_case(plan, g, counts); });
}

}  // namespace tribunal
