// Which of the findings of a walk along a ray is the closest hit.
#pragma once

#include <optional>

#include "core/sign.h"
#include "tracer/accel/wide/traversal.h"

namespace tribunal {

/// Bounds of the exact parameter of a hit.
struct HitBounds {
  double least = 0, greatest = std::numeric_limits<double>::infinity();

  /// x, or the nearest number within; of a NaN, least.
  double nearest_to(double x) const { return x >= least ? std::min(x, greatest) : least; }
};

/// Of a triangle that the ray hits. The hit is at N/D with |N − num|, |D − den| ≤ bound, so where den is certain,
///   (|num| − bound)/(|den| + bound) ≤ t ≤ (|num| + bound)/(|den| − bound);
/// each operation is rounded outward by the law of box.h.
inline HitBounds hit_bounds(const Finding& f) {
  const double n = f.den < 0 ? -f.num : f.num, d = f.den < 0 ? -f.den : f.den;
  if (!(d > f.bound)) return {};
  return {std::max(0.0, below(below(n - f.bound) / above(d + f.bound))),
          above(above(n + f.bound) / below(d - f.bound))};
}

/// A hit and the bounds of its parameter. `t` is rounded, and within them.
struct BoundedHit {
  Place place;
  std::uint32_t id;
  double t;
  HitBounds bounds;
};

/// Keeps the closest hit: least exact t, ties by lowest id. `Judge` has
///   bool sees(place, id)   whether an uncertain finding is a hit;
///   double latest(place, id)   a bound on the t of a hit of which the walk knows none;
///   Sign order(hit, other)   exact sign of t₁ − t₂, asked only where bounds overlap.
template <class Judge>
class ClosestFinder final : public Finder {
 public:
  ClosestFinder(const WideTree& tree, const WideProbe& probe, Judge& judge)
      : tree_(tree), probe_(probe), judge_(judge) {}

  bool found(const Finding& f) override {
    const std::uint32_t id = tree_.id(f.place);
    certain_ += f.certain;
    if (!f.certain && !judge_.sees(f.place, id)) return false;
    const HitBounds bounds = hit_bounds(f);
    const bool bounded = bounds.greatest < std::numeric_limits<double>::infinity();
    limit = std::min(limit, probe_.limit_at(bounded ? bounds.greatest : judge_.latest(f.place, id)));
    const BoundedHit hit{f.place, id, bounds.nearest_to(f.num / f.den), bounds};
    if (!best_ || is_closer(hit, *best_)) best_ = hit;
    return false;
  }

  const std::optional<BoundedHit>& best() const { return best_; }

  /// How many hits were certain.
  std::uint64_t certain() const { return certain_; }

 private:
  bool is_closer(const BoundedHit& hit, const BoundedHit& than) const {
    if (hit.bounds.greatest < than.bounds.least) return true;
    if (hit.bounds.least > than.bounds.greatest) return false;
    const Sign order = judge_.order(hit, than);
    return order == Sign::negative || (order == Sign::zero && hit.id < than.id);
  }

  const WideTree& tree_;
  const WideProbe& probe_;
  Judge& judge_;
  std::optional<BoundedHit> best_;
  std::uint64_t certain_ = 0;
};

/// A bound on the t at which a ray hits something in a box.
inline double latest_in(const Box& box, const Ray& ray) {
  const Span span = BoxProbe(ray).span(box);
  return span.empty() ? std::numeric_limits<double>::infinity() : span.last;
}

}  // namespace tribunal
