// Signs of points with integer coordinates, in integers whose types grow with the formula.
#pragma once

#include "core/kernel.h"
#include "exact/kernels/integers.h"
#include "exact/kernels/rational_kernel.h"

namespace tribunal {

/// Exact where every coordinate is a value of N: an integer, of magnitude below 2^B for BoundedInteger<B>. It shares
/// neither numbers nor the scaling to integers with the filtered kernel, which it judges.
template <class N>
class LatticeKernel {
 public:
  template <class X>
  Sign orient3d(const Point3& a, const Point3& b, const Point3& c, const X& x) const {
    return sign_of(volume(a, b, c, x));
  }

  template <class X>
  Sign orient2d(Axis dropped, const Point3& a, const Point3& b, const X& x) const {
    const Vec2<Arm> f = project(arm_to(a, b), dropped), g = project(arm_to(a, x), dropped);
    return sign_of(minor(f.u, g.v, f.v, g.u));
  }

  template <class X>
  Sign compare(Axis axis, const Point3& a, const X& x) const {
    return sign_of(coordinate(arm_to(a, x), axis));
  }

  Sign compare_hits(const Ray& r, const Triangle& s, const Triangle& t) const {
    return RationalKernel{}.compare_hits(r, s, t);
  }

 private:
  using Arm = decltype(N() - N());

  static Arm length(double from, double to) { return N(to) - N(from); }
  static Vec3<Arm> arm_to(const Point3& o, const Point3& p) {
    return {length(o.x, p.x), length(o.y, p.y), length(o.z, p.z)};
  }
  static Vec3<Arm> arm_to(const Point3&, const Direction& d) { return arm_to(Point3(0), d.v); }

  static auto minor(const Arm& a, const Arm& b, const Arm& c, const Arm& d) { return a * b - c * d; }

  /// det(b − a, c − a, x − a), by the cofactors of its last row.
  template <class X>
  static auto volume(const Point3& a, const Point3& b, const Point3& c, const X& x) {
    const Vec3<Arm> u = arm_to(a, b), v = arm_to(a, c), w = arm_to(a, x);
    return w.x * minor(u.y, v.z, u.z, v.y) + w.y * minor(u.z, v.x, u.x, v.z) + w.z * minor(u.x, v.y, u.y, v.x);
  }
};

static_assert(Kernel<LatticeKernel<BoundedInteger<61>>>);

/// The exact kernel that computes in N.
template <class N>
struct ExactKernelOn {
  using Kernel = LatticeKernel<N>;
};

template <>
struct ExactKernelOn<Dyadic> {
  using Kernel = RationalKernel;
};

}  // namespace tribunal
