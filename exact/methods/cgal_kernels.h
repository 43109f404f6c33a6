// CGAL's exact kernels as kernels of the Segura–Feito test. CGAL's headers stay behind the .cpp files.
#pragma once

#include "core/kernel.h"

namespace tribunal {

/// Signs by CGAL's Exact_predicates_inexact_constructions_kernel. Exact for every finite input.
struct EpickKernel {
  Sign orient3d(const Point3& a, const Point3& b, const Point3& c, const Point3& x) const;
  Sign orient3d(const Point3& a, const Point3& b, const Point3& c, const Direction& x) const;
  Sign orient2d(Axis dropped, const Point3& a, const Point3& b, const Point3& x) const;
  Sign orient2d(Axis dropped, const Point3& a, const Point3& b, const Direction& x) const;
  Sign compare_hits(const Ray& r, const Triangle& s, const Triangle& t) const;
  Sign orient3d(const Point3& a, const Point3& b, const Point3& c, const RayPoint& x) const;
  Sign orient2d(Axis dropped, const Point3& a, const Point3& b, const RayPoint& x) const;
  Sign compare(Axis axis, const Point3& a, const RayPoint& x) const;

  /// Not CGAL's: the sign of one rounded difference is exact.
  template <class X>
  Sign compare(Axis axis, const Point3& a, const X& x) const {
    return FormulaKernel<double>{}.compare(axis, a, x);
  }
};

/// Signs by CGAL's Exact_predicates_exact_constructions_kernel. Exact for every finite input.
struct EpeckKernel {
  Sign orient3d(const Point3& a, const Point3& b, const Point3& c, const Point3& x) const;
  Sign orient3d(const Point3& a, const Point3& b, const Point3& c, const Direction& x) const;
  Sign orient2d(Axis dropped, const Point3& a, const Point3& b, const Point3& x) const;
  Sign orient2d(Axis dropped, const Point3& a, const Point3& b, const Direction& x) const;
  Sign compare_hits(const Ray& r, const Triangle& s, const Triangle& t) const;
  Sign orient3d(const Point3& a, const Point3& b, const Point3& c, const RayPoint& x) const;
  Sign orient2d(Axis dropped, const Point3& a, const Point3& b, const RayPoint& x) const;
  Sign compare(Axis axis, const Point3& a, const RayPoint& x) const;

  /// Not CGAL's: the sign of one rounded difference is exact.
  template <class X>
  Sign compare(Axis axis, const Point3& a, const X& x) const {
    return FormulaKernel<double>{}.compare(axis, a, x);
  }
};

static_assert(BoundsKernel<EpickKernel> && BoundsKernel<EpeckKernel>);

}  // namespace tribunal
