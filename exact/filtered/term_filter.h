// The second filter: where the bound by the largest magnitude on each axis is too wide, one by the terms themselves.
//
// The bound of filter_bounds.h takes the largest arm on each axis for all arms. It is wide where long arms meet short
// ones: a small triangle far from the eye. Here the bound is K·T, where T is the sum of the magnitudes of the six terms
// uᵢ·vⱼ·wₖ of det(u, v, w), and for each edge the short arm is the edge itself.
//
// Proof. A term passes eight roundings on its way into det3: one in each of its arms, the product of two of them, the
// minor's difference, the product with the third, and at most two in the sum of three products, the first term's;
// so at most 3 + 1 + 1 + 1 + 2 = 8. T is computed from the same rounded arms with at most five roundings and the bound
// with two more. terms.g proves that then no term is off by more than 8 units of its share of T (Higham, "Accuracy and
// Stability of Numerical Algorithms", 2002, Lemma 3.1, has the argument); 9 are taken. Underflow and overflow:
// terms_range.g. A test counts the roundings in the lines below. Source of the idea: Shewchuk, "Adaptive Precision
// Floating-Point Arithmetic and Fast Robust Geometric Predicates", DCG 18, 1997, whose constant for rounding to nearest
// is 7 + 56ε.
#pragma once

#include <optional>

#include "exact/filtered/filter.h"

namespace tribunal::detail {

/// A determinant as computed, and the sum of the magnitudes of its terms.
template <class N>
struct Expansion {
  N value, terms;
};

template <class N>
Expansion<N> expanded(const Vec3<N>& u, const Vec3<N>& v, const Vec3<N>& w) {
  const auto minor = [](const N& a, const N& b, const N& c, const N& d) {
    return N(magnitude(N(a * b)) + magnitude(N(c * d)));
  };
  const N x = minor(v.y, w.z, v.z, w.y), y = minor(v.z, w.x, v.x, w.z), z = minor(v.x, w.y, v.y, w.x);
  return {det3(u, v, w), N(N(magnitude(u.x) * x) + N(magnitude(u.y) * y) + N(magnitude(u.z) * z))};
}

template <class N>
std::optional<Sign> sign_of(const Expansion<N>& e, const FilterConstants<N>& c) {
  return sign_beyond<N>(e.value, N(c.k * e.terms) + c.tiny);
}

/// The sign of det(u, v, w) of three arms, each coordinate rounded at most once.
template <class N>
std::optional<Sign> filter_terms(const Vec3<N>& u, const Vec3<N>& v, const Vec3<N>& w, const FilterConstants<N>& c) {
  if (!in_range(largest(u, v, w), c)) return std::nullopt;
  return sign_of(expanded(u, v, w), c);
}

/// The sign of orient3d(a, b, p, x), if certain.
template <class N, class X>
std::optional<Sign> filter_orient3d_by_terms(const Point3& a, const Point3& b, const Point3& p, const X& x,
                                             const FilterConstants<N>& c) {
  const Vec3<N> o = lift<N>(a);
  return filter_terms(arm<N>(o, b), arm<N>(o, p), arm<N>(o, x), c);
}

/// The three minors of two arms, which make the normal of their plane, and the sum of the magnitudes of each one's
/// terms.
template <class N>
struct Minors {
  Vec3<N> value, terms;
};

template <class N>
Minors<N> minors_of(const Vec3<N>& u, const Vec3<N>& v) {
  const N x[] = {u.y * v.z, u.z * v.y}, y[] = {u.z * v.x, u.x * v.z}, z[] = {u.x * v.y, u.y * v.x};
  return {{N(x[0] - x[1]), N(y[0] - y[1]), N(z[0] - z[1])},
          {N(magnitude(x[0]) + magnitude(x[1])), N(magnitude(y[0]) + magnitude(y[1])),
           N(magnitude(z[0]) + magnitude(z[1]))}};
}

/// det(u, v, w) by the minors of u and v. The third arm comes last instead of first, which changes nothing in the count
/// of roundings.
template <class N>
Expansion<N> expanded(const Minors<N>& m, const Vec3<N>& w) {
  return {N(m.value.x * w.x + m.value.y * w.y + m.value.z * w.z),
          N(m.terms.x * magnitude(w.x) + m.terms.y * magnitude(w.y) + m.terms.z * magnitude(w.z))};
}

/// The filter of orient3d(a, b, c, x) for one triangle and many x: the minors are computed once.
class PlaneFilter {
 public:
  explicit PlaneFilter(const Triangle& t) : a_(lift<double>(t.a)) {
    const Vec3<double> u = arm<double>(a_, t.b), v = arm<double>(a_, t.c);
    minors_ = minors_of(u, v);
    in_range_ = in_range(largest(u, v), volume_terms_filter);
  }

