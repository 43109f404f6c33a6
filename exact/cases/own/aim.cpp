#include "exact/cases/own/aim.h"

#include <cmath>

#include "exact/cases/families/shapes.h"
#include "exact/cases/families/ulp.h"

namespace tribunal {
namespace {

double largest_of(const Point3& p) { return std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)}); }

/// v without its size, which lies in [1, 2) on its largest axis after; zero stays zero.
Point3 unscaled(const Point3& v) {
  const double largest = largest_of(v);
  if (largest == 0) return v;
  const int e = std::ilogb(largest);
  return {times_power_of_two(v.x, -e), times_power_of_two(v.y, -e), times_power_of_two(v.z, -e)};
}

/// v of length 1, as it rounds: most programs hand over such directions.
Point3 normalised(const Point3& v) {
  const Point3 u = unscaled(v);
  const double length = std::sqrt(u.x * u.x + u.y * u.y + u.z * u.z);
  return length > 0 ? u / length : u;
}

/// q − p, halved where that is beyond the largest number.
Point3 direction_from(const Point3& p, const Point3& q) {
  const Point3 d = q - p;
  return is_finite(d) ? d : q / 2.0 - p / 2.0;
}

/// As it is, or of length 1, or with a size of its own.
Direction draw_size(const Point3& d, Draw& draw) {
  switch (draw.below(4)) {
    case 0:
      return {normalised(d)};
    case 1: {
      const auto e = static_cast<int>(draw.between(-40, 40));
      return {{times_power_of_two(d.x, e), times_power_of_two(d.y, e), times_power_of_two(d.z, e)}};
    }
    default:
      return {d};
  }
}

Probe draw_kind(bool is_ray, const Segment& s, Draw& draw) {
  if (!is_ray) return s;
  return Ray{s.p, draw_size(direction_from(s.p, s.q), draw)};
}

/// A point between two, mostly the middle.
Point3 draw_between(const Point3& a, const Point3& b, Draw& draw) {
  const auto bits = static_cast<int>(1 + draw.below(1 + draw.below(8)));
  const std::int64_t parts = std::int64_t{1} << bits;
  const double part = static_cast<double>(draw.between(1, parts - 1)) / static_cast<double>(parts);
  return a + part * (b - a);
}

Point3 draw_in_face(const Parts& parts, Format format, Draw& draw) {
  const std::size_t n = parts.vertices().size(), second = draw.below(n), third = draw.below(n);
  return draw_in_plane(draw, format, {parts.vertex(0), parts.vertex(second), parts.vertex(third)});
}

Segment draw_along_edge(const Parts& parts, Draw& draw) {
  const auto [i, j] = parts.edges()[draw.below(parts.edges().size())];
  const Point3 a = parts.vertex(i), b = parts.vertex(j);
  return draw.below(2) == 0 ? Segment{a + (a - b), b + (b - a)} : Segment{a, b};
}

/// From a point, in one of the ways in which a probe meets another.
Segment draw_way(const Point3& from, const Point3& to, Draw& draw) {
  switch (draw.below(6)) {
    case 0:
      return {from, to};
    case 1:
      return {to, from};
    case 2:
      return {from, to + times_power_of_two(1, static_cast<int>(draw.between(-8, 8))) * (to - from)};
    default:
      return {from, to + (to - from)};
  }
}

void move_beside(Probe& probe, Format format, Draw& draw) {
  Point3& v = *vectors_of(probe)[draw.below(2)];
  const auto axis = static_cast<int>(draw.below(3));
  const std::int64_t n = draw.between(1, 4);
  v[axis] = moved_by_ulps(in_format(v[axis], format), draw.below(2) == 0 ? n : -n, format);
}

}  // namespace

Point3 draw_feature(const Parts& parts, Format format, Draw& draw) {
  switch (draw.below(5)) {
    case 0:
    case 1:
      return parts.vertex(draw.below(parts.vertices().size()));
    case 2:
    case 3: {
      const auto [i, j] = parts.edges()[draw.below(parts.edges().size())];
      return draw_between(parts.vertex(i), parts.vertex(j), draw);
    }
    default:
      return draw_in_face(parts, format, draw);
  }
}

Point3 draw_from(const Parts& other, double extent, Format format, Draw& draw) {
  if (draw.below(2) == 0) return other.vertex(draw.below(other.vertices().size()));
  const double size = times_power_of_two(extent, static_cast<int>(draw.between(-2, 2)));
  return draw_point(draw, format) * size;
}

Probe draw_aimed(bool is_ray, const Parts& parts, const Point3& from, Format format, Draw& draw) {
  const bool along = draw.below(8) == 0;
  const Segment way = along ? draw_along_edge(parts, draw) : draw_way(from, draw_feature(parts, format, draw), draw);
  Probe probe = draw_kind(is_ray, way, draw);
  if (draw.below(2) == 0) move_beside(probe, format, draw);
  return probe;
}

Probe draw_shifted(const Parts& parts, const Probe& probe, Format format, Draw& draw) {
  const Point3 to = draw_feature(parts, format, draw);
  if (const auto* s = std::get_if<Segment>(&probe)) {
    const Point3 by = to - draw_between(s->p, s->q, draw);
    return Segment{s->p + by, s->q + by};
  }
  const Ray& ray = std::get<Ray>(probe);
  const auto e = static_cast<int>(draw.between(-4, 4));
  return Ray{to - times_power_of_two(1, e) * ray.d.v, ray.d};
}

}  // namespace tribunal
