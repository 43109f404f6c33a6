// The filtered kernel: it takes each sign from the filter where that is certain, else it computes it exactly.
#pragma once

#include "core/kernel.h"
#include "exact/filtered/tally.h"

namespace tribunal {

/// Exact for all finite binary64 coordinates, whatever the rounding mode of the thread. Each sign comes from the first
/// stage that is certain:
///   filter     the formula in double, if its value exceeds a proved bound;
///   integers   the formula over integers of fixed width, on the operands moved to an integer grid;
///   exact      the formula over GMP integers.
/// A tally, if given, counts which stage decided. Thread safety: use one tally a thread; nothing else is shared.
class FilteredKernel {
 public:
  explicit FilteredKernel(Tally* tally = nullptr) : tally_(tally) {}

  Sign orient3d(const Point3& a, const Point3& b, const Point3& c, const Point3& x) const;
  Sign orient3d(const Point3& a, const Point3& b, const Point3& c, const Direction& x) const;
  Sign orient2d(Axis dropped, const Point3& a, const Point3& b, const Point3& x) const;
  Sign orient2d(Axis dropped, const Point3& a, const Point3& b, const Direction& x) const;
  Sign compare(Axis axis, const Point3& a, const Point3& x) const;
  Sign compare(Axis axis, const Point3& a, const Direction& x) const;
  Sign compare_hits(const Ray& r, const Triangle& s, const Triangle& t) const;

  /// Of the points of a ray: volumes by the filter or the stage `exact`, the rest by that stage.
  Sign orient3d(const Point3& a, const Point3& b, const Point3& c, const RayPoint& x) const;
  Sign orient2d(Axis dropped, const Point3& a, const Point3& b, const RayPoint& x) const;
  Sign compare(Axis axis, const Point3& a, const RayPoint& x) const;

 private:
  Sign counted(Sign s, Stage stage) const {
    if (tally_ != nullptr) ++(*tally_)[stage];
    return s;
  }

  Tally* tally_;
};

static_assert(BoundsKernel<FilteredKernel>);

/// orient3d without a filter, for callers that have tried one of their own.
Sign orient3d_exactly(const Triangle& t, const Point3& x);
Sign orient3d_exactly(const Triangle& t, const Direction& x);

}  // namespace tribunal
