// An oracle that shares no formulation with Segura–Feito: probe and triangle meet iff the origin lies in the convex
// hull of their differences. By Carathéodory's theorem it does iff it lies in the hull of some one to four of them that
// are linearly dependent in just one way; so all subsets are tried, with no case for degeneracy. Source: Carathéodory,
// "Über den Variabilitätsbereich der Fourierschen Konstanten von positiven harmonischen Funktionen", Rendiconti del
// Circolo Matematico di Palermo 32, 1911; Ziegler, "Lectures on Polytopes", 1995, §1.6.
#pragma once

#include <array>

#include "core/operands.h"
#include "core/sign.h"
#include "core/vec3.h"

namespace tribunal {

/// The hull's generators: `points` of weight summing to 1, then at most one direction of any weight ≥ 0.
template <class N, int points, int size>
struct Generators {
  std::array<Vec3<N>, size> w;

  static constexpr bool is_point(int i) { return i < points; }
};

/// T − S for a segment: all six differences are points.
template <class N>
Generators<N, 6, 6> differences(const Segment& s, const Triangle& t) {
  const Vec3<N> p = lift<N>(s.p), q = lift<N>(s.q);
  const Vec3<N> a = lift<N>(t.a), b = lift<N>(t.b), c = lift<N>(t.c);
  return {{a - p, b - p, c - p, a - q, b - q, c - q}};
}

/// T − o + cone(−d) for a ray.
template <class N>
Generators<N, 3, 4> differences(const Ray& r, const Triangle& t) {
  const Vec3<N> o = lift<N>(r.o), d = lift<N>(r.d.v);
  const Vec3<N> zero = o - o;
  return {{lift<N>(t.a) - o, lift<N>(t.b) - o, lift<N>(t.c) - o, zero - d}};
}

/// The exact point o + t·d.
template <class N>
Vec3<N> point_of(const RayPoint& x) {
  const Vec3<N> o = lift<N>(x.ray.o), d = lift<N>(x.ray.d.v);
  const N t(x.t);
  return {N(o.x + t * d.x), N(o.y + t * d.y), N(o.z + t * d.z)};
}

/// The same for parts of a ray, from the points at which they end.
template <class N>
Generators<N, 6, 6> differences(const Stretch& s, const Triangle& t) {
  const Vec3<N> p = point_of<N>(source(s)), q = point_of<N>(target(s));
  const Vec3<N> a = lift<N>(t.a), b = lift<N>(t.b), c = lift<N>(t.c);
  return {{a - p, b - p, c - p, a - q, b - q, c - q}};
}

template <class N>
Generators<N, 3, 4> differences(const Tail& s, const Triangle& t) {
  const Vec3<N> o = point_of<N>(source(s)), d = lift<N>(s.ray.d.v);
  const Vec3<N> zero = o - o;
  return {{lift<N>(t.a) - o, lift<N>(t.b) - o, lift<N>(t.c) - o, zero - d}};
}

namespace caratheodory_detail {

/// Whether a dependency is a convex combination. Its coefficients are known up to a common factor: none may have the
/// opposite sign of another, not all vanish, and a point takes part.
class Combination {
 public:
  void add(Sign coefficient, bool is_point) {
    positive_ |= coefficient == Sign::positive;
    negative_ |= coefficient == Sign::negative;
    point_ |= is_point && coefficient != Sign::zero;
  }
  bool is_convex() const { return positive_ != negative_ && point_; }

 private:
  bool positive_ = false, negative_ = false, point_ = false;
};

/// The signs that all dependencies of one to four generators are read from: of coordinates, cross products and
/// determinants, computed once each.
template <class N, int points, int size>
class Dependencies {
 public:
  explicit Dependencies(const Generators<N, points, size>& g) {
    for (int j = 0; j < size; ++j) {
      coordinates_[j] = signs(g.w[j]);
      for (int k = j + 1; k < size; ++k) {
        const Vec3<N>&u = g.w[j], &v = g.w[k];
        const Vec3<N> x{N(u.y * v.z - u.z * v.y), N(u.z * v.x - u.x * v.z), N(u.x * v.y - u.y * v.x)};
        cross_[j][k] = signs(x);
        for (int i = 0; i < j; ++i) det_[i][j][k] = sign_of(N(g.w[i].x * x.x + g.w[i].y * x.y + g.w[i].z * x.z));
      }
    }
  }

  bool one(int i) const { return is_point(i) && coordinates_[i] == none; }

  /// u and v parallel: λ·u + μ·v = 0 with (λ, μ) ∝ (v_x, −u_x) on any axis.
  bool two(int i, int j) const {
    if (cross_[i][j] != none) return false;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      Combination c;
      c.add(coordinates_[j][axis], is_point(i));
      c.add(-coordinates_[i][axis], is_point(j));
      if (c.is_convex()) return true;
    }
    return false;
  }

  /// In one plane through the origin: the coefficients are the cross products of the other two, on any axis.
  bool three(int i, int j, int k) const {
    if (det_[i][j][k] != Sign::zero) return false;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      Combination c;
      c.add(cross_[j][k][axis], is_point(i));
      c.add(-cross_[i][k][axis], is_point(j));
      c.add(cross_[i][j][axis], is_point(k));
      if (c.is_convex()) return true;
    }
    return false;
  }

  /// Four vectors of space: the coefficients are the alternating determinants of the other three.
  bool four(int i, int j, int k, int l) const {
    Combination c;
    c.add(det_[j][k][l], is_point(i));
    c.add(-det_[i][k][l], is_point(j));
    c.add(det_[i][j][l], is_point(k));
    c.add(-det_[i][j][k], is_point(l));
    return c.is_convex();
  }

 private:
  using Signs = std::array<Sign, 3>;
  static constexpr Signs none{Sign::zero, Sign::zero, Sign::zero};

  static constexpr bool is_point(int i) { return Generators<N, points, size>::is_point(i); }
  static Signs signs(const Vec3<N>& u) { return {sign_of(u.x), sign_of(u.y), sign_of(u.z)}; }

  Signs coordinates_[size];
  Signs cross_[size][size];
  Sign det_[size][size][size];
};

template <class N, int points, int size>
bool spans_origin(const Generators<N, points, size>& g) {
  const Dependencies<N, points, size> d(g);
  for (int i = 0; i < size; ++i) {
    if (d.one(i)) return true;
    for (int j = i + 1; j < size; ++j) {
      if (d.two(i, j)) return true;
      for (int k = j + 1; k < size; ++k) {
        if (d.three(i, j, k)) return true;
        for (int l = k + 1; l < size; ++l) {
          if (d.four(i, j, k, l)) return true;
        }
      }
    }
  }
  return false;
}

}  // namespace caratheodory_detail

/// Whether the closed probe and the closed triangle meet. N must be exact for these operands. Cost: 20 determinants
/// and 15 cross products for a segment, always: no case is treated apart from the others.
template <class N, class P>
bool meets_by_caratheodory(const P& probe, const Triangle& t) {
  return caratheodory_detail::spans_origin(differences<N>(probe, t));
}

}  // namespace tribunal
