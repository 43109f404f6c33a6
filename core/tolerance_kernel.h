// The kernel that most programs have: a volume closer to zero than a fixed tolerance is called zero.
// It exists to be measured.
#pragma once

#include "core/kernel.h"

namespace tribunal {

/// FormulaKernel<double> with an absolute tolerance. Not a filter: it decides wrongly instead of abstaining.
struct ToleranceKernel {
  double tolerance = 1e-12;  ///< in units of the value compared: cubed, squared or plain input units

  template <class X>
  Sign orient3d(const Point3& a, const Point3& b, const Point3& c, const X& x) const {
    return snap(signed_volume<double>(a, b, c, x));
  }

  template <class X>
  Sign orient2d(Axis dropped, const Point3& a, const Point3& b, const X& x) const {
    return snap(signed_area<double>(dropped, a, b, x));
  }

  template <class X>
  Sign compare(Axis axis, const Point3& a, const X& x) const {
    return snap(signed_length<double>(axis, a, x));
  }

  Sign compare_hits(const Ray& r, const Triangle& s, const Triangle& t) const { return order_of_hits<double>(r, s, t); }

 private:
  Sign snap(double x) const { return x > tolerance ? Sign::positive : x < -tolerance ? Sign::negative : Sign::zero; }
};

static_assert(BoundsKernel<ToleranceKernel>);

}  // namespace tribunal
