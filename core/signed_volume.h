// The one formula of the project: signed volume, with its shadows in two and one dimensions.
// Source: Segura & Feito, "Algorithms to test ray-triangle intersection. Comparative study", WSCG 2001;
// Feito & Torres, "Inclusion test for general polyhedra", Computers & Graphics 21(1), 1997.
#pragma once

#include "core/vec3.h"

namespace tribunal {

/// det(u, v, w), expanded along its first row. Nine multiplications, no division.
template <class N>
N det3(const Vec3<N>& u, const Vec3<N>& v, const Vec3<N>& w) {
  const N x = v.y * w.z - v.z * w.y;
  const N y = v.z * w.x - v.x * w.z;
  const N z = v.x * w.y - v.y * w.x;
  return u.x * x + u.y * y + u.z * z;
}

/// Six times the signed volume of the tetrahedron a b c x: det(b−a, c−a, x−a), in cubed units of the input.
/// Positive for (0,0,0), (1,0,0), (0,1,0), (0,0,1). `x` is a point, or a direction: then the volume of
/// a b c (a+d), which has the sign of the volume of a b c (a+λd) for every λ > 0.
template <class N, class X>
N signed_volume(const Point3& a, const Point3& b, const Point3& c, const X& x) {
  const Vec3<N> o = lift<N>(a);
  return det3<N>(arm<N>(o, b), arm<N>(o, c), arm<N>(o, x));
}

/// Twice the signed area of the triangle a b x after dropping one axis.
template <class N, class X>
N signed_area(Axis dropped, const Point3& a, const Point3& b, const X& x) {
  const Vec3<N> o = lift<N>(a);
  const Vec2<N> f = project<N>(arm<N>(o, b), dropped);
  const Vec2<N> g = project<N>(arm<N>(o, x), dropped);
  return f.u * g.v - f.v * g.u;
}

/// Signed length from a to x along one axis.
template <class N, class X>
N signed_length(Axis axis, const Point3& a, const X& x) {
  const Vec3<N> o = lift<N>(a);
  const Vec3<N> g = arm<N>(o, x);
  return coordinate<N>(g, axis);
}

}  // namespace tribunal
