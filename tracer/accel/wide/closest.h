// Which of the candidates of a walk along a ray is the closest hit.
#pragma once

#include <optional>

#include "core/sign.h"
#include "exact/filtered/term_filter.h"
#include "tracer/accel/wide/traversal.h"

namespace tribunal {

using namespace detail;

/// Bounds of the exact parameter of a hit.
struct HitBounds {
  double least = 0, greatest = std::numeric_limits<double>::infinity();

  /// Bounds are close if they differ by less than this share of the greater one.
  static constexpr double close_width = 0x1p-21;
  bool are_close() const { return least > (1 - close_width) * greatest; }

  /// x if it lies within the bounds, else the nearer bound; `least` if x is a NaN.
  double nearest_to(double x) const { return x >= least ? std::min(x, greatest) : least; }
};

/// Bounds of the t = N/D at which a ray crosses a plane, where |N − num| ≤ e and |D − den| ≤ g. If |den| > g,
///   (|num| − e)/(|den| + g) ≤ t ≤ (|num| + e)/(|den| − g);
/// each operation is rounded outward by the law of box.h. Else nothing is known of t ≥ 0.
inline HitBounds hit_bounds(double num, double e, double den, double g) {
  const double n = den < 0 ? -num : num, d = den < 0 ? -den : den;
  if (!(d > g)) return {};
  return {std::max(0.0, below(below(n - e) / above(d + g))), above(above(n + e) / below(d - g))};
}

/// The same by the bounds of the filter by terms, which stay close where the triangle is small and far away.
inline HitBounds hit_bounds(const Ray& ray, const Triangle& t) {
  const FilterConstants<double>& c = volume_terms_filter;
  const Vec3<double> a = lift<double>(t.a), u = arm<double>(a, t.b), v = arm<double>(a, t.c), w = arm<double>(a, ray.o),
                     d = lift<double>(ray.d.v);
  if (!in_range(largest(u, v, w, d), c)) return {};
  const Expansion<double> height = expanded(u, v, w), gain = expanded(u, v, d);
  return hit_bounds(height.value, c.k * height.terms + c.tiny, -gain.value, c.k * gain.terms + c.tiny);
}

/// A hit, and bounds of its exact parameter. `t` is a rounded parameter within these bounds.
struct BoundedHit {
  Place place;
  std::uint32_t id;
  double t;
  HitBounds bounds;
};

/// Whether a hit comes before another: at a lesser exact t, or at the same t with a lesser id. The hit is passed by
/// value, so that it may stay in registers.
template <class Judge>
bool comes_before(const Judge& judge, BoundedHit hit, const BoundedHit& other) {
  if (hit.bounds.greatest < other.bounds.least) return true;
  if (hit.bounds.least > other.bounds.greatest) return false;
  const Sign order = judge.order(hit, other);
  return order == Sign::negative || (order == Sign::zero && hit.id < other.id);
}

/// Keeps the closest hit: least exact t, ties by lowest id. `Judge` has
///   bool sees(place, id, limit)   whether an uncertain candidate is a hit; beyond the limit either answer will do;
///   Span span(place, id)   the span of the ray in the box of the hit face, for hits with wide bounds of t;
///   Triangle plane(place, id)   three points of the plane of a hit;
///   bool is_exact()   whether its answers are exact, so that every hit lies in the box of its face;
///   Sign order(hit, other)   sign of t₁ − t₂, asked only where bounds overlap.
template <class Judge>
class ClosestQuery final : public CandidateQuery {
 public:
  ClosestQuery(const WideTree& tree, const WideProbe& probe, Judge& judge)
      : tree_(tree), probe_(probe), judge_(judge) {}

  bool found(const Candidate& f) override {
    const std::uint32_t id = tree_.id(f.place);
    certain_ += f.certain;
    if (!f.certain && !judge_.sees(f.place, id, latest_)) return false;
    const HitBounds bounds = bounds_of(f, id);
    limit = probe_.limit_at(latest_);
    const BoundedHit hit{f.place, id, bounds.nearest_to(f.num / f.den), bounds};
    if (!best_ || comes_before(judge_, hit, *best_)) best_ = hit;
    return false;
  }

  const std::optional<BoundedHit>& best() const { return best_; }

  /// How many hits were certain.
  std::uint64_t certain() const { return certain_; }

 private:
  /// Bounds of the hit's parameter from the volumes that the lanes computed. Where these bounds are wide, as they are
  /// for distant triangles: from the filter by terms, or else from the box of the triangle. Lowers latest_.
  HitBounds bounds_of(const Candidate& f, std::uint32_t id) {
    HitBounds bounds = hit_bounds(f.num, f.bound, f.den, f.bound);
    if (!bounds.are_close() && judge_.is_exact()) bounds = hit_bounds(judge_.ray, judge_.plane(f.place, id));
    latest_ = std::min(latest_, bounds.greatest);
    if (bounds.are_close()) return bounds;
    const Span span = judge_.span(f.place, id);
    if (span.empty()) return bounds;
    latest_ = std::min(latest_, span.last);
    if (!judge_.is_exact()) return {};
    return {std::max(bounds.least, span.first), std::min(bounds.greatest, span.last)};
  }

  const WideTree& tree_;
  const WideProbe& probe_;
  Judge& judge_;
  std::optional<BoundedHit> best_;
  std::uint64_t certain_ = 0;
  double latest_ = std::numeric_limits<double>::infinity();  ///< the closest hit is at no greater t
};

}  // namespace tribunal
