// The filter on the triangles of a leaf, one a lane. Included by files that are compiled for one instruction set each.
#pragma once

#include <bit>

#include "exact/filtered/batch/batch_lanes.h"
#include "tracer/accel/wide/traversal.h"

namespace tribunal::HWY_NAMESPACE {

/// What the filter found of the triangles of a leaf, a bit each: `rest` are not certainly missed, `hit` are certainly
/// hit, `safe` have coordinates for which the error bound holds. For the safe ones, the volumes of the source and of
/// the direction, up to ±bound.
struct Filtered {
  unsigned rest = 0, hit = 0, safe = 0;
  double source[leaf_size], toward[leaf_size], bound[leaf_size];

  /// Passes the candidates to the query until it wants no more; returns whether that was so.
  HWY_NOINLINE bool report(NodeRef leaf, CandidateQuery& query) const {
    for (unsigned left = rest; left != 0; left &= left - 1) {
      const auto k = static_cast<std::uint32_t>(std::countr_zero(left));
      const bool known = (safe >> k & 1) != 0;
      const Candidate candidate{{leaf, k},
                                (hit >> k & 1) != 0,
                                source[k],
                                -toward[k],
                                known ? bound[k] : std::numeric_limits<double>::infinity()};
      if (query.found(candidate)) return true;
    }
    return false;
  }
};

/// The probe and the filter's constants in every lane.
template <class P>
class LeafFilter {
 public:
  explicit LeafFilter(const P& probe)
      : source_(broadcast(tribunal::source(probe))), target_(broadcast(vector_of(tribunal::target(probe)))) {}

  HWY_INLINE void filter(const WideTree& tree, NodeRef leaf, Filtered& filtered, WalkCounts& counts) const {
    const double* const column = tree.columns(leaf);
    const std::size_t count = leaf.count();
    constexpr std::size_t step = HWY_LANES(double);
    unsigned missed = 0;
    filtered.hit = filtered.safe = 0;
    for (std::size_t from = 0; from < count; from += step) {
      const LiftedTriangle<Lanes> t{vertex(column + from, 0, count), vertex(column + from, 1, count),
                                    vertex(column + from, 2, count)};
      const auto certain = conclude<P>(arms_of_lanes<P>(source_, target_, t), constants_);
      filtered.safe |= certain.safe.bits() << from;
      missed |= certain.miss.bits() << from;
      filtered.hit |= certain.hit.bits() << from;
      hn::StoreU(certain.volumes.sides.source.v, tag, filtered.source + from);
      hn::StoreU(certain.volumes.sides.toward.v, tag, filtered.toward + from);
      hn::StoreU(certain.bound.v, tag, filtered.bound + from);
    }
    const unsigned present = (1U << count) - 1;
    counts.missed += static_cast<unsigned>(std::popcount(missed & present));
    filtered.rest = present & ~missed;
  }

 private:
  static const Point3& vector_of(const Point3& p) { return p; }
  static const Point3& vector_of(const Direction& d) { return d.v; }
  static Vec3<Lanes> broadcast(const Point3& p) { return {Lanes(p.x), Lanes(p.y), Lanes(p.z)}; }

  static HWY_INLINE Vec3<Lanes> vertex(const double* column, std::size_t k, std::size_t count) {
    return {Lanes::load(column + 3 * k * count), Lanes::load(column + (3 * k + 1) * count),
            Lanes::load(column + (3 * k + 2) * count)};
  }

  Vec3<Lanes> source_, target_;
  PairConstants<Lanes> constants_ = in_lanes(pair_filter<P>);
};

/// Passes all primitives of a leaf to the query as candidates of which nothing is known.
inline bool report_all(NodeRef leaf, CandidateQuery& query) {
  for (std::uint32_t lane = 0; lane < leaf.count(); ++lane) {
    if (query.found({{leaf, lane}, false, 0, 0, std::numeric_limits<double>::infinity()})) return true;
  }
  return false;
}

}  // namespace tribunal::HWY_NAMESPACE
