// A kernel of adaptive floating-point expansions.
#pragma once

#include <cstdint>

#include "core/kernel.h"

namespace tribunal {

/// Signs by who decided them.
struct ExpansionTally {
  std::uint64_t bound = 0;       ///< the formula in double, whose value exceeds the bound on its error
  std::uint64_t expansions = 0;  ///< the formula on expansions, which are exact
  std::uint64_t dyadic = 0;      ///< the reference kernel: the operands span too many binades for expansions
};

/// Exact for all finite binary64 coordinates, in round-to-nearest with subnormal numbers. Source: J. R. Shewchuk,
/// "Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates", Discrete & Computational
/// Geometry 18, 1997, doi:10.1007/PL00009321; its stages A and D, and what it leaves to the caller: operands that
/// underflow or overflow are moved by powers of two, and where that does not suffice GMP decides. A tally, if given,
/// counts the signs of volumes, areas and orders of hits. Use one a thread.
class ExpansionKernel {
 public:
  explicit ExpansionKernel(ExpansionTally* tally = nullptr) : tally_(tally) {}

  Sign orient3d(const Point3& a, const Point3& b, const Point3& c, const Point3& x) const;
  Sign orient3d(const Point3& a, const Point3& b, const Point3& c, const Direction& x) const;
  Sign orient2d(Axis dropped, const Point3& a, const Point3& b, const Point3& x) const;
  Sign orient2d(Axis dropped, const Point3& a, const Point3& b, const Direction& x) const;
  Sign compare_hits(const Ray& r, const Triangle& s, const Triangle& t) const;

  /// Of the points of a ray: by the bound, else by GMP.
  Sign orient3d(const Point3& a, const Point3& b, const Point3& c, const RayPoint& x) const;
  Sign orient2d(Axis dropped, const Point3& a, const Point3& b, const RayPoint& x) const;
  Sign compare(Axis axis, const Point3& a, const RayPoint& x) const;

  /// The sign of one rounded difference is exact.
  template <class X>
  Sign compare(Axis axis, const Point3& a, const X& x) const {
    return FormulaKernel<double>{}.compare(axis, a, x);
  }

 private:
  /// What is asked with the caller's tally, or with one that nobody reads.
  template <class Asked>
  Sign counted(const Asked& ask) const {
    ExpansionTally unread;
    return ask(tally_ != nullptr ? *tally_ : unread);
  }

  ExpansionTally* tally_;
};

static_assert(BoundsKernel<ExpansionKernel>);

}  // namespace tribunal
