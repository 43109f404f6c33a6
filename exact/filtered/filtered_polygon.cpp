#include "exact/filtered/filtered_polygon.h"

#include <cmath>

#include "exact/filtered/filtered.h"
#include "exact/filtered/filtered_kernel.h"

namespace tribunal {

using namespace detail;

namespace {

double largest_coordinate(const Vec3<double>& v) { return larger(larger_magnitude(v.x, v.y), magnitude(v.z)); }

/// The longest of the vectors.
Vec3<double> longest(const std::vector<Vec3<double>>& vectors) {
  Vec3<double> best{0, 0, 0};
  for (const Vec3<double>& v : vectors) {
    if (dot(v, v) > dot(best, best)) best = v;
  }
  return best;
}

/// The largest product of the magnitudes on two axes.
double largest_face(const Vec3<double>& m) { return larger(larger(m.x * m.y, m.y * m.z), m.z * m.x); }

Vec3<double> scaled(const Vec3<double>& v, int exponent) {
  return {std::ldexp(v.x, exponent), std::ldexp(v.y, exponent), std::ldexp(v.z, exponent)};
}

/// Products of arms within this range do not overflow, and their underflow is harmless: docs/error-bounds.md.
constexpr double largest_arm = 0x1p150, smallest_face = 0x1p-200;

}  // namespace

FilteredPolygon::FilteredPolygon(const Polygon& polygon) : covering_(cover(polygon, FilteredKernel())) {
  if (covering_.plane) prepare_filter();
}

/// The normal is the cross product of the longest arm from the first vertex with the one that gives the longest. Where
/// it is too short to be certain on its longest axis, or out of range, it stays zero, and so do all heights.
void FilteredPolygon::prepare_filter() {
  const Vec3<double> base = lift<double>(covering_.polygon.vertices.front());
  std::vector<Vec3<double>> arms, normals;
  for (const Point3& v : covering_.polygon.vertices) arms.push_back(arm(base, v));
  const Vec3<double> b = longest(arms);
  for (const Vec3<double>& c : arms) normals.push_back(cross(b, c));
  const Vec3<double> n = longest(normals);
  Vec3<double> reach{0, 0, 0};
  for (const Vec3<double>& c : arms) reach = largest(reach, c);
  const double face = largest_face(reach);
  if (!(largest_coordinate(reach) < largest_arm) || !(face > smallest_face)) return;
  const Vec3<double> normal = scaled(n, std::ilogb(normal_scale) - std::ilogb(face) - 1);
  const double m = largest_coordinate(normal);
  if (!(m > 2 * rounding)) return;
  base_ = beside(base, base);
  normal_ = beside(normal, normal);
  const int dropped = m == magnitude(normal.x) ? 0 : m == magnitude(normal.y) ? 1 : 2;
  u_ = (dropped + 1) % 3;
  v_ = (dropped + 2) % 3;
  flatten(base);
}

/// Runs share their end vertices, so that no edge is lost between two.
void FilteredPolygon::flatten(const Vec3<double>& base) {
  std::vector<double> u, v;
  std::vector<bool> leads_on;
  const Polygon& polygon = covering_.polygon;
  const auto add = [&](const Point3& p, bool edge) {
    const Vec3<double> a = arm(base, p);
    const double along[3] = {a.x, a.y, a.z};
    u.push_back(along[u_]);
    v.push_back(along[v_]);
    leads_on.push_back(edge);
    extent_ = larger(larger_magnitude(u.back(), v.back()), extent_);
  };
  for (std::size_t r = 0; r < polygon.rings(); ++r) {
    const Ring ring = polygon.ring(r);
    if (ring.empty()) continue;
    for (const Point3& p : ring) add(p, true);
    add(ring.front(), false);
  }
  const std::size_t count = u.size();
  add(polygon.vertices.back(), false);
  flat_ = u;
  flat_.insert(flat_.end(), v.begin(), v.end());
  for (std::size_t begin = 0; begin + 1 < count; begin += 63) {
    const std::size_t size = std::min<std::size_t>(64, count - begin);
    RingRun& run = begin == 0 ? first_run_ : other_runs_.emplace_back();
    run = {&flat_[begin], &flat_[u.size() + begin], (size + 1) / 2 * 2, 0};
    for (std::size_t i = 0; i + 1 < size; ++i) run.edges |= std::uint64_t{leads_on[begin + i]} << i;
  }
}

PolygonFigures FilteredPolygon::figures() const {
  PolygonFigures f{{first(base_.x), first(base_.y), first(base_.z)},
                   {first(normal_.x), first(normal_.y), first(normal_.z)},
                   extent_,
                   u_,
                   v_,
                   {}};
  if (first_run_.size > 0) f.runs.push_back(first_run_);
  f.runs.insert(f.runs.end(), other_runs_.begin(), other_runs_.end());
  return f;
}

/// A point of the projection is a crossing with denominator 1: off by one rounding where a crossing may be off by 16,
/// of range extent + reach, so the bounds of plane_crossing.h hold all the more. Where both ends see the same vertices
/// below and the same crossed edges ahead, certainly, so does every point between, since each of these is the sign of a
/// function that is affine in the point.
std::optional<bool> FilteredPolygon::filter_between(const Segment& s) const {
  const Vec3<Twin<double>> ends = ends_from(base_, s);
  const Twin<double> reach = reach_of(ends), along[3] = {ends.x, ends.y, ends.z}, u = along[u_], v = along[v_];
  const double range = larger(first(reach), second(reach)) + extent_;
  if (!(range < crossing_bounds.huge) || first_run_.size == 0) return std::nullopt;
  const PlaneCrossing<double> p{{first(u), first(v)}, 1}, q{{second(u), second(v)}, 1};
  bool odd = false;
  for (std::size_t i = 0; i <= other_runs_.size(); ++i) {
    const RingRun& run = i == 0 ? first_run_ : other_runs_[i - 1];
    const View from = view_of(run, p, range), to = view_of(run, q, range);
    if (!from.certain || !to.certain || from.below != to.below || from.ahead != to.ahead) return std::nullopt;
    odd ^= from.odd();
  }
  return odd;
}

/// A certain hit is in general position: inside, between the ends.
template <class P>
Answer FilteredPolygon::decide(const P& probe) const {
  if (const std::optional<bool> hit = filter_hits(probe)) return certain(*hit);
  return decide_exactly(probe);
}

template <class P>
Answer FilteredPolygon::decide_exactly(const P& probe) const {
  if (!is_finite(probe)) return refusal(Status::nonfinite);
  if (covering_.is_triangle()) return detail::of_polygon(intersect(probe, covering_.triangle()));
  Tally tally;
  Answer answer = segura_feito(probe, covering_, FilteredKernel(&tally));
  answer.stage = tally.deepest();
  return answer;
}

Answer FilteredPolygon::meet(const Segment& s) const { return decide(s); }

Answer FilteredPolygon::meet(const Ray& r) const { return decide(r); }

/// Hit or miss by the signed sum of crossings, without the kind of contact, where the probe is not in the plane of a
/// planar polygon; else by the whole test.
template <class P>
bool FilteredPolygon::decide_hit(const P& probe) const {
  if (!covering_.plane || covering_.is_triangle() || !is_finite(probe)) return decide_exactly(probe).hit;
  const FilteredKernel k;
  const PlaneSides sides = sides_of(covering_.plane->triangle, probe, k);
  if (sides.in_plane()) return decide_exactly(probe).hit;
  return reaches(sides.source, sides.target, target(probe)) && plane_crossings(probe, covering_, sides, k).hit();
}

bool FilteredPolygon::hits_exactly(const Segment& s) const { return decide_hit(s); }

bool FilteredPolygon::hits_exactly(const Ray& r) const { return decide_hit(r); }

}  // namespace tribunal