  /// The sign for a point or a direction x; nothing where rounding could matter.
  template <class X>
  std::optional<Sign> side(const X& x) const {
    const Vec3<double> w = arm<double>(a_, x);
    if (!in_range_ || !in_range(w, volume_terms_filter)) return std::nullopt;
    return sign_of(expanded(minors_, w), volume_terms_filter);
  }

 private:
  Vec3<double> a_;
  Minors<double> minors_;
  bool in_range_;
};

/// Whether the probe certainly meets or certainly misses the triangle, in general position; else nothing.
/// Unlike filter_hits it asks sign by sign and stops at the first two that decide: both ends on one side of the plane,
/// or two edges passed on different sides. An edge ab is passed on the side of det(a − p, b − a, d), which is
/// orient3d(p, a, b, q), as adding one column to another changes nothing.
template <class N, class P>
std::optional<bool> filter_hits_by_terms(const P& probe, const Triangle& t, const FilterConstants<N>& c) {
  const Vec3<N> p = lift<N>(source(probe)), corner[] = {lift<N>(t.a), lift<N>(t.b), lift<N>(t.c)};
  const Vec3<N> u = corner[1] - corner[0], v = corner[2] - corner[0], d = arm<N>(p, target(probe));
  const auto from = filter_terms(u, v, p - corner[0], c);
  const auto to = filter_terms(u, v, arm<N>(corner[0], target(probe)), c);
  if (from && to && *from == *to) return false;
  std::optional<Sign> passed;
  bool all = true;
  for (int i = 0; i < 3; ++i) {
    const Vec3<N>&a = corner[i], &b = corner[(i + 1) % 3];
    const auto side = filter_terms(a - p, b - a, d, c);
    if (side && passed && *side != *passed) return false;
    if (side) passed = side;
    all &= side.has_value();
  }
  if (!all || !from || !to) return std::nullopt;
  return true;
}

/// The order of two hits along one ray, like filter_compare_hits. Each factor of n₁·d₂ − n₂·d₁ is off by at most 8
/// units of its terms, so a product by 8 + 8 + 1 units of the product of terms, and the difference by one more: 18
/// (terms.g), and 21 are taken.
template <class N>
std::optional<Sign> filter_compare_hits_by_terms(const Ray& r, const Triangle& s, const Triangle& t,
                                                 const FilterConstants<N>& order, const FilterConstants<N>& volume) {
  struct Hit {
    Expansion<N> height, gain;  ///< det(u, v, o − a) and det(u, v, d); the hit is at −height/gain
    bool in_range;
  };
  const auto hit = [&](const Triangle& x) {
    const Vec3<N> a = lift<N>(x.a), u = arm<N>(a, x.b), v = arm<N>(a, x.c), w = arm<N>(a, r.o), d = lift<N>(r.d.v);
    return Hit{expanded(u, v, w), expanded(u, v, d), in_range(largest(u, v, w, d), order)};
  };
  const Hit f = hit(s), g = hit(t);
  const N difference = N(g.height.value * f.gain.value) - N(f.height.value * g.gain.value);
  const N terms = N(g.height.terms * f.gain.terms) + N(f.height.terms * g.gain.terms);
  const auto sign = sign_beyond<N>(difference, N(order.k * terms) + order.tiny);
  const auto first = sign_of(f.gain, volume), second = sign_of(g.gain, volume);
  if (!f.in_range || !g.in_range || !sign || !first || !second) return std::nullopt;
  return *sign * *first * *second;
}

}  // namespace tribunal::detail
