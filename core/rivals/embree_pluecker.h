// Embree's modified Plücker test: the ray's origin is moved to zero, and each edge is tested by sum and difference of
// its ends, so that two triangles get opposite values on the edge that they share.
// Source: Embree 2 (Intel), kernels/xeon/geometry/triangle_intersector_pluecker.h, 2015; Davidovič, Engelhardt,
// Georgiev, Slusallek & Dachsbacher, "3D Rasterization: A Bridge between Rasterization and Ray Casting", Graphics
// Interface 2012, for the edge functions. Embree 3 and later call a hit what is beside the edge by one ulp of the sum.
#pragma once

#include "core/rivals/lanes.h"

namespace tribunal::published {

template <class N>
struct EmbreePluecker {
  using Number = N;
  using Prepared = Corners<N>;
  static constexpr RivalCard card{"edge functions from the origin, by sum and difference of the ends of an edge",
                                  "Embree 2 (2015)"};
  static constexpr Contract contract{.convention = Convention::transversal};

  /// One ray against four or eight triangles in the source.
  static Found<N> meet(const Vec3<N>& o, const Vec3<N>& d, const N& t_max, const Prepared& t) {
    const Vec3<N> v0 = t.a - o, v1 = t.b - o, v2 = t.c - o;
    const Vec3<N> e0 = v2 - v0, e1 = v0 - v1, e2 = v1 - v2;
    const N u = edge(v2, v0, e0, d), v = edge(v0, v1, e1, d), w = edge(v1, v2, e2, d);
    const MaskOf<N> inside = ((u >= 0) & (v >= 0) & (w >= 0)) | ((u <= 0) & (v <= 0) & (w <= 0));
    if (none(inside)) return {};
    const Vec3<N> normal = stable_normal(e2, e1, e0);
    const N den = 2 * dot(normal, d);
    const N num = 2 * dot(v0, normal);
    const N ahead = select(sign_bit(den), N(-num), num);
    const MaskOf<N> hit = inside & (ahead >= 0) & (absolute(den) * t_max >= ahead) & (den != 0);
    if (none(hit)) return {};
    const N inverse = 1 / den;
    return {hit, num * inverse, {u * inverse, v * inverse}};
  }

 private:
  static N edge(const Vec3<N>& x, const Vec3<N>& y, const Vec3<N>& e, const Vec3<N>& d) {
    return dot(cross(Vec3<N>{x.x + y.x, x.y + y.y, x.z + y.z}, e), d);
  }

  /// One coordinate of a × b or of b × c, which are equal since a + b + c = 0: the one with the smaller subtrahend.
  static N stabler(const N& minuend_ab, const N& ab, const N& minuend_bc, const N& bc) {
    return select(absolute(ab) < absolute(bc), N(minuend_ab - ab), N(minuend_bc - bc));
  }

  static Vec3<N> stable_normal(const Vec3<N>& a, const Vec3<N>& b, const Vec3<N>& c) {
    return {stabler(a.y * b.z, a.z * b.y, b.y * c.z, b.z * c.y), stabler(a.z * b.x, a.x * b.z, b.z * c.x, b.x * c.z),
            stabler(a.x * b.y, a.y * b.x, b.x * c.y, b.y * c.x)};
  }
};

}  // namespace tribunal::published
