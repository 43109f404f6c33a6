// Where a ray meets a plane, by another formula over GMP's fractions, and rounded by MPFR: an oracle that shares no
// code with what is on trial.
#pragma once

#include <gmpxx.h>
#include <mpfr.h>

#include "core/operands.h"

namespace tribunal::testing {

/// The exact parameter t = (a − o)·n / (d·n) at which a ray meets the plane of a triangle, where n = (b − a) × (c −
/// a) and d·n ≠ 0.
struct ExactParameter {
  ExactParameter(const Ray& r, const Triangle& t) {
    mpq_class n[3];
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      n[i] = difference(t.b, t.a, j) * difference(t.c, t.a, k) - difference(t.b, t.a, k) * difference(t.c, t.a, j);
    }
    mpq_class distance, speed;
    for (int i = 0; i < 3; ++i) {
      distance += difference(t.a, r.o, i) * n[i];
      speed += mpq_class(r.d.v[i]) * n[i];
    }
    parallel = sgn(speed) == 0;
    if (!parallel) value = distance / speed;
  }

  static mpq_class difference(const Point3& p, const Point3& q, int axis) {
    return mpq_class(p[axis]) - mpq_class(q[axis]);
  }

  /// The parameter rounded to nearest, ties to even, with gradual underflow and overflow to infinity.
  double rounded() const {
    mpfr_set_emin(-1073);
    mpfr_set_emax(1024);
    mpfr_t x;
    mpfr_init2(x, 53);
    const int ternary = mpfr_set_q(x, value.get_mpq_t(), MPFR_RNDN);
    mpfr_subnormalize(x, ternary, MPFR_RNDN);
    const double result = mpfr_get_d(x, MPFR_RNDN);
    mpfr_clear(x);
    return result;
  }

  bool parallel = true;
  mpq_class value;
};

}  // namespace tribunal::testing
