// Axis-parallel boxes, and the test that never loses a ray or segment which exactly meets one.
//
// Derivation. A probe is x(t) = o + t·d, t in [0, t_end]: rays have t_end = ∞ and d as given, segments t_end = 1 and
// d = q − o, which need not be a binary64 number. In one axis with d > 0 (d < 0 is its mirror image) the closed slab
// [lo, hi] holds x(t) iff T_in ≤ t ≤ T_out with T_in = (lo − o)/d and T_out = (hi − o)/d. We compute L ≤ T_in and
// U ≥ T_out. Then wherever the exact intervals of the three axes and [0, t_end] have a common point, the computed ones
// have it too: a box that is exactly met is never lost, whatever the operands.
//
// The whole proof rests on one law. For x real, and fl(x) its rounding to nearest with overflow to ±∞ and gradual
// underflow: below(fl(x)) ≤ x ≤ above(fl(x)), where below and above step to the neighbouring binary64 number. It
// holds because x lies within half a gap of fl(x) if fl(x) is finite; if fl(x) = +∞, then x > DBL_MAX = below(+∞).
// No unit roundoff appears, hence no range in which the bound would fail.
//  · n = below(fl(lo − o)) ≤ lo − o, and n < +∞. With 0 ≤ d⁻ ≤ d ≤ d⁺ (for a ray all equal; for a segment one step
//    about fl(q − o), whose sign is exact, because a difference of two binary64 numbers underflows to no zero):
//    n/d ≥ n/d⁺ if n ≥ 0, and n/d ≥ n/d⁻ if n < 0, so L = below(fl(n/d^±)) ≤ T_in.
//  · No NaN: 0/0 cannot be, for d⁻ divides nonzero numbers only and d⁺ > 0; ∞/∞ cannot, for d⁺ = +∞ divides only
//    n ∈ [0, DBL_MAX], and n = −∞ is divided by d⁻ ≤ DBL_MAX. n/0 = −∞ is a true bound. T_out is the mirror image.
//  · d = 0 (of either sign) is no division at all: the axis holds all t if lo ≤ o ≤ hi, else none. Here 0·∞ of the
//    textbook test would lose rays that run in a face of the box.
// Price: the interval is wider than the exact one by at most 6u relative (u = 2⁻⁵³), plus two subnormal gaps.
// Compare Ize, "Robust BVH Ray Traversal", JCGT 2(2), 2013, who widens the far side by 2 ulps, where none is infinite.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>

#include "core/polygon.h"

namespace tribunal {

/// The closed box [lo, hi]; empty until something is added.
struct Box {
  Point3 lo{std::numeric_limits<double>::infinity()};
  Point3 hi{-std::numeric_limits<double>::infinity()};

  void add(const Point3& p) {
    for (int i = 0; i < 3; ++i) {
      lo[i] = std::min(lo[i], p[i]);
      hi[i] = std::max(hi[i], p[i]);
    }
  }
  void add(const Box& b) {
    add(b.lo);
    add(b.hi);
  }
};

inline Box box_of(const Triangle& t) {
  Box b;
  for (const Point3& v : {t.a, t.b, t.c}) b.add(v);
  return b;
}

inline Box box_of(const Polygon& polygon) {
  Box b;
  for (const Point3& v : polygon.vertices) b.add(v);
  return b;
}

/// The next binary64 number above x; +∞ stays. x is no NaN.
inline double above(double x) {
  if (x == std::numeric_limits<double>::infinity()) return x;
  if (x == 0) return std::numeric_limits<double>::denorm_min();
  const std::uint64_t bits = std::bit_cast<std::uint64_t>(x);
  return std::bit_cast<double>(x > 0 ? bits + 1 : bits - 1);
}

inline double below(double x) { return -above(-x); }

/// Bounds of the parameters at which a probe may be in a box: empty if last < first.
struct Span {
  double first, last;
  bool empty() const { return last < first; }
};

/// A ray or segment made ready for box tests.
class BoxProbe {
 public:
  explicit BoxProbe(const Ray& r) : BoxProbe(r.o, std::numeric_limits<double>::infinity()) {
    for (int i = 0; i < 3; ++i) set(i, r.d.v[i], r.d.v[i], r.d.v[i]);
  }

  explicit BoxProbe(const Segment& s) : BoxProbe(s.p, 1) {
    for (int i = 0; i < 3; ++i) {
      const double d = s.q[i] - s.p[i];
      set(i, d, below(d), above(d));
    }
  }

  /// Contains every t at which the probe is in the closed box.
  Span span(const Box& b) const {
    Span s{0, end_};
    for (const Axis& a : axes_) {
      const int i = static_cast<int>(&a - axes_);
      if (a.direction == 0) {
        if (a.o < b.lo[i] || b.hi[i] < a.o) return {1, 0};
      } else if (a.direction > 0) {
        narrow(s, a, b.lo[i] - a.o, b.hi[i] - a.o);
      } else {
        narrow(s, a, a.o - b.hi[i], a.o - b.lo[i]);
      }
      if (s.empty()) return s;
    }
    return s;
  }

 private:
  struct Axis {
    double o;
    int direction;           ///< sign of d
    double least, greatest;  ///< d⁻ ≤ |d| ≤ d⁺
  };

  BoxProbe(const Point3& o, double end) : axes_{{o.x, 0, 0, 0}, {o.y, 0, 0, 0}, {o.z, 0, 0, 0}}, end_(end) {}

  void set(int i, double d, double lo, double hi) {
    axes_[i].direction = (d > 0) - (d < 0);
    axes_[i].least = d > 0 ? lo : -hi;
    axes_[i].greatest = d > 0 ? hi : -lo;
  }

  /// `in` and `out` are the rounded distances along the axis to the near and the far side.
  static void narrow(Span& s, const Axis& a, double in, double out) {
    const double n = below(in);
    const double f = above(out);
    s.first = std::max(s.first, below(n / (n < 0 ? a.least : a.greatest)));
    s.last = std::min(s.last, above(f / (f > 0 ? a.least : a.greatest)));
  }

  Axis axes_[3];
  double end_;
};

}  // namespace tribunal
