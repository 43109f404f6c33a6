// Bugs of polygons that show only where numbers leave the middle of the range, or the probe that of the polygon.
#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/planted/polygon_bugs.h"
#include "tests/planted/range_kernels.h"

namespace tribunal::planted {
namespace {

constexpr double least_normal = std::numeric_limits<double>::min();

/// The right answer, but with the hit decided by the kernel K.
template <class K>
Answer by_kernel(const Probe& probe, const Polygon& polygon) {
  Answer answer = right(probe, polygon);
  answer.hit = answer_by(K{}, probe, polygon).hit;
  return answer;
}

/// The points of a query, which a bug may change; the direction of a ray is not among them.
struct Changed {
  Probe probe;
  PolygonData polygon{};

  Changed(const Probe& p, const Polygon& v) : probe(p) {
    for (std::size_t r = 0; r < v.rings(); ++r) polygon.add(v.ring(r));
  }

  std::vector<Point3*> points() {
    std::vector<Point3*> all;
    for (Point3& v : polygon.vertices) all.push_back(&v);
    if (auto* s = std::get_if<Segment>(&probe)) all.insert(all.end(), {&s->p, &s->q});
    if (auto* r = std::get_if<Ray>(&probe)) all.push_back(&r->o);
    return all;
  }
};

double largest_on(int axis, const std::vector<Point3*>& points) {
  double most = 0;
  for (const Point3* p : points) most = std::max(most, std::fabs((*p)[axis]));
  return most;
}

Answer subnormal_beside_normal(const Probe& probe, const Polygon& polygon) {
  Changed query(probe, polygon);
  const std::vector<Point3*> points = query.points();
  for (int axis = 0; axis < 3; ++axis) {
    if (largest_on(axis, points) < least_normal) continue;
    for (Point3* p : points) {
      if (std::fabs((*p)[axis]) < least_normal) (*p)[axis] = 0;
    }
  }
  return about(query.polygon, query.probe, polygon);
}

double truncated(double x, int bits) {
  int e = 0;
  return std::ldexp(std::trunc(std::ldexp(std::frexp(x, &e), bits)), e - bits);
}

/// Mantissas lose their last bits where the largest number on an axis is beyond these.
Answer truncated_at_extremes(const Probe& probe, const Polygon& polygon) {
  constexpr double small = 0x1p-900, large = 0x1p900;
  Changed query(probe, polygon);
  const std::vector<Point3*> points = query.points();
  for (int axis = 0; axis < 3; ++axis) {
    const double most = largest_on(axis, points);
    if (most >= small && most <= large) continue;
    for (Point3* p : points) (*p)[axis] = truncated((*p)[axis], 40);
  }
  return about(query.polygon, query.probe, polygon);
}

/// Half of the largest coordinate difference; differences of halves do not overflow.
double half_size_of(const Point3& p, const Point3& q) {
  const Point3 d = p / 2.0 - q / 2.0;
  return std::max({std::fabs(d.x), std::fabs(d.y), std::fabs(d.z)});
}

/// Misses wherever the segment is more than 2^binades times as long as the polygon is wide.
template <int binades>
Answer long_probes_lost(const Probe& probe, const Polygon& polygon) {
  Answer answer = right(probe, polygon);
  const auto* s = std::get_if<Segment>(&probe);
  if (s == nullptr) return answer;
  double size = 0;
  for (const Point3& v : polygon.vertices) size = std::max(size, half_size_of(v, polygon.vertices[0]));
  if (size > 0 && std::ldexp(half_size_of(s->p, s->q), -binades) > size) answer.hit = false;
  return answer;
}

}  // namespace

std::vector<Method> polygon_range_bugs() {
  return {
      polygon_method("planted-polygon-overflow", "differences that overflow are taken for exact: inf - inf decides",
                     by_kernel<ExactDifferences<false>>),
      polygon_method("planted-polygon-window",
                     "exact numbers of 300 bits: terms more than 300 binades apart are dropped",
                     by_kernel<FormulaKernel<Windowed<300>>>),
      polygon_method("planted-polygon-subnormal", "a subnormal beside a normal number is read as zero",
                     subnormal_beside_normal),
      polygon_method("planted-polygon-truncated", "40 bits of the mantissa beyond 2^900 and below 2^-900",
                     truncated_at_extremes),
      polygon_method("planted-long-probes", "segments 2^13 times as long as the polygon are lost",
                     long_probes_lost<13>),
      polygon_method("planted-far-probes", "segments 2^500 times as long as the polygon are lost",
                     long_probes_lost<500>),
  };
}

std::vector<Method> sound_polygon_range() {
  return {
      polygon_method("sound-polygon-differences", "exact differences, EPICK where one is not or overflows",
                     by_kernel<ExactDifferences<true>>),
      polygon_method("sound-polygon-window", "exact numbers of 40,000 bits",
                     by_kernel<FormulaKernel<Windowed<40'000>>>),
  };
}

}  // namespace tribunal::planted
