// Bugs of rays; segments are answered right.
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/segura_feito.h"
#include "exact/kernels/dyadic.h"
#include "exact/methods/cgal_kernels.h"
#include "tests/planted/bugs.h"

namespace tribunal::planted {
namespace {

Answer as_line(const Ray& r, const Triangle& t) {
  const Answer ahead = right_of_ray(r, t);
  return ahead.hit ? ahead : right_of_ray(Ray{r.o, {-r.d.v}}, t);
}

Answer as_segment(const Ray& r, const Triangle& t) {
  const Point3 end = r.o + r.d.v;
  return is_finite(end) ? right(Segment{r.o, end}, t) : right_of_ray(r, t);
}

/// Recomputes the direction from o and the rounded o + d, as a program does that stores a ray by two points.
Answer through_a_rounded_point(const Ray& r, const Triangle& t) {
  const Point3 d = (r.o + r.d.v) - r.o;
  return is_finite(d) ? right_of_ray(Ray{r.o, {d}}, t) : right_of_ray(r, t);
}

Answer normalised(const Ray& r, const Triangle& t) {
  const double length = std::hypot(r.d.v.x, r.d.v.y, r.d.v.z);
  const Point3 d = r.d.v / length;
  return is_finite(d) ? right_of_ray(Ray{r.o, {d}}, t) : right_of_ray(r, t);
}

Answer tiny_direction_flushed(const Ray& r, const Triangle& t) {
  Point3 d = r.d.v;
  for (int axis = 0; axis < 3; ++axis) d[axis] = std::fabs(d[axis]) < 1e-300 ? 0 : d[axis];
  return right_of_ray(Ray{r.o, {d}}, t);
}

Answer cut_off_far_out(const Ray& r, const Triangle& t) {
  const auto magnitude = [](const Dyadic& x) { return sign_of(x) == Sign::negative ? -x : x; };
  const HitParameter<Dyadic> at = hit_parameter<Dyadic>(r, t);
  const bool far =
      sign_of(at.den) != Sign::zero && sign_of(magnitude(at.num) - Dyadic(1e30) * magnitude(at.den)) == Sign::positive;
  return far ? miss() : right_of_ray(r, t);
}

Answer zero_direction_missed(const Ray& r, const Triangle& t) {
  return r.d.v == Point3(0) ? miss() : right_of_ray(r, t);
}

Answer origin_excluded(const Ray& r, const Triangle& t) {
  const Answer answer = right_of_ray(r, t);
  return answer.at == At::source ? miss() : answer;
}

double largest(double x, double y, double z) { return std::max({std::fabs(x), std::fabs(y), std::fabs(z)}); }

/// A filter that rejects a ray whose origin is off the plane and whose direction leads away from it. The bound holds
/// for the origin's volume; whether normal·d has the right sign where its products underflow, nobody asked, unless
/// `guarded`. What it cannot tell goes to EPICK.
template <bool guarded>
Answer rejected_by_its_source(const Ray& r, const Triangle& t) {
  constexpr double k = 170 * 0x1p-52, tiny = 0x1p-700, huge = 0x1p150;
  const Point3 u = t.b - t.a, v = t.c - t.a, w = r.o - t.a, d = r.d.v;
  const double x = largest(u.x, v.x, w.x), y = largest(u.y, v.y, w.y), z = largest(u.z, v.z, w.z);
  const Point3 normal{u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
  const double source = normal.x * w.x + normal.y * w.y + normal.z * w.z;
  const double toward = normal.x * d.x + normal.y * d.y + normal.z * d.z;
  const double bound = k * x * y * z + tiny;
  const double toward_bound = k * largest(x * y, y * z, z * x) * largest(d.x, d.y, d.z) + tiny;
  const bool in_range = largest(x, y, z) < huge && largest(d.x, d.y, d.z) < huge;
  const bool known = !guarded || std::fabs(toward) > toward_bound;
  if (in_range && known && source * std::copysign(1.0, toward) > 3 * bound) return miss();
  return right_of_ray(r, t);
}

}  // namespace

std::vector<Method> ray_bugs() {
  return {
      ray_method("planted-ray-as-line", "ray taken for a line", as_line),
      ray_method("planted-ray-as-segment", "ray taken for the segment from o to o + d", as_segment),
      ray_method("planted-ray-rounded", "o + d formed by rounding", through_a_rounded_point),
      ray_method("planted-ray-normalised", "direction normalised", normalised),
      ray_method("planted-ray-flushed", "components of the direction below 1e-300 are read as zero",
                 tiny_direction_flushed),
      ray_method("planted-ray-underflow", "the sign of normal . d is trusted where it underflows",
                 rejected_by_its_source<false>),
      ray_method("planted-ray-t-limit", "hits beyond t = 1e30 are cut off", cut_off_far_out),
      ray_method("planted-ray-nowhere", "d = 0 is a miss", zero_direction_missed),
      ray_method("planted-ray-origin", "an origin on the triangle is no hit", origin_excluded),
  };
}

Method sound_ray() {
  return ray_method("sound-ray", "rejects by the origin's side where normal . d is certain, then EPICK",
                    rejected_by_its_source<true>);
}

}  // namespace tribunal::planted
