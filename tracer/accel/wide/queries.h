// Queries that take the candidates of a walk: any hit, every hit, all crossings. The closest hit is in closest.h.
#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include "exact/filtered/crossing.h"
#include "tracer/accel/wide/closest.h"

namespace tribunal {

/// Whether there is a hit. `Judge` has
///   bool accepts(id)   whether a certain hit counts;
///   bool sees(place, id, limit)   whether an uncertain candidate is a hit that counts.
template <class Judge>
class AnyQuery final : public CandidateQuery {
 public:
  AnyQuery(const WideTree& tree, Judge& judge) : tree_(tree), judge_(judge) {}

  bool found(const Candidate& f) override {
    const std::uint32_t id = tree_.id(f.place);
    met_ = f.certain ? judge_.accepts(id) : judge_.sees(f.place, id, std::numeric_limits<double>::infinity());
    return met_;
  }

  bool met() const { return met_; }

 private:
  const WideTree& tree_;
  Judge& judge_;
  bool met_ = false;
};

/// Keeps every hit of a ray. `Judge` is as for ClosestQuery; its hits must be exact.
template <class Judge>
class AllQuery final : public CandidateQuery {
 public:
  AllQuery(const WideTree& tree, Judge& judge) : tree_(tree), judge_(judge) {}

  bool found(const Candidate& f) override {
    const std::uint32_t id = tree_.id(f.place);
    if (!f.certain && !judge_.sees(f.place, id, std::numeric_limits<double>::infinity())) return false;
    HitBounds bounds = hit_bounds(f.num, f.bound, f.den, f.bound);
    if (!bounds.are_close()) bounds = hit_bounds(judge_.ray, judge_.plane(f.place, id));
    hits_.push_back({f.place, id, bounds.nearest_to(f.num / f.den), bounds});
    return false;
  }

  /// All hits, by exact t, then by id.
  const std::vector<BoundedHit>& in_order() {
    std::sort(hits_.begin(), hits_.end(),
              [&](const BoundedHit& a, const BoundedHit& b) { return comes_before(judge_, a, b); });
    return hits_;
  }

 private:
  const WideTree& tree_;
  Judge& judge_;
  std::vector<BoundedHit> hits_;
};

/// Counts how a ray crosses the triangles (exact/filtered/crossing.h). Not for walks that may report a candidate
/// twice.
class CrossingQuery final : public CandidateQuery {
 public:
  CrossingQuery(const WideTree& tree, const Ray& ray) : tree_(tree), ray_(ray) {}

  bool found(const Candidate& f) override {
    const Crossing c = f.certain ? Crossing{false, f.num < 0 ? 1 : -1} : crossing(ray_, tree_.triangle(f.place));
    count_ += c.direction != 0;
    winding_ += c.direction;
    on_surface_ |= c.holds_source;
    return on_surface_;
  }

  std::uint64_t count() const { return count_; }
  std::int64_t winding() const { return winding_; }
  bool on_surface() const { return on_surface_; }

 private:
  const WideTree& tree_;
  const Ray& ray_;
  std::uint64_t count_ = 0;
  std::int64_t winding_ = 0;
  bool on_surface_ = false;
};

}  // namespace tribunal
