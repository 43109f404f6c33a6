// The Möller–Trumbore test: solve o + t·d = (1−u−v)·a + u·b + v·c by Cramer's rule, divide, compare.
// Source: Möller & Trumbore, "Fast, Minimum Storage Ray/Triangle Intersection", Journal of Graphics Tools 2(1), 1997,
// doi:10.1080/10867651.1997.10487468, equation (6) and the two branches of its code.
#pragma once

#include "core/rivals/rival.h"

namespace tribunal::published {

/// The system of equation (4): the edges from a, its determinant, and the cross product that the determinant is made
/// of.
template <class N>
struct MoellerTrumboreSystem {
  Vec3<N> e1, e2, pvec;
  N det;

  MoellerTrumboreSystem(const Vec3<N>& d, const Corners<N>& t)
      : e1(t.b - t.a), e2(t.c - t.a), pvec(cross(d, e2)), det(dot(e1, pvec)) {}
};

/// The two-sided branch with 0 in place of its tolerance on the determinant: a line parallel to the plane (determinant
/// exactly 0 in N) meets nothing.
template <class N>
struct MoellerTrumbore {
  using Number = N;
  using Prepared = Corners<N>;
  static constexpr RivalCard card{"Cramer's rule, one division, coordinates compared with 0 and 1",
                                  "Möller & Trumbore 1997"};
  static constexpr Contract contract{.convention = Convention::transversal};

  static std::optional<RivalHit<N>> meet(const Vec3<N>& origin, const Vec3<N>& d, const Prepared& t) {
    const MoellerTrumboreSystem<N> system(d, t);
    if (system.det == 0) return std::nullopt;
    return divided(origin - t.a, d, system);
  }

  static std::optional<RivalHit<N>> divided(const Vec3<N>& tvec, const Vec3<N>& d,
                                            const MoellerTrumboreSystem<N>& system) {
    const N inverse = 1 / system.det;
    const N u = dot(tvec, system.pvec) * inverse;
    if (!(u >= 0 && u <= 1)) return std::nullopt;
    const Vec3<N> qvec = cross(tvec, system.e1);
    const N v = dot(d, qvec) * inverse;
    if (!(v >= 0 && u + v <= 1)) return std::nullopt;
    return RivalHit<N>{dot(system.e2, qvec) * inverse, Weights<N>{u, v}};
  }
};

/// The tolerance of the printed code on the determinant, which has the dimension of a volume.
inline constexpr double moeller_trumbore_epsilon = 1e-6;

/// The two-sided branch as printed.
template <class N>
struct MoellerTrumborePrinted : MoellerTrumbore<N> {
  static constexpr RivalCard card{"as printed: a determinant below 1e-6 is called parallel", "Möller & Trumbore 1997"};

  static std::optional<RivalHit<N>> meet(const Vec3<N>& origin, const Vec3<N>& d, const Corners<N>& t) {
    const MoellerTrumboreSystem<N> system(d, t);
    const N epsilon = static_cast<N>(moeller_trumbore_epsilon);
    if (system.det > -epsilon && system.det < epsilon) return std::nullopt;
    return MoellerTrumbore<N>::divided(origin - t.a, d, system);
  }
};

/// The branch with culling, as printed: the division comes last.
template <class N>
struct MoellerTrumboreCulling : MoellerTrumbore<N> {
  static constexpr RivalCard card{"as printed, one-sided: a determinant below 1e-6 is culled, the division comes last",
                                  "Möller & Trumbore 1997"};
  static constexpr Contract contract{.convention = Convention::transversal, .culling = Culling::back_faces};

  static std::optional<RivalHit<N>> meet(const Vec3<N>& origin, const Vec3<N>& d, const Corners<N>& t) {
    const MoellerTrumboreSystem<N> system(d, t);
    const N& det = system.det;
    if (det < static_cast<N>(moeller_trumbore_epsilon)) return std::nullopt;
    const Vec3<N> tvec = origin - t.a;
    const N u = dot(tvec, system.pvec);
    if (u < 0 || u > det) return std::nullopt;
    const Vec3<N> qvec = cross(tvec, system.e1);
    const N v = dot(d, qvec);
    if (v < 0 || u + v > det) return std::nullopt;
    const N inverse = 1 / det;
    return RivalHit<N>{dot(system.e2, qvec) * inverse, Weights<N>{u * inverse, v * inverse}};
  }
};

}  // namespace tribunal::published
