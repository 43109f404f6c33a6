#include "exact/cases/own/mutate.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <glm/common.hpp>
#include <limits>

#include "exact/cases/families/axis_maps.h"
#include "exact/cases/families/bounds.h"
#include "exact/cases/families/probe.h"
#include "exact/cases/families/shapes.h"
#include "exact/cases/families/ulp.h"
#include "exact/cases/own/aim.h"

namespace tribunal {
namespace {

// --- by units in the last place ----------------------------------------------------------------------------------

/// A power of two, often small, up to all but the first bits of the significand.
std::int64_t draw_step(Format format, Draw& draw) {
  const std::uint64_t most = 1 + draw.below(static_cast<std::uint64_t>(digits_of(format)) - 3);
  return std::int64_t{1} << draw.below(most);
}

/// One bound becomes t, and the other gives way where it must. Nothing is changed where t cannot be a bound.
void put_bound(Bounds& bounds, double t, Draw& draw) {
  if (!(t >= 0) || !std::isfinite(t)) return;
  bounds = draw.below(2) == 0 ? Bounds{t, std::max(t, bounds.tmax)} : Bounds{std::min(t, bounds.tmin), t};
}

void move_bound(Bounds& bounds, Format format, Draw& draw) {
  const double t = draw.below(2) == 0 || !std::isfinite(bounds.tmax) ? bounds.tmin : bounds.tmax;
  const std::int64_t step = draw_step(format, draw);
  put_bound(bounds, moved_by_ulps(t, draw.below(2) == 0 ? step : -step, format), draw);
}

/// A bound is put where the ray, as it rounds, crosses the plane of the triangle.
void aim_bound(Query& query, Format format, Draw& draw) {
  const Query rounded = rounded_to(query, format);
  if (is_finite(rounded)) {
    put_bound(*query.bounds, draw_parameter(std::get<Ray>(rounded.probe), rounded.triangle(), format, draw), draw);
  }
}

void by_ulps(Query& query, const Surroundings& around, Draw& draw) {
  if (query.bounds && draw.below(4) == 0) return move_bound(*query.bounds, around.format, draw);
  const Parts parts(query);
  const std::vector<Point3*> vectors = parts.vectors();
  Point3& v = *vectors[draw.below(vectors.size())];
  const std::uint64_t only_axis = draw.below(6);
  for (int axis = 0; axis < 3; ++axis) {
    const std::int64_t step = draw_step(around.format, draw);
    const std::int64_t n = draw.below(2) == 0 ? step : -step;
    if (only_axis < 3 && only_axis != static_cast<std::uint64_t>(axis)) continue;
    v[axis] = moved_by_ulps(v[axis], n, around.format);
    if (v[axis] == 0 && draw.below(2) == 0) v[axis] = -0.0;
  }
}

// --- snapped to a grid -------------------------------------------------------------------------------------------

double largest_of(const std::vector<Point3*>& vectors) {
  double largest = 0;
  for (const Point3* v : vectors) {
    largest = std::max({largest, std::fabs(v->x), std::fabs(v->y), std::fabs(v->z)});
  }
  return largest;
}

/// To the nearest multiples of 2^e.
void to_multiples(Point3& v, int e) {
  for (int axis = 0; axis < 3; ++axis) {
    v[axis] = times_power_of_two(std::nearbyint(times_power_of_two(v[axis], -e)), e);
  }
}

/// The exponent of the last bit that is set.
int last_bit_of(double x) {
  int e = 0;
  const auto m = static_cast<std::uint64_t>(std::fabs(std::frexp(x, &e)) * 0x1p53);
  return e - 53 + std::countr_zero(m);
}

/// The exponent of the last bit that is set in any of the numbers, which are not all zero.
int last_bit_of(const std::vector<Point3*>& vectors) {
  int last = std::numeric_limits<int>::max();
  for (const Point3* v : vectors) {
    for (int axis = 0; axis < 3; ++axis) {
      if ((*v)[axis] != 0) last = std::min(last, last_bit_of((*v)[axis]));
    }
  }
  return last;
}

/// The longest side of the box around the points; the largest coordinate where that is 0.
double size_of(const std::vector<Point3*>& points) {
  Point3 lo = *points.front(), hi = lo;
  for (const Point3* p : points) lo = glm::min(lo, *p), hi = glm::max(hi, *p);
  const double longest = std::max({hi.x - lo.x, hi.y - lo.y, hi.z - lo.z});
  if (longest == 0) return largest_of(points);
  return std::min(longest, std::numeric_limits<double>::max());
}

/// To multiples of a power of two that is at most `size`, and that they are not all multiples of yet.
void to_grid(const std::vector<Point3*>& vectors, double size, Format format, Draw& draw) {
  if (size == 0 || largest_of(vectors) == 0) return;
  const int first = std::ilogb(size);
  const int most = std::clamp(first - last_bit_of(vectors), 1, digits_of(format));
  const auto bits = static_cast<int>(draw.below(static_cast<std::uint64_t>(most)));
  for (Point3* v : vectors) to_multiples(*v, first - bits);
}

/// All points, or one vector. A direction has a grid of its own.
void to_coarser_grid(Query& query, const Surroundings& around, Draw& draw) {
  const Parts parts(query);
  const std::vector<Point3*> points = parts.points();
  const double size = size_of(points);
  const bool of_ray = is_of_ray(query), all = draw.below(2) == 0;
  const std::uint64_t one = draw.below(points.size() + (of_ray ? 1 : 0));
  if (all) {
    to_grid(points, size, around.format, draw);
  } else if (one < points.size()) {
    to_grid({points[one]}, size, around.format, draw);
  }
  if (of_ray && (all || one == points.size())) {
    to_grid({&parts.target()}, largest_of({&parts.target()}), around.format, draw);
  }
}

// --- snapped onto each other -------------------------------------------------------------------------------------

void share_coordinate(const std::vector<Point3*>& points, Draw& draw) {
  const Point3& from = *points[draw.below(points.size())];
  Point3& to = *points[draw.below(points.size())];
  const auto axis = static_cast<int>(draw.below(3));
  to[axis] = from[axis];
}

/// All vertices into a plane at right angles to an axis.
void flatten(const Parts& parts, Draw& draw) {
  const double level = (parts.vertex(draw.below(parts.vertices().size())))[static_cast<int>(draw.below(3))];
  const auto axis = static_cast<int>(draw.below(3));
  for (Point3* v : parts.vertices()) (*v)[axis] = level;
}

/// One or two coordinates of the way along the probe become zero.
void straighten(Query& query, const Parts& parts, Draw& draw) {
  const auto first = static_cast<int>(draw.below(3)), second = static_cast<int>(draw.below(3));
  for (const int axis : {first, second}) parts.target()[axis] = is_of_ray(query) ? 0 : parts.source()[axis];
}

Point3& draw_end(const Query& query, const Parts& parts, Draw& draw) {
  return is_of_ray(query) || draw.below(2) == 0 ? parts.source() : parts.target();
}

void onto_each_other(Query& query, const Surroundings& around, Draw& draw) {
  if (query.bounds && draw.below(4) == 0) return aim_bound(query, around.format, draw);
  const Parts parts(query);
  const auto draw_vertex = [&]() -> Point3& { return parts.vertex(draw.below(parts.vertices().size())); };
  switch (draw.below(7)) {
    case 0:
    case 1: {
      const Point3 at = draw_feature(parts, around.format, draw);
      draw_end(query, parts, draw) = at;
      break;
    }
    case 2: {
      const Point3 at = draw_end(query, parts, draw);
      draw_vertex() = at;
      break;
    }
    case 3: {
      const Point3 at = draw_vertex();
      draw_vertex() = at;
      break;
    }
    case 4:
      flatten(parts, draw);
      break;
    case 5:
      straighten(query, parts, draw);
      break;
    default:
      share_coordinate(parts.points(), draw);
  }
}

// --- flips: the same question in another order, or mirrored -------------------------------------------------------

void reverse(Probe& probe) {
  if (auto* s = std::get_if<Segment>(&probe)) {
    std::swap(s->p, s->q);
  } else {
    std::get<Ray>(probe).d.v = -std::get<Ray>(probe).d.v;
  }
}

/// Another start, and every other time another way round, of each ring.
void reorder(PolygonData& polygon, Draw& draw) {
  auto begin = polygon.vertices.begin();
  for (const std::size_t index : polygon.ends) {
    const auto end = polygon.vertices.begin() + static_cast<std::ptrdiff_t>(index);
    const auto start = static_cast<std::ptrdiff_t>(draw.below(static_cast<std::uint64_t>(end - begin)));
    std::rotate(begin, begin + start, end);
    if (draw.below(2) == 0) std::reverse(begin, end);
    begin = end;
  }
}

void reorder(Target& target, Draw& draw) {
  if (auto* t = std::get_if<Triangle>(&target)) {
    *t = in_random_order(*t, draw);
  } else {
    reorder(std::get<PolygonData>(target), draw);
  }
}

void map_axes(const Parts& parts, Draw& draw) {
  const AxisMap& map = axis_maps()[draw.below(axis_maps().size())];
  for (Point3* v : parts.vectors()) *v = map(*v);
}

void flip(Query& query, const Surroundings&, Draw& draw) {
  const std::uint64_t ways = 1 + draw.below(15);
  if ((ways & 1) != 0) reorder(query.target, draw);
  if ((ways & 2) != 0) reverse(query.probe);
  const Parts parts(query);
  if ((ways & 4) != 0) map_axes(parts, draw);
  if ((ways & 8) != 0) {
    const std::vector<Point3*> vectors = parts.vectors();
    Point3& v = *vectors[draw.below(vectors.size())];
    const auto axis = static_cast<int>(draw.below(3));
    v[axis] = -v[axis];
  }
}

// --- aimed at the target -----------------------------------------------------------------------------------------

void aim_from_elsewhere(Query& query, const Surroundings& around, Draw& draw) {
  Query other = around.other;
  const Point3 from = draw_from(Parts(other), around.extent, around.format, draw);
  query.probe = draw_aimed(is_of_ray(query), Parts(query), from, around.format, draw);
}

void aim(Query& query, const Surroundings& around, Draw& draw) {
  const Parts parts(query);
  switch (draw.below(3)) {
    case 0:
      query.probe = draw_shifted(parts, query.probe, around.format, draw);
      break;
    case 1:
      query.probe = draw_aimed(is_of_ray(query), parts, parts.source(), around.format, draw);
      break;
    default:
      aim_from_elsewhere(query, around, draw);
  }
  if (query.bounds && draw.below(2) == 0) aim_bound(query, around.format, draw);
}

/// Bit for bit; −0 is not 0.
bool are_same(Query& a, Query& b) {
  if (a.bounds != b.bounds) return false;
  const std::vector<Point3*> u = Parts(a).vectors(), v = Parts(b).vectors();
  return std::ranges::equal(u, v, [](const Point3* x, const Point3* y) { return std::memcmp(x, y, sizeof(*x)) == 0; });
}

constexpr Mutation table[] = {{"by units in the last place", by_ulps},
                              {"to a coarser grid", to_coarser_grid},
                              {"onto each other's points and planes", onto_each_other},
                              {"flipped", flip},
                              {"aimed", aim}};

constexpr Mutation from_elsewhere = {"aimed from elsewhere", aim_from_elsewhere};

}  // namespace

std::span<const Mutation> mutations() { return table; }

const Mutation& aiming() { return from_elsewhere; }

void mutate(Query& query, const Mutation& mutation, const Surroundings& around, Draw& draw) {
  constexpr int tries = 4;
  for (int i = 0; i < tries; ++i) {
    Query changed = query;
    mutation.apply(changed, around, draw);
    changed = rounded_to(std::move(changed), around.format);
    if (!is_finite(changed) || are_same(changed, query)) continue;
    query = std::move(changed);
    return;
  }
}

Query rounded_to(Query query, Format format) {
  for (Point3* v : Parts(query).vectors()) *v = in_format(*v, format);
  if (query.bounds) query.bounds = {in_format(query.bounds->tmin, format), in_format(query.bounds->tmax, format)};
  return query;
}

}  // namespace tribunal
