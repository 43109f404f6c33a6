#include "exact/trial/outcome.h"

#include <cmath>

#include "exact/cases/families/everyday.h"
#include "exact/trial/coverage.h"
#include "exact/trial/judge.h"

namespace tribunal {
namespace {

// --- general position -----------------------------------------------------------------------------------------------

constexpr double least_share = 0x1p-20;

/// A determinant, and the sum of its absolute products.
struct Volume {
  double value, size;
};

Volume volume_with_size(const Vec3<double>& u, const Vec3<double>& v, const Vec3<double>& w) {
  const double x = std::fabs(v.y * w.z) + std::fabs(v.z * w.y);
  const double y = std::fabs(v.z * w.x) + std::fabs(v.x * w.z);
  const double z = std::fabs(v.x * w.y) + std::fabs(v.y * w.x);
  const double size = std::fabs(u.x) * x + std::fabs(u.y) * y + std::fabs(u.z) * z;
  return {det3(u, v, w), size};
}

/// The determinant is at least this share of the sum.
bool is_clear(const Vec3<double>& u, const Vec3<double>& v, const Vec3<double>& w) {
  const Volume volume = volume_with_size(u, v, w);
  return std::fabs(volume.value) > least_share * volume.size;
}

/// The volume a b c x is far from zero.
template <class X>
bool is_clear(const Point3& a, const Point3& b, const Point3& c, const X& x) {
  const Vec3<double> o = lift<double>(a);
  return is_clear(arm(o, b), arm(o, c), arm(o, x));
}

/// The point o + t·d is far from the plane, also against what cancels: its volume is V(o) + t·V(d).
bool is_clear(const Triangle& t, const RayPoint& x) {
  const Vec3<double> o = lift<double>(t.a), u = arm(o, t.b), v = arm(o, t.c);
  const Volume from = volume_with_size(u, v, arm(o, x.ray.o)), along = volume_with_size(u, v, arm(o, x.ray.d));
  return std::fabs(from.value + x.t * along.value) > least_share * (from.size + x.t * along.size);
}

/// The bounds are far from the parameter at which the ray crosses the plane.
bool are_clear(const Bounds& bounds, const Ray& r, const Triangle& t) {
  return is_clear(t, {r, bounds.tmin}) && (std::isinf(bounds.tmax) || is_clear(t, {r, bounds.tmax}));
}

bool has_clear_bounds(const Query& query) {
  return !query.bounds || are_clear(*query.bounds, std::get<Ray>(query.probe), query.triangle());
}

template <class P>
bool passes_clear(const P& probe, const Point3& a, const Point3& b) {
  return is_clear(source(probe), a, b, target(probe));
}

template <class P>
bool is_general(const P& probe, const Triangle& t) {
  return is_clear(t.a, t.b, t.c, source(probe)) && is_clear(t.a, t.b, t.c, target(probe)) &&
         passes_clear(probe, t.a, t.b) && passes_clear(probe, t.b, t.c) && passes_clear(probe, t.c, t.a);
}

template <class Visit>
bool all_ring_edges(const PolygonData& polygon, const Visit& holds) {
  std::size_t begin = 0;
  for (const std::size_t end : polygon.ends) {
    for (std::size_t i = begin; i < end; ++i) {
      if (!holds(polygon.vertices[i], polygon.vertices[i + 1 == end ? begin : i + 1])) return false;
    }
    begin = end;
  }
  return true;
}

/// Newell's normal of all rings, as seen from the first vertex.
Vec3<double> normal_of(const PolygonData& polygon) {
  const Vec3<double> o = lift<double>(polygon.vertices[0]);
  Vec3<double> n{0, 0, 0};
  all_ring_edges(polygon, [&](const Point3& a, const Point3& b) {
    const Vec3<double> u = arm(o, a), v = arm(o, b);
    n = {n.x + u.y * v.z - u.z * v.y, n.y + u.z * v.x - u.x * v.z, n.z + u.x * v.y - u.y * v.x};
    return true;
  });
  return n;
}

/// The end of a probe is far from the plane through o with normal n.
template <class X>
bool is_off_plane(const Vec3<double>& n, const Point3& o, const X& x) {
  const Vec3<double> w = arm(lift<double>(o), x);
  const double size = std::fabs(n.x * w.x) + std::fabs(n.y * w.y) + std::fabs(n.z * w.z);
  return std::fabs(n.x * w.x + n.y * w.y + n.z * w.z) > least_share * size;
}

template <class P>
bool is_general(const P& probe, const PolygonData& polygon) {
  if (polygon.vertices.empty()) return false;
  const Vec3<double> n = normal_of(polygon);
  return is_off_plane(n, polygon.vertices[0], source(probe)) && is_off_plane(n, polygon.vertices[0], target(probe)) &&
         all_ring_edges(polygon, [&](const Point3& a, const Point3& b) { return passes_clear(probe, a, b); });
}

/// What is known exactly: no sign vanishes, or no ring edge is met and the polygon is planar.
bool is_exactly_generic(const Truth& truth) {
  if (truth.operands() == Operands::triangles) return is_generic(truth.class_id);
  return truth.planar && !truth.boundary && truth.contact != Contact::coplanar;
}

const char* words_of(Outcome o) {
  constexpr const char* words[] = {"is right",
                                   "reports a hit where a miss is due",
                                   "misses a hit that is due",
                                   "is right about the hit and tells a wrong contact",
                                   "did something else than answer",
                                   "declined, although its contract takes the case",
                                   "owes no answer"};
  return words[static_cast<int>(o)];
}

const char* words_of(Severity s) {
  constexpr const char* words[] = {"in plain general position", "degenerate or nearly, at everyday scale",
                                   "at an extreme scale"};
  return words[static_cast<int>(s)];
}

const char* words_of(Cause c) {
  constexpr const char* words[] = {"logic: it is wrong without rounding too", "rounding: without it, it is right",
                                   "cause unknown: there is no exact twin to ask"};
  return words[static_cast<int>(c)];
}

}  // namespace

Severity severity_of(const Query& query, const Truth& truth) {
  if (!is_everyday(query)) return Severity::extreme;
  const auto general = [](const auto& probe, const auto& target) { return is_general(probe, target); };
  return is_exactly_generic(truth) && has_clear_bounds(query) && std::visit(general, query.probe, query.target)
             ? Severity::plain
             : Severity::boundary;
}

Cause cause_of(const Method& method, const Query& query, const Truth& truth, Outcome outcome) {
  if (!method.exact_twin || outcome == Outcome::fault) return Cause::unknown;
  return is_wrong(judge(method, truth, method.exact_twin(query))) ? Cause::logic : Cause::rounding;
}

std::string in_words(Outcome outcome, Severity severity, Cause cause) {
  const std::string text = std::string(words_of(outcome)) + ", " + words_of(severity);
  return outcome == Outcome::fault ? text : text + "; " + words_of(cause);
}

}  // namespace tribunal
