// Bugs of rays with bounds on t; segments, and rays without bounds, are answered right.
#include <cmath>
#include <limits>

#include "core/format.h"
#include "core/segura_feito.h"
#include "exact/filtered/rounded_parameter.h"
#include "exact/methods/cgal_kernels.h"
#include "tests/planted/bugs.h"

namespace tribunal::planted {
namespace {

using Within = Answer (*)(const Ray&, const Bounds&, const Triangle&);

constexpr double infinity = std::numeric_limits<double>::infinity();

Answer right_within(const Ray& r, const Bounds& b, const Triangle& t) { return segura_feito(r, b, t, EpickKernel{}); }

/// < where ≤ is meant.
Answer open_at_tmin(const Ray& r, const Bounds& b, const Triangle& t) {
  const Answer answer = right_within(r, b, t);
  return answer.at == At::source ? miss() : answer;
}

Answer open_at_tmax(const Ray& r, const Bounds& b, const Triangle& t) {
  const Answer answer = right_within(r, b, t);
  return answer.at == At::target ? miss() : answer;
}

Answer without_tmin(const Ray& r, const Bounds& b, const Triangle& t) { return right_within(r, {0, b.tmax}, t); }

Answer without_tmax(const Ray& r, const Bounds& b, const Triangle& t) { return right_within(r, {b.tmin, infinity}, t); }

/// The bounds go through a variable of type float; where it cannot hold them, they are left alone.
Answer clipped_in_float(const Ray& r, const Bounds& b, const Triangle& t) {
  const Bounds rounded{to_binary32(b.tmin), to_binary32(b.tmax)};
  return std::isfinite(rounded.tmin) ? right_within(r, rounded, t) : right_within(r, b, t);
}

/// The nearest double to t is compared with the bounds.
Answer by_rounded_t(const Ray& r, const Bounds& b, const Triangle& t) {
  const Answer whole = right_of_ray(r, t);
  if (!whole.hit || whole.contact == Contact::coplanar) return right_within(r, b, t);
  const double at = rounded_parameter(r, t);
  if (!(at >= b.tmin && at <= b.tmax)) return miss();
  return whole;
}

/// The point o + tmin·d is formed, and rounds.
Answer from_a_rounded_point(const Ray& r, const Bounds& b, const Triangle& t) {
  const Point3 start = r.o + b.tmin * r.d.v;
  const double length = b.tmax - b.tmin;
  if (!is_finite(start) || std::isnan(length)) return right_within(r, b, t);
  return right_within(Ray{start, r.d}, {0, length}, t);
}

Answer unbounded_in_plane(const Ray& r, const Bounds& b, const Triangle& t) {
  const Answer whole = right_of_ray(r, t);
  return whole.contact == Contact::coplanar ? whole : right_within(r, b, t);
}

Answer point_missed(const Ray& r, const Bounds& b, const Triangle& t) {
  return b.tmin == b.tmax ? miss() : right_within(r, b, t);
}

Method bounds_method(const char* name, const char* what, Within decide) {
  Method m = ray_method(name, what, right_of_ray);
  m.contract.probes.bounds = true;
  m.within = decide;
  return m;
}

}  // namespace

std::vector<Method> bounds_bugs() {
  return {
      bounds_method("planted-tmin-open", "t > tmin for t >= tmin", open_at_tmin),
      bounds_method("planted-tmax-open", "t < tmax for t <= tmax", open_at_tmax),
      bounds_method("planted-tmin-forgotten", "tmin is not looked at", without_tmin),
      bounds_method("planted-tmax-forgotten", "tmax is not looked at", without_tmax),
      bounds_method("planted-bounds-in-float", "the bounds are rounded to binary32", clipped_in_float),
      bounds_method("planted-bounds-rounded-t", "the bounds are compared with t as it rounds", by_rounded_t),
      bounds_method("planted-bounds-moved", "the ray starts at o + tmin d as that rounds", from_a_rounded_point),
      bounds_method("planted-bounds-in-plane", "a ray in the plane has no bounds", unbounded_in_plane),
      bounds_method("planted-bounds-point", "tmin = tmax is a miss", point_missed),
  };
}

Method sound_bounds() { return bounds_method("sound-bounds", "rays with bounds, by EPICK", right_within); }

}  // namespace tribunal::planted
