// What a decision may ask of arithmetic: signs, and nothing else.
#pragma once

#include <concepts>

#include "core/operands.h"
#include "core/sign.h"
#include "core/signed_volume.h"

namespace tribunal {

/// A kernel answers signs of signed volumes, areas and lengths. x is a point or a direction.
///
/// Laws of every kernel: it is a pure function of the coordinates; +0 and −0 are the same.
/// Laws of an exact kernel:
///   (1) orient3d of (0,0,0), (1,0,0), (0,1,0), (0,0,1) and orient2d of (0,0), (1,0), (0,1) are positive;
///   (2) swapping two points negates orient3d and orient2d; compare(a, b) = −compare(b, a);
///   (3) multiplying all coordinates by a power of two, or one axis by a positive one, changes nothing,
///       as long as no coordinate overflows or loses bits; negating one axis negates orient3d;
///   (4) an exact translation of all points (not directions) changes nothing;
///   (5) a repeated point, and any affinely dependent points, give zero;
///   (6) orient3d(a, b, c, Direction{q − a}) = orient3d(a, b, c, q) where q − a is exact;
///   (7) the Grassmann–Plücker relation holds for every five points: the signs are those of real numbers.
template <class K>
concept Kernel = requires(const K& k, const Point3& p, const Direction& d, Axis axis, const Ray& r, const Triangle& t) {
  { k.orient3d(p, p, p, p) } -> std::same_as<Sign>;
  { k.orient3d(p, p, p, d) } -> std::same_as<Sign>;
  { k.orient2d(axis, p, p, p) } -> std::same_as<Sign>;
  { k.orient2d(axis, p, p, d) } -> std::same_as<Sign>;
  { k.compare(axis, p, p) } -> std::same_as<Sign>;
  { k.compare(axis, p, d) } -> std::same_as<Sign>;
  { k.compare_hits(r, t, t) } -> std::same_as<Sign>;
};

/// A kernel that also answers where a point o + t·d of a ray lies, by the ray's own numbers: the sign of the volume
/// a b c x is then that of V(o) + t·V(d), where V are volumes over a b c. So it says whether a ray reaches a plane
/// before or after t, without division. The laws of a kernel hold for such an x as for a point.
template <class K>
concept BoundsKernel = Kernel<K> && requires(const K& k, const Point3& p, const RayPoint& x, Axis axis) {
  { k.orient3d(p, p, p, x) } -> std::same_as<Sign>;
  { k.orient2d(axis, p, p, x) } -> std::same_as<Sign>;
  { k.compare(axis, p, x) } -> std::same_as<Sign>;
};

/// The ray reaches the plane of t at parameter num/den; both are signed volumes. den = 0: never, or always.
template <class N>
struct HitParameter {
  N num, den;
};

template <class N>
HitParameter<N> hit_parameter(const Ray& r, const Triangle& t) {
  return {signed_volume<N>(t.a, t.b, t.c, r.o), -signed_volume<N>(t.a, t.b, t.c, r.d)};
}

/// The sign of t₁ − t₂, for two triangles that the ray crosses (both denominators nonzero):
/// n₁/d₁ − n₂/d₂ = (n₁·d₂ − n₂·d₁) / (d₁·d₂), so no division is needed.
template <class N>
Sign order_of_hits(const Ray& r, const Triangle& s, const Triangle& t) {
  const HitParameter<N> f = hit_parameter<N>(r, s);
  const HitParameter<N> g = hit_parameter<N>(r, t);
  const N difference = f.num * g.den - g.num * f.den;
  return sign_of(difference) * sign_of(f.den) * sign_of(g.den);
}

/// The kernel that evaluates the formulas in N and takes the sign of the result. Exact iff N is.
/// `float` and `double` give the naive kernels, an exact N the reference.
template <class N>
struct FormulaKernel {
  using Number = N;

  template <class X>
  Sign orient3d(const Point3& a, const Point3& b, const Point3& c, const X& x) const {
    return sign_of(signed_volume<N>(a, b, c, x));
  }

  template <class X>
  Sign orient2d(Axis dropped, const Point3& a, const Point3& b, const X& x) const {
    return sign_of(signed_area<N>(dropped, a, b, x));
  }

  template <class X>
  Sign compare(Axis axis, const Point3& a, const X& x) const {
    return sign_of(signed_length<N>(axis, a, x));
  }

  Sign compare_hits(const Ray& r, const Triangle& s, const Triangle& t) const { return order_of_hits<N>(r, s, t); }
};

static_assert(BoundsKernel<FormulaKernel<float>> && BoundsKernel<FormulaKernel<double>>);

}  // namespace tribunal
