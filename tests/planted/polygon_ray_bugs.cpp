// Bugs of rays against polygons, and of probes that are points; segments of some length are answered right.
#include <cmath>

#include "exact/kernels/dyadic.h"
#include "tests/planted/polygon_bugs.h"

namespace tribunal::planted {
namespace {

/// Answers rays by `decide` and segments rightly.
template <Answer (*decide)(const Ray&, const Polygon&)>
Answer of_ray(const Probe& probe, const Polygon& polygon) {
  const auto* r = std::get_if<Ray>(&probe);
  return r == nullptr ? right(probe, polygon) : decide(*r, polygon);
}

Answer missed(Answer answer) {
  answer.hit = false;
  return answer;
}

Answer as_line(const Ray& r, const Polygon& polygon) {
  const Answer forward = right(r, polygon);
  return forward.hit ? forward : right(Ray{r.o, {-r.d.v}}, polygon);
}

Answer as_segment(const Ray& r, const Polygon& polygon) {
  const Point3 end = r.o + r.d.v;
  return is_finite(end) ? right(Segment{r.o, end}, polygon) : right(r, polygon);
}

/// Recomputes the direction from o and the rounded o + d, as a program does that stores a ray by two points.
Answer through_a_rounded_point(const Ray& r, const Polygon& polygon) {
  const Point3 d = (r.o + r.d.v) - r.o;
  return is_finite(d) ? right(Ray{r.o, {d}}, polygon) : right(r, polygon);
}

Answer normalised(const Ray& r, const Polygon& polygon) {
  const double length = std::hypot(r.d.v.x, r.d.v.y, r.d.v.z);
  const Point3 d = r.d.v / length;
  return is_finite(d) ? right(Ray{r.o, {d}}, polygon) : right(r, polygon);
}

Answer tiny_directions_flushed(const Ray& r, const Polygon& polygon) {
  const double size = std::fabs(r.d.v.x) + std::fabs(r.d.v.y) + std::fabs(r.d.v.z);
  return size > 0x1p-100 ? right(r, polygon) : right(Ray{r.o, {Point3(0)}}, polygon);
}

Answer cut_off_far_out(const Ray& r, const Polygon& polygon) {
  const Answer answer = right(r, polygon);
  const Covering c = cover(polygon, EpickKernel{});
  if (!c.plane) return answer;
  const auto magnitude = [](const Dyadic& x) { return sign_of(x) == Sign::negative ? -x : x; };
  const HitParameter<Dyadic> at = hit_parameter<Dyadic>(r, c.plane->triangle);
  const Dyadic beyond = magnitude(at.num) - Dyadic(1e30) * magnitude(at.den);
  return sign_of(at.den) != Sign::zero && sign_of(beyond) == Sign::positive ? missed(answer) : answer;
}

Answer zero_direction_missed(const Ray& r, const Polygon& polygon) {
  const Answer answer = right(r, polygon);
  return r.d.v == Point3(0) ? missed(answer) : answer;
}

Answer origin_excluded(const Ray& r, const Polygon& polygon) {
  const Answer answer = right(r, polygon);
  return r.d.v != Point3(0) && answer.at == At::source ? missed(answer) : answer;
}

Answer point_missed(const Probe& probe, const Polygon& polygon) {
  const Answer answer = right(probe, polygon);
  const auto* s = std::get_if<Segment>(&probe);
  return s != nullptr && s->p == s->q ? missed(answer) : answer;
}

}  // namespace

std::vector<Method> polygon_ray_bugs() {
  return {
      polygon_method("planted-polygon-ray-line", "the ray is taken for its line", of_ray<as_line>),
      polygon_method("planted-polygon-ray-end", "the ray is taken for the segment from o to o + d", of_ray<as_segment>),
      polygon_method("planted-polygon-rounded", "o + d is formed by rounding", of_ray<through_a_rounded_point>),
      polygon_method("planted-polygon-normal", "the direction is normalised", of_ray<normalised>),
      polygon_method("planted-polygon-directions", "directions shorter than 2^-100 are flushed to zero",
                     of_ray<tiny_directions_flushed>),
      polygon_method("planted-polygon-t-limit", "hits beyond t = 1e30 are cut off", of_ray<cut_off_far_out>),
      polygon_method("planted-polygon-nowhere", "d = 0 is a miss", of_ray<zero_direction_missed>),
      polygon_method("planted-polygon-origin", "an origin on the polygon is no hit", of_ray<origin_excluded>),
      polygon_method("planted-polygon-point", "a segment that is a point is a miss", point_missed),
  };
}

}  // namespace tribunal::planted
