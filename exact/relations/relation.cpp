#include "exact/relations/relation.h"

#include <array>
#include <cmath>

#include "exact/families/shapes.h"
#include "exact/harness/parallel.h"
#include "exact/harness/progress.h"
#include "exact/kernels/dyadic.h"

namespace tribunal {
namespace {

using Changed = std::optional<Query>;

/// The query with every point sent through f; nothing if a coordinate does not survive.
template <class F>
Changed with_points(const Query& query, Format format, const F& f) {
  const Segment& s = std::get<Segment>(query.probe);
  const Triangle& t = query.triangle;
  const Segment moved{f(s.p), f(s.q)};
  const Triangle placed{f(t.a), f(t.b), f(t.c)};
  for (const Point3& p : {moved.p, moved.q, placed.a, placed.b, placed.c}) {
    if (!is_finite(p) || !is_exact_in(p, format)) return {};
  }
  return Query{moved, placed};
}

bool is_exact_sum(double x, double y) {
  return std::isfinite(x + y) && sign_of(Dyadic(x) + Dyadic(y) - Dyadic(x + y)) == Sign::zero;
}

constexpr double lost = std::numeric_limits<double>::infinity();  // not finite, so with_points gives up

double exact_sum(double x, double y) { return is_exact_sum(x, y) ? x + y : lost; }

double exact_scale(double x, int e) {
  const double y = std::ldexp(x, e);
  return std::isfinite(y) && std::ldexp(y, -e) == x ? y : lost;
}

Changed vertex_order(const Query& query, Format, Draw& draw) {
  constexpr int orders[5][3] = {{0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
  const Triangle& t = query.triangle;
  const std::array<Point3, 3> v{t.a, t.b, t.c};
  const auto& order = orders[draw.below(5)];
  const auto at = [&](int i) { return v[static_cast<std::size_t>(order[i])]; };
  return Query{query.probe, {at(0), at(1), at(2)}};
}

Changed reversal(const Query& query, Format, Draw&) {
  const Segment& s = std::get<Segment>(query.probe);
  return Query{Segment{s.q, s.p}, query.triangle};
}

Changed axis_map(const Query& query, Format format, Draw& draw) {
  const std::uint64_t first = draw.below(3), turn = draw.below(2), negatives = draw.below(8);
  const int axis[3] = {static_cast<int>(first), static_cast<int>((first + 1 + turn) % 3),
                       static_cast<int>((first + 2 - turn) % 3)};
  return with_points(query, format, [&](const Point3& p) {
    Point3 r;
    for (int i = 0; i < 3; ++i) r[i] = (negatives >> i & 1U) != 0 ? -p[axis[i]] : p[axis[i]];
    return r;
  });
}

Changed uniform_scale(const Query& query, Format format, Draw& draw) {
  const int e = static_cast<int>(draw.between(-40, 40));
  return with_points(query, format, [&](const Point3& p) {
    return Point3(exact_scale(p.x, e), exact_scale(p.y, e), exact_scale(p.z, e));
  });
}

Changed axis_scale(const Query& query, Format format, Draw& draw) {
  int e[3];
  for (int& x : e) x = static_cast<int>(draw.between(-20, 20));
  return with_points(query, format, [&](const Point3& p) {
    return Point3(exact_scale(p.x, e[0]), exact_scale(p.y, e[1]), exact_scale(p.z, e[2]));
  });
}

Changed translation(const Query& query, Format format, Draw& draw) {
  const Point3 by = draw.below(2) == 0 ? -query.triangle.a : draw_lattice_point(draw, 20, 1);
  return with_points(query, format, [&](const Point3& p) {
    return Point3(exact_sum(p.x, by.x), exact_sum(p.y, by.y), exact_sum(p.z, by.z));
  });
}

Changed shear(const Query& query, Format format, Draw& draw) {
  const std::uint64_t first = draw.below(3);
  const int to = static_cast<int>(first), from = static_cast<int>((first + 1 + draw.below(2)) % 3);
  const double sign = draw.below(2) == 0 ? 1 : -1;
  return with_points(query, format, [&](Point3 p) {
    p[to] = exact_sum(p[to], sign * p[from]);
    return p;
  });
}

Changed zero_signs(const Query& query, Format format, Draw& draw) {
  bool any = false;
  const Changed changed = with_points(query, format, [&](Point3 p) {
    for (int i = 0; i < 3; ++i) {
      if (p[i] != 0) continue;
      any = true;
      p[i] = draw.below(2) == 0 ? 0.0 : -0.0;
    }
    return p;
  });
  return any ? changed : Changed{};
}

/// Segment against (a, b, b) is segment (a, b) against (p, q, q).
Changed exchange(const Query& query, Format, Draw&) {
  const Segment& s = std::get<Segment>(query.probe);
  const Triangle& t = query.triangle;
  if (t.b != t.c) return {};
  return Query{Segment{t.a, t.b}, {s.p, s.q, s.q}};
}

/// q + (q − p) is beyond q; exact or not at all.
Changed longer_segment(const Query& query, Format format, Draw&) {
  const Segment& s = std::get<Segment>(query.probe);
  Point3 r;
  for (int i = 0; i < 3; ++i) r[i] = exact_sum(s.q[i], exact_sum(s.q[i], -s.p[i]));
  if (!is_finite(r) || !is_exact_in(r, format)) return {};
  return Query{Segment{s.p, r}, query.triangle};
}

Changed larger_triangle(const Query& query, Format format, Draw&) {
  Triangle t = query.triangle;
  for (int i = 0; i < 3; ++i) t.b[i] = exact_sum(t.b[i], exact_sum(t.b[i], -t.a[i]));
  if (!is_finite(t.b) || !is_exact_in(t.b, format)) return {};
  return Query{query.probe, t};
}

constexpr Relation relations[] = {
    {"vertex-order", "the order of the vertices does not matter", Promise::same, vertex_order},
    {"reversal", "the direction of the segment does not matter", Promise::same, reversal},
    {"axis-map", "the 48 signed axis permutations change nothing", Promise::same, axis_map},
    {"scale", "a power of two on all axes changes nothing", Promise::same, uniform_scale},
    {"axis-scale", "a power of two on each axis changes nothing", Promise::same, axis_scale},
    {"translation", "an exact translation changes nothing", Promise::same, translation},
    {"shear", "an exact integer shear changes nothing", Promise::same, shear},
    {"zero-signs", "+0 and -0 are the same number", Promise::same, zero_signs},
    {"exchange", "segment (p,q) against (a,b,b) is segment (a,b) against (p,q,q)", Promise::same, exchange},
    {"longer", "a longer segment keeps a hit", Promise::keeps_hit, longer_segment},
    {"larger", "a larger triangle keeps a hit", Promise::keeps_hit, larger_triangle},
};

bool holds(Promise promise, bool before, bool after) {
  return promise == Promise::same ? before == after : !before || after;
}

struct Witness {
  std::uint64_t g = ~std::uint64_t{0};
  std::pair<Query, Query> queries{};
};

struct Entry {
  std::uint64_t asked = 0, broken = 0;
  Witness first{};
};

void ask(const Method& method, const Relation& relation, const Query& before, const Query& after, std::uint64_t g,
         Entry& entry) {
  const Answer one = method.ask(before), other = method.ask(after);
  if (one.status != Status::ok || other.status != Status::ok) return;
  ++entry.asked;
  if (holds(relation.promise, one.hit, other.hit)) return;
  ++entry.broken;
  if (g < entry.first.g) entry.first = {g, {before, after}};
}

/// The draw of a relation is a function of the case and the relation, so every method sees the same pair.
void run_case(const FuzzPlan& plan, std::uint64_t g, std::vector<Entry>& entries) {
  const Stream& stream = plan.streams[g % plan.streams.size()];
  const Trial trial = stream.family->make(stream.format, plan.seed, g / plan.streams.size());
  for (std::size_t r = 0; r < std::size(relations); ++r) {
    Draw draw(static_cast<std::uint32_t>(1000 + r), plan.seed, g);
    const Changed changed = relations[r].transform(trial.query, stream.format, draw);
    if (!changed) continue;
    for (std::size_t m = 0; m < plan.methods.size(); ++m) {
      if (!takes(plan.methods[m], stream.format)) continue;
      ask(plan.methods[m], relations[r], trial.query, *changed, g, entries[m * std::size(relations) + r]);
    }
  }
}

void merge(Entry& into, const Entry& from) {
  into.asked += from.asked;
  into.broken += from.broken;
  if (from.first.g < into.first.g) into.first = from.first;
}

}  // namespace

std::span<const Relation> all_relations() { return relations; }

std::vector<RelationCount> check_relations(const FuzzPlan& plan) {
  constexpr std::uint64_t block_size = 512;
  const std::size_t entries = plan.methods.size() * std::size(relations);
  std::vector<std::vector<Entry>> workers(plan.threads, std::vector<Entry>(entries));
  Progress progress("relations", "cases", plan.cases);
  run_blocks((plan.cases + block_size - 1) / block_size, plan.threads, [&](std::size_t block, unsigned w) {
    const std::uint64_t end = std::min(plan.cases, (block + 1) * block_size);
    for (std::uint64_t g = block * block_size; g < end; ++g) run_case(plan, g, workers[w]);
    progress.add(end - block * block_size);
  });
  std::vector<RelationCount> counts;
  for (std::size_t i = 0; i < entries; ++i) {
    Entry total;
    for (const auto& worker : workers) merge(total, worker[i]);
    RelationCount c{i / std::size(relations), i % std::size(relations), total.asked, total.broken};
    if (total.broken > 0) c.witness = total.first.queries;
    counts.push_back(c);
  }
  return counts;
}

}  // namespace tribunal
