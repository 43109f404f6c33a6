// Which of the findings of a walk along a ray is the closest hit.
#pragma once

#include <optional>

#include "core/sign.h"
#include "tracer/accel/wide/traversal.h"

namespace tribunal {

/// Bounds of the exact parameter of a hit.
struct HitBounds {
  double least, greatest;
};

/// Of a triangle that the ray hits. The hit is at N/D with |N − num|, |D − den| ≤ bound, so where den is certain,
///   (|num| − bound)/(|den| + bound) ≤ t ≤ (|num| + bound)/(|den| − bound);
/// each operation is rounded outward by the law of box.h. Otherwise t is bounded by the ray's span in the box.
inline HitBounds hit_bounds(const Finding& f, const Ray& ray, const Box& box) {
  const double n = f.den < 0 ? -f.num : f.num, d = f.den < 0 ? -f.den : f.den;
  if (d > f.bound) {
    return {std::max(0.0, below(below(n - f.bound) / above(d + f.bound))),
            above(above(n + f.bound) / below(d - f.bound))};
  }
  const Span span = BoxProbe(ray).span(box);
  return {span.first, span.last};
}

/// A hit and the bounds of its parameter. `t` is rounded, and within them.
struct BoundedHit {
  Place place;
  std::uint32_t id;
  double t;
  HitBounds bounds;
};

/// Keeps the closest hit: least exact t, ties by lowest id. `Judge` has
///   bool sees(place, id)         whether an uncertain finding is a hit;
///   Box box(place, id)           of a primitive that is hit;
///   Sign order(BoundedHit, BoundedHit)   exact sign of t₁ − t₂, asked only where the bounds overlap.
template <class Judge>
class ClosestFinder final : public Finder {
 public:
  ClosestFinder(const WideTree& tree, const WideProbe& probe, const Ray& ray, Judge& judge)
      : tree_(tree), probe_(probe), ray_(ray), judge_(judge) {}

  bool found(const Finding& f) override {
    const std::uint32_t id = tree_.id(f.place);
    if (!f.certain && !judge_.sees(f.place, id)) return false;
    const bool by_volumes = f.den > f.bound || -f.den > f.bound;
    const HitBounds bounds = hit_bounds(f, ray_, by_volumes ? Box() : judge_.box(f.place, id));
    limit = std::min(limit, probe_.limit_at(bounds.greatest));
    const BoundedHit hit{f.place, id, within(bounds, f.num / f.den), bounds};
    if (!best_ || is_closer(hit, *best_)) best_ = hit;
    return false;
  }

  const std::optional<BoundedHit>& best() const { return best_; }

 private:
  static double within(const HitBounds& b, double t) { return t >= b.least ? std::min(t, b.greatest) : b.least; }

  bool is_closer(const BoundedHit& hit, const BoundedHit& than) const {
    if (hit.bounds.greatest < than.bounds.least) return true;
    if (hit.bounds.least > than.bounds.greatest) return false;
    const Sign order = judge_.order(hit, than);
    return order == Sign::negative || (order == Sign::zero && hit.id < than.id);
  }

  const WideTree& tree_;
  const WideProbe& probe_;
  const Ray& ray_;
  Judge& judge_;
  std::optional<BoundedHit> best_;
};

}  // namespace tribunal
