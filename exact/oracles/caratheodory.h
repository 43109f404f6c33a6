// An oracle that shares no formulation with Segura–Feito: probe and triangle meet iff the origin lies in the convex
// hull of their differences. By Carathéodory's theorem it does iff it lies in the hull of some one to four of them that
// are linearly dependent in just one way; so all subsets are tried, with no case for degeneracy. Source: Carathéodory,
// "Über den Variabilitätsbereich der Fourierschen Konstanten von positiven harmonischen Funktionen", Rendiconti del
// Circolo Matematico di Palermo 32, 1911; Ziegler, "Lectures on Polytopes", 1995, §1.6.
#pragma once

#include <array>
#include <initializer_list>
#include <span>

#include "core/query.h"
#include "core/sign.h"
#include "core/vec3.h"

namespace tribunal {

/// The hull's generators: `points` of weight summing to 1, then at most one direction of any weight ≥ 0.
template <class N>
struct Generators {
  std::array<Vec3<N>, 6> w;
  int points;
  int size;

  bool is_point(int i) const { return i < points; }
};

/// T − S for a segment: all six differences are points.
template <class N>
Generators<N> differences(const Segment& s, const Triangle& t) {
  const Vec3<N> p = lift<N>(s.p), q = lift<N>(s.q);
  const Vec3<N> a = lift<N>(t.a), b = lift<N>(t.b), c = lift<N>(t.c);
  return {{a - p, b - p, c - p, a - q, b - q, c - q}, 6, 6};
}

/// T − o + cone(−d) for a ray.
template <class N>
Generators<N> differences(const Ray& r, const Triangle& t) {
  const Vec3<N> o = lift<N>(r.o), d = lift<N>(r.d.v);
  const Vec3<N> zero = o - o;
  return {{lift<N>(t.a) - o, lift<N>(t.b) - o, lift<N>(t.c) - o, zero - d, zero, zero}, 3, 4};
}

namespace caratheodory_detail {

template <class N>
Vec3<N> cross_product(const Vec3<N>& u, const Vec3<N>& v) {
  return {N(u.y * v.z - u.z * v.y), N(u.z * v.x - u.x * v.z), N(u.x * v.y - u.y * v.x)};
}

template <class N>
std::array<Sign, 3> signs(const Vec3<N>& u) {
  return {sign_of(u.x), sign_of(u.y), sign_of(u.z)};
}

/// The coefficients of the one dependency, known up to a common factor: a convex combination iff none has the
/// opposite sign of another, not all vanish, and a point takes part.
inline bool is_convex(std::initializer_list<Sign> coefficients, std::initializer_list<bool> of_point) {
  bool positive = false, negative = false, point = false;
  auto is_point = of_point.begin();
  for (const Sign s : coefficients) {
    positive |= s == Sign::positive;
    negative |= s == Sign::negative;
    point |= s != Sign::zero && *is_point;
    ++is_point;
  }
  return positive != negative && point;
}

template <class N>
bool one(const Generators<N>& g, int i) {
  return g.is_point(i) && signs(g.w[i]) == std::array{Sign::zero, Sign::zero, Sign::zero};
}

/// u and v parallel: λ·u + μ·v = 0 with (λ, μ) ∝ (v_i, −u_i) on any axis.
template <class N>
bool two(const Generators<N>& g, int i, int j) {
  const auto u = signs(g.w[i]), v = signs(g.w[j]);
  const auto x = signs(cross_product(g.w[i], g.w[j]));
  if (x != std::array{Sign::zero, Sign::zero, Sign::zero}) return false;
  for (int axis = 0; axis < 3; ++axis) {
    if (is_convex({v[axis], -u[axis]}, {g.is_point(i), g.is_point(j)})) return true;
  }
  return false;
}

/// In one plane through the origin: the coefficients are the cross products of the other two, on any axis.
template <class N>
bool three(const Generators<N>& g, int i, int j, int k) {
  const auto x = signs(cross_product(g.w[j], g.w[k])), y = signs(cross_product(g.w[k], g.w[i])),
             z = signs(cross_product(g.w[i], g.w[j]));
  for (int axis = 0; axis < 3; ++axis) {
    if (is_convex({x[axis], y[axis], z[axis]}, {g.is_point(i), g.is_point(j), g.is_point(k)})) return true;
  }
  return false;
}

/// The signs of all determinants det(wᵢ, wⱼ, wₖ), i < j < k; each serves three subsets of four.
class Determinants {
 public:
  template <class N>
  explicit Determinants(const Generators<N>& g) {
    for (int j = 1; j < g.size; ++j) {
      for (int k = j + 1; k < g.size; ++k) {
        const Vec3<N> x = cross_product(g.w[j], g.w[k]);
        for (int i = 0; i < j; ++i) {
          signs_[i][j][k] = sign_of(N(g.w[i].x * x.x + g.w[i].y * x.y + g.w[i].z * x.z));
        }
      }
    }
  }
  Sign operator()(int i, int j, int k) const { return signs_[i][j][k]; }

  /// Parallel vectors i < j have determinant zero with any third.
  bool may_be_parallel(int i, int j) const {
    const Sign with_third = i > 0 ? signs_[0][i][j] : j > 1 ? signs_[0][1][j] : signs_[0][1][2];
    return with_third == Sign::zero;
  }

 private:
  Sign signs_[6][6][6]{};
};

/// Four vectors of space: the coefficients are the alternating determinants of the other three.
template <class N>
bool four(const Generators<N>& g, const Determinants& det, int i, int j, int k, int l) {
  return is_convex({det(j, k, l), -det(i, k, l), det(i, j, l), -det(i, j, k)},
                   {g.is_point(i), g.is_point(j), g.is_point(k), g.is_point(l)});
}

}  // namespace caratheodory_detail

/// Whether the closed probe and the closed triangle meet. N must be exact for these operands. Cost: 20 determinants,
/// and cross products where some of them vanish; there is no early way out, which is the point.
template <class N, class P>
bool meets_by_caratheodory(const P& probe, const Triangle& t) {
  namespace detail = caratheodory_detail;
  const Generators<N> g = differences<N>(probe, t);
  const detail::Determinants det(g);
  for (int i = 0; i < g.size; ++i) {
    if (detail::one(g, i)) return true;
    for (int j = i + 1; j < g.size; ++j) {
      if (det.may_be_parallel(i, j) && detail::two(g, i, j)) return true;
      for (int k = j + 1; k < g.size; ++k) {
        if (det(i, j, k) == Sign::zero && detail::three(g, i, j, k)) return true;
        for (int l = k + 1; l < g.size; ++l) {
          if (detail::four(g, det, i, j, k, l)) return true;
        }
      }
    }
  }
  return false;
}

}  // namespace tribunal
