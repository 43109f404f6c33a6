// Relations among several queries: exact subdivision, degenerate operands, and answers checked by evidence.
#include <algorithm>
#include <cmath>

#include "exact/cases/families/bounds.h"
#include "exact/relations/evidence.h"
#include "exact/relations/rows.h"
#include "exact/trial/observe.h"

namespace tribunal {
namespace {

/// Whether some query is a hit; nothing if the method refuses one of them.
std::optional<bool> any_hit(const Method& method, const std::vector<Query>& queries, std::size_t first,
                            std::size_t last) {
  bool any = false;
  for (std::size_t i = first; i < last; ++i) {
    const Answer answer = ask_or_fail(method, queries[i]);
    if (answer.status != Status::ok) return {};
    any |= answer.hit;
  }
  return any;
}

/// Whether the contract takes all of the queries, which are of triangles.
bool takes_all(const Contract& c, const std::vector<Query>& queries) {
  return c.triangles == Triangles::any || std::ranges::none_of(queries, is_degenerate);
}

/// Says nothing about methods whose answers depend on more than the two point sets, or which do not take a query.
template <class Holds>
Instance between(std::vector<Query> one, const std::vector<Query>& other, const Holds& holds) {
  const std::size_t middle = one.size();
  one.insert(one.end(), other.begin(), other.end());
  const auto ask = [queries = one, middle, holds](const Method& method) -> std::optional<bool> {
    if (!reads_point_sets(method.contract) || !takes_all(method.contract, queries)) return {};
    const auto before = any_hit(method, queries, 0, middle), after = any_hit(method, queries, middle, queries.size());
    if (!before || !after) return {};
    return holds(*before, *after);
  };
  return {std::move(one), ask};
}

/// The segments from p to m and from m to q cover the segment; so do [o, o + d] and the ray from o + d the ray.
std::vector<Probe> halves(const Segment& s, Format format) {
  const Point3 m = exact_midpoint(s.p, s.q);
  if (!fits(m, format)) return {};
  return {Segment{s.p, m}, Segment{m, s.q}};
}

std::vector<Probe> halves(const Ray& r, Format format) {
  const Point3 m = exact_sum(r.o, r.d.v);
  if (!fits(m, format)) return {};
  return {Segment{r.o, m}, Ray{m, r.d}};
}

/// The triangle with its vertices rotated, so that any edge can be `bc`.
Triangle turned(const Triangle& t, std::uint64_t by) {
  if (by == 1) return {t.b, t.c, t.a};
  if (by == 2) return {t.c, t.a, t.b};
  return t;
}

/// Whether what the answer says about the contact, if anything, is true of the common point x.
bool agrees(const Answer& answer, const CommonPoint& x) {
  const bool contact = answer.contact == Contact::unsaid || answer.contact == x.contact;
  return contact && (answer.at == At::unsaid || x.at == At::unsaid || answer.at == x.at);
}

/// Whether the bounds leave one point of the ray, whose contact is the ray's, not the point's.
bool is_point_of_ray(const Query& query) { return query.bounds && query.bounds->tmin == query.bounds->tmax; }

/// What the method owes to a query whose operands have this point in common. In a plane the boundary may be met.
Due owed_to(const Method& method, const Query& query, const CommonPoint& x) {
  return due(method.contract, {.of_ray = is_of_ray(query),
                               .bounded = query.bounds.has_value(),
                               .degenerate = x.degenerate,
                               .contact = x.contact,
                               .boundary = x.contact != Contact::interior,
                               .at = x.at,
                               .at_origin = x.at == At::source && query.bounds && query.bounds->tmin == 0,
                               .facing = x.facing});
}

std::optional<bool> is_evident(const Answer& answer, const Query& query, const std::optional<CommonPoint>& x,
                               const Method& method) {
  if (answer.status != Status::ok || !answer.hit || !takes_all(method.contract, {query})) return {};
  const Due owed = x ? owed_to(method, query, *x) : Due::miss;
  if (owed == Due::nothing) return {};
  return owed == Due::hit && agrees(answer, *x);
}

}  // namespace

Instance equal(std::vector<Query> one, const std::vector<Query>& other) {
  return between(std::move(one), other, [](bool before, bool after) { return before == after; });
}

Instance implies(std::vector<Query> one, const std::vector<Query>& other) {
  return between(std::move(one), other, [](bool before, bool after) { return !before || after; });
}

std::optional<Instance> probe_in_two(const Query& query, Format format, Draw&) {
  if (query.bounds) return {};
  const std::vector<Probe> parts = std::visit([&](const auto& probe) { return halves(probe, format); }, query.probe);
  if (parts.empty()) return {};
  return equal({query}, {{parts[0], query.triangle()}, {parts[1], query.triangle()}});
}

/// [tmin, tmax] as [tmin, m] and [m, tmax]. m is where the ray hits, rounded, or near there, if that is within.
std::optional<Instance> bounds_in_two(const Query& query, Format format, Draw& draw) {
  const auto* r = std::get_if<Ray>(&query.probe);
  if (r == nullptr) return {};
  const Bounds whole = query.bounds.value_or(Bounds{});
  const double m = draw_parameter(*r, query.triangle(), format, draw);
  if (!(m >= whole.tmin && m <= whole.tmax) || std::isinf(m)) return {};
  const Query all{query.probe, query.target, whole};
  const Query before{query.probe, query.target, Bounds{whole.tmin, m}};
  return equal({all}, {before, {query.probe, query.target, Bounds{m, whole.tmax}}});
}

std::optional<Instance> triangle_in_two(const Query& query, Format format, Draw& draw) {
  const Triangle t = turned(query.triangle(), draw.below(3));
  const Point3 m = exact_midpoint(t.b, t.c);
  if (!fits(m, format)) return {};
  const Query one{query.probe, Triangle{t.a, t.b, m}, query.bounds};
  return equal({query}, {one, {query.probe, Triangle{t.a, m, t.c}, query.bounds}});
}

std::optional<Instance> end_as_segment(const Query& query, Format, Draw& draw) {
  const auto* s = std::get_if<Segment>(&query.probe);
  if (s == nullptr) return {};
  const Point3& end = draw.below(2) == 0 ? s->p : s->q;
  return implies({{Segment{end, end}, query.triangle()}}, {query});
}

std::optional<Instance> edge_as_triangle(const Query& query, Format, Draw& draw) {
  const Triangle t = turned(query.triangle(), draw.below(3));
  return implies({{query.probe, Triangle{t.a, t.b, t.b}, query.bounds}}, {query});
}

std::optional<Instance> point_as_triangle(const Query& query, Format, Draw& draw) {
  const auto* s = std::get_if<Segment>(&query.probe);
  if (s == nullptr) return {};
  const Point3 x = turned(query.triangle(), draw.below(3)).a;
  return equal({{*s, Triangle{x, x, x}}}, {{Segment{x, x}, Triangle{s->p, s->q, s->q}}});
}

std::optional<Instance> segment_as_triangle(const Query& query, Format, Draw& draw) {
  const auto* s = std::get_if<Segment>(&query.probe);
  if (s == nullptr) return {};
  const Triangle t = turned(query.triangle(), draw.below(3));
  return equal({{*s, Triangle{t.a, t.b, t.b}}}, {{Segment{t.a, t.b}, Triangle{s->p, s->q, s->q}}});
}

std::optional<Instance> hit_has_point(const Query& query, Format, Draw&) {
  if (is_point_of_ray(query)) return {};
  const auto x = common_point(query);
  return Instance{{query},
                  [=](const Method& method) { return is_evident(ask_or_fail(method, query), query, x, method); }};
}

/// A miss has a separating plane, unless the contract makes a miss of a contact.
std::optional<Instance> miss_has_plane(const Query& query, Format, Draw&) {
  if (is_point_of_ray(query)) return {};
  const auto x = common_point(query);
  const bool apart = has_separating_plane(query);
  const auto holds = [=](const Method& method) -> std::optional<bool> {
    const Answer answer = ask_or_fail(method, query);
    if (answer.status != Status::ok || answer.hit) return {};
    if (apart) return true;
    if (x && owed_to(method, query, *x) == Due::nothing) return {};
    return x && owed_to(method, query, *x) == Due::miss;
  };
  return Instance{{query}, holds};
}

}  // namespace tribunal
