#include "exact/filtered/filtered_polygon.h"

#include "exact/filtered/filtered.h"
#include "exact/filtered/filtered_kernel.h"

namespace tribunal {
namespace {

/// The axis on which the normal is shortest.
int flattest_axis(const Vec3<double>& n) {
  const double x = magnitude(n.x), y = magnitude(n.y), z = magnitude(n.z);
  return x <= y && x <= z ? 0 : y <= z ? 1 : 2;
}

}  // namespace

FilteredPolygon::FilteredPolygon(const Polygon& polygon) : covering_(cover(polygon, FilteredKernel())) {
  if (!covering_.plane) return;
  const Triangle& t = covering_.plane->triangle;
  base_ = lift<double>(t.a);
  const Vec3<double> b = arm<double>(base_, t.b), c = arm<double>(base_, t.c);
  normal_ = cross(b, c);
  reach_ = largest(b, c);
  along_ = flattest_axis(normal_);
  i_ = (along_ + 1) % 3;
  j_ = (along_ + 2) % 3;
  lowest_ = highest_ = base_;
  for (const Point3& v : polygon.vertices) {
    lowest_ = {smaller(v.x, lowest_.x), smaller(v.y, lowest_.y), smaller(v.z, lowest_.z)};
    highest_ = {larger(v.x, highest_.x), larger(v.y, highest_.y), larger(v.z, highest_.z)};
    flat_.push_back({v[i_], v[j_]});
  }
}

/// A certain hit is in general position: inside, between the ends.
template <class P>
PolygonAnswer FilteredPolygon::decide(const P& probe) const {
  if (covering_.is_triangle()) return {intersect(probe, covering_.triangle()), true};
  if (const std::optional<bool> hit = filter_hits(probe)) return {certain(*hit), true};
  Tally tally;
  PolygonAnswer answer = segura_feito(probe, covering_, FilteredKernel(&tally));
  answer.answer.stage = tally.deepest();
  return answer;
}

PolygonAnswer FilteredPolygon::meet(const Segment& s) const { return decide(s); }

PolygonAnswer FilteredPolygon::meet(const Ray& r) const { return decide(r); }

}  // namespace tribunal
