#include "exact/relations/evidence.h"

#include <array>
#include <cmath>
#include <vector>

#include "exact/kernels/dyadic.h"

namespace tribunal {
namespace {

using Vector = Vec3<Dyadic>;

Vector operator+(const Vector& u, const Vector& v) { return {u.x + v.x, u.y + v.y, u.z + v.z}; }
Vector operator*(const Dyadic& f, const Vector& v) { return {f * v.x, f * v.y, f * v.z}; }
Dyadic dot(const Vector& u, const Vector& v) { return u.x * v.x + u.y * v.y + u.z * v.z; }
Vector cross(const Vector& u, const Vector& v) {
  return {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
}

bool is_zero(const Dyadic& x) { return sign_of(x) == Sign::zero; }
bool is_zero(const Vector& v) { return is_zero(v.x) && is_zero(v.y) && is_zero(v.z); }
bool is_positive(const Dyadic& x) { return sign_of(x) == Sign::positive; }
bool at_least(const Dyadic& x, const Dyadic& y) { return sign_of(x - y) != Sign::negative; }

/// The points o + t·d, 0 ≤ t, and t ≤ 1 unless it is endless.
struct Line {
  Vector o, d;
  bool endless;
};

Line line_of(const Segment& s) { return {lift<Dyadic>(s.p), lift<Dyadic>(s.q) - lift<Dyadic>(s.p), false}; }
Line line_of(const Ray& r) { return {lift<Dyadic>(r.o), lift<Dyadic>(r.d.v), true}; }

/// The part of a ray between two exact points, or from one on.
Line line_within(const Ray& r, const Bounds& b) {
  const Line ray = line_of(r);
  const Dyadic tmin(b.tmin);
  if (std::isinf(b.tmax)) return {ray.o + tmin * ray.d, ray.d, true};
  return {ray.o + tmin * ray.d, (Dyadic(b.tmax) - tmin) * ray.d, false};
}

Line line_of(const Query& query) {
  if (query.bounds) return line_within(std::get<Ray>(query.probe), *query.bounds);
  return std::visit([](const auto& probe) { return line_of(probe); }, query.probe);
}

struct Lifted {
  Line probe;
  std::array<Vector, 3> v;

  Line edge(std::size_t i) const { return {v[i], v[(i + 1) % 3] - v[i], false}; }
  Vector normal() const { return cross(v[1] - v[0], v[2] - v[0]); }
};

Lifted lifted(const Query& query) {
  const Triangle& t = query.triangle();
  return {line_of(query), {lift<Dyadic>(t.a), lift<Dyadic>(t.b), lift<Dyadic>(t.c)}};
}

/// The point x / w, w > 0.
struct Homogeneous {
  Vector x;
  Dyadic w;
};

const Dyadic one(1.0);

/// o + (num/den)·d, den ≠ 0.
Homogeneous along(const Line& line, const Dyadic& num, const Dyadic& den) {
  if (!is_positive(den)) return along(line, -num, -den);
  return {den * line.o + num * line.d, den};
}

bool lies_on(const Homogeneous& h, const Line& line) {
  const Vector r = h.x - h.w * line.o;
  if (is_zero(line.d)) return is_zero(r);
  const Dyadic reach = dot(r, line.d);
  return is_zero(cross(r, line.d)) && at_least(reach, Dyadic()) &&
         (line.endless || at_least(h.w * dot(line.d, line.d), reach));
}

int edges_through(const Homogeneous& h, const Lifted& q) {
  int edges = 0;
  for (std::size_t i = 0; i < 3; ++i) edges += lies_on(h, q.edge(i));
  return edges;
}

bool lies_in_triangle(const Homogeneous& h, const Lifted& q) {
  const Vector n = q.normal();
  if (is_zero(n)) return edges_through(h, q) > 0;
  if (!is_zero(dot(n, h.x - h.w * q.v[0]))) return false;
  for (std::size_t i = 0; i < 3; ++i) {
    const Line e = q.edge(i);
    if (!at_least(dot(cross(e.d, h.x - h.w * e.o), n), Dyadic())) return false;
  }
  return true;
}

bool is_common(const Homogeneous& h, const Lifted& q) { return lies_on(h, q.probe) && lies_in_triangle(h, q); }

/// Adds the point of one line that is nearest to the other: their crossing, if they have one.
void add_crossing(const Line& line, const Line& edge, std::vector<Homogeneous>& points) {
  const Vector m = cross(line.d, edge.d);
  if (is_zero(m)) return;
  points.push_back(along(line, dot(cross(edge.o - line.o, edge.d), m), dot(m, m)));
}

/// Points of which one is common to both operands, if they lie in one plane or the triangle has no area, and if they
/// have a common point.
std::vector<Homogeneous> candidates(const Lifted& q) {
  std::vector<Homogeneous> points{{q.probe.o, one}, {q.v[0], one}, {q.v[1], one}, {q.v[2], one}};
  if (!q.probe.endless) points.push_back({q.probe.o + q.probe.d, one});
  for (std::size_t i = 0; i < 3; ++i) add_crossing(q.probe, q.edge(i), points);
  return points;
}

CommonPoint described(const Homogeneous& h, const Lifted& q) {
  constexpr Contact contacts[] = {Contact::interior, Contact::edge, Contact::vertex, Contact::vertex};
  const Vector from_source = h.x - h.w * q.probe.o;
  const bool at_target = !q.probe.endless && is_zero(from_source - h.w * q.probe.d);
  return {contacts[edges_through(h, q)], is_zero(from_source) ? At::source : at_target ? At::target : At::between};
}

/// Whether n·x is larger on all of the triangle than on all of the probe.
bool lies_above(const Lifted& q, const Vector& n) {
  const Dyadic rise = dot(n, q.probe.d);
  if (q.probe.endless && is_positive(rise)) return false;
  for (const Vector& v : q.v) {
    const Dyadic height = dot(n, v - q.probe.o);
    if (!is_positive(height)) return false;
    if (!q.probe.endless && !is_positive(height - rise)) return false;
  }
  return true;
}

bool separates(const Lifted& q, const Vector& n) { return lies_above(q, n) || lies_above(q, Vector{} - n); }

}  // namespace

std::optional<CommonPoint> common_point(const Query& query) {
  const Lifted q = lifted(query);
  const Vector n = q.normal();
  const Dyadic slope = dot(n, q.probe.d);
  if (!is_zero(slope)) {
    const Homogeneous h = along(q.probe, dot(n, q.v[0] - q.probe.o), slope);
    if (!is_common(h, q)) return {};
    CommonPoint x = described(h, q);
    x.facing = is_positive(slope) ? Facing::back : Facing::front;
    return x;
  }
  for (const Homogeneous& h : candidates(q)) {
    if (is_common(h, q))
      return CommonPoint{Contact::coplanar, At::unsaid, Facing::unsaid, is_zero(n) || is_zero(q.probe.d)};
  }
  return {};
}

/// The difference D of the operands misses the origin. If D is a solid, a facet of it separates: normals of the
/// triangle or of an edge and the probe. If D is flat, its plane does, or an edge of D within it: such a normal times
/// an edge. If D lies on a line, that line's direction does, or the perpendicular from the origin to the line.
bool has_separating_plane(const Query& query) {
  const Lifted q = lifted(query);
  const std::array<Vector, 4> edges{q.edge(0).d, q.edge(1).d, q.edge(2).d, q.probe.d};
  const std::array<Vector, 4> normals{q.normal(), cross(edges[0], edges[3]), cross(edges[1], edges[3]),
                                      cross(edges[2], edges[3])};
  for (const Vector& n : normals) {
    if (separates(q, n)) return true;
  }
  const Vector between = q.v[0] - q.probe.o;
  if (separates(q, between)) return true;
  for (const Vector& e : edges) {
    if (separates(q, e) || separates(q, cross(e, cross(between, e)))) return true;
    for (const Vector& n : normals) {
      if (separates(q, cross(n, e))) return true;
    }
  }
  return false;
}

}  // namespace tribunal
