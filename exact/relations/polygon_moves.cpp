#include <algorithm>
#include <cmath>

#include "exact/kernels/dyadic.h"
#include "exact/oracles/polygon_oracles.h"
#include "exact/relations/polygon_rows.h"
#include "exact/trial/observe.h"

namespace tribunal {
namespace {

using Rings = std::vector<std::vector<Point3>>;

Rings rings_of(const Polygon& polygon) {
  Rings rings;
  for (std::size_t r = 0; r < polygon.rings(); ++r) rings.emplace_back(polygon.ring(r).begin(), polygon.ring(r).end());
  return rings;
}

Query with_rings(const Query& query, const Rings& rings) {
  PolygonData polygon;
  for (const auto& ring : rings) polygon.add(ring);
  return {query.probe, std::move(polygon)};
}

std::vector<Point3>& any_ring(Rings& rings, Draw& draw) { return rings[draw.below(rings.size())]; }

}  // namespace

Changed start_vertex(const Query& query, Format, Draw& draw) {
  Rings rings = rings_of(query.polygon());
  for (auto& ring : rings) {
    const auto by = static_cast<std::ptrdiff_t>(draw.below(ring.size()));
    std::rotate(ring.begin(), ring.begin() + by, ring.end());
  }
  return with_rings(query, rings);
}

Changed ring_direction(const Query& query, Format, Draw& draw) {
  Rings rings = rings_of(query.polygon());
  auto& ring = any_ring(rings, draw);
  std::reverse(ring.begin(), ring.end());
  return with_rings(query, rings);
}

Changed ring_order(const Query& query, Format, Draw& draw) {
  Rings rings = rings_of(query.polygon());
  if (rings.size() < 2) return std::nullopt;
  const auto by = static_cast<std::ptrdiff_t>(1 + draw.below(rings.size() - 1));
  std::rotate(rings.begin(), rings.begin() + by, rings.end());
  return with_rings(query, rings);
}

Changed repeated_vertex(const Query& query, Format, Draw& draw) {
  Rings rings = rings_of(query.polygon());
  auto& ring = any_ring(rings, draw);
  const auto at = static_cast<std::ptrdiff_t>(draw.below(ring.size()));
  const Point3 v = ring[static_cast<std::size_t>(at)];
  ring.insert(ring.begin() + at, v);
  return with_rings(query, rings);
}

namespace {

/// Whether m is exactly the midpoint of ab.
bool is_midpoint(const Point3& a, const Point3& b, const Point3& m) {
  for (int axis = 0; axis < 3; ++axis) {
    const Dyadic excess = Dyadic(a[axis]) + Dyadic(b[axis]) - Dyadic(m[axis]) - Dyadic(m[axis]);
    if (sign_of(excess) != Sign::zero) return false;
  }
  return true;
}

}  // namespace

/// The polygon with the midpoint of an edge as an additional vertex.
Changed flat_vertex(const Query& query, Format format, Draw& draw) {
  Rings rings = rings_of(query.polygon());
  auto& ring = any_ring(rings, draw);
  const std::size_t i = draw.below(ring.size());
  const Point3 a = ring[i], b = ring[(i + 1) % ring.size()];
  const Point3 middle = in_format(a / 2.0 + b / 2.0, format);
  if (!is_finite(middle) || !is_midpoint(a, b, middle)) return std::nullopt;
  ring.insert(ring.begin() + static_cast<std::ptrdiff_t>(i) + 1, middle);
  return with_rings(query, rings);
}

Changed reversed_segment(const Query& query, Format, Draw&) {
  const auto* s = std::get_if<Segment>(&query.probe);
  if (s == nullptr) return std::nullopt;
  return Query{Segment{s->q, s->p}, query.polygon()};
}

namespace {

/// Applies f to every point and direction.
template <class F>
Query moved(Query query, const F& f) {
  for (Point3& v : query.polygon().vertices) v = f(v);
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

}  // namespace

/// The query under one of the 48 signed permutations of the axes.
Changed signed_axes(const Query& query, Format, Draw& draw) {
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

/// The query with each axis multiplied by a power of two of its own, where no bit is lost.
Changed powers_of_two(const Query& query, Format format, Draw& draw) {
  int by[3];
  for (int& e : by) e = static_cast<int>(draw.between(-20, 20));
  bool exact = true;
  const Query changed = moved(query, [&](const Point3& v) {
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

namespace {

bool keeps(Kept kept, const Answer& before, const Answer& after) {
  if (before.hit != after.hit || before.planar != after.planar) return false;
  return kept == Kept::hit_and_plane || before.contact == after.contact;
}

}  // namespace

std::optional<Instance> kept_by(const Query& query, const Changed& changed, Kept kept) {
  if (!changed) return std::nullopt;
  return Instance{{query, *changed}, [query, changed = *changed, kept](const Method& method) -> std::optional<bool> {
                    const Answer before = ask_or_fail(method, query), after = ask_or_fail(method, changed);
                    if (before.status != Status::ok || after.status != Status::ok) return std::nullopt;
                    return keeps(kept, before, after);
                  }};
}

bool is_planar(const Query& query) { return is_planar_by_normal<Dyadic>(query.polygon()); }

}  // namespace tribunal
