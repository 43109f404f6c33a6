// The watertight test of Woop, Benthin and Wald: a shear that takes the ray to the z-axis, then three edge functions in
// two dimensions, computed again in double where one of them is zero.
// Source: Woop, Benthin & Wald, "Watertight Ray/Triangle Intersection", Journal of Computer Graphics Techniques 2(1),
// 2013, appendix A, without culling.
#pragma once

#include <utility>

#include "core/rivals/rival.h"

namespace tribunal::published {

template <class N>
struct Woop {
  using Number = N;
  using Prepared = Corners<N>;
  static constexpr RivalCard card{"shear to the z-axis, 2D edge functions; zero ones again in double",
                                  "Woop et al. 2013"};
  static constexpr Contract contract{.triangles = Triangles::proper, .convention = Convention::transversal};

  /// The axes, z being that on which the direction is longest, and the shear.
  struct PreparedRay {
    Vec3<N> o;
    Axis x, y, z;
    N shear_x, shear_y, scale_z;
  };

  static PreparedRay prepare_ray(const Vec3<N>& o, const Vec3<N>& d) {
    const Axis z = longest_axis(d);
    Axis x = after(z), y = after(x);
    const N depth = coordinate(d, z);
    if (depth < 0) std::swap(x, y);
    return {o, x, y, z, coordinate(d, x) / depth, coordinate(d, y) / depth, 1 / depth};
  }

  static std::optional<RivalHit<N>> meet(const PreparedRay& r, const N& t_max, const Prepared& t) {
    const Vec3<N> a = t.a - r.o, b = t.b - r.o, c = t.c - r.o;
    const Vec2<N> fa = sheared(a, r), fb = sheared(b, r), fc = sheared(c, r);
    N u = edge<N>(fc, fb), v = edge<N>(fa, fc), w = edge<N>(fb, fa);
    if (u == 0 || v == 0 || w == 0) {
      u = edge<Wider>(fc, fb);
      v = edge<Wider>(fa, fc);
      w = edge<Wider>(fb, fa);
    }
    if ((u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0)) return std::nullopt;
    const N det = u + v + w;
    if (det == 0) return std::nullopt;
    const N num = u * (r.scale_z * coordinate(a, r.z)) + v * (r.scale_z * coordinate(b, r.z)) +
                  w * (r.scale_z * coordinate(c, r.z));
    const bool flipped = sign_bit(det);
    const N ahead = flipped ? N(-num) : num;
    if (ahead < 0 || ahead > t_max * absolute(det)) return std::nullopt;
    const N inverse = 1 / det;
    return RivalHit<N>{num * inverse, Weights<N>{v * inverse, w * inverse}};
  }

 private:
  /// The paper's fallback is for float. Other types have no wider one here.
  using Wider = std::conditional_t<std::is_same_v<N, float>, double, N>;

  static Axis after(Axis axis) { return all_axes[(static_cast<int>(axis) + 1) % 3]; }

  static Vec2<N> sheared(const Vec3<N>& v, const PreparedRay& r) {
    const N depth = coordinate(v, r.z);
    return {coordinate(v, r.x) - r.shear_x * depth, coordinate(v, r.y) - r.shear_y * depth};
  }

  template <class M>
  static N edge(const Vec2<N>& f, const Vec2<N>& g) {
    return static_cast<N>(static_cast<M>(f.u) * static_cast<M>(g.v) - static_cast<M>(f.v) * static_cast<M>(g.u));
  }
};

}  // namespace tribunal::published
