// Kernels with bugs that show only where numbers leave the middle of the range.
#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <cmath>

#include "core/kernel.h"
#include "exact/kernels/dyadic.h"
#include "exact/methods/cgal_kernels.h"

namespace tribunal::planted {

/// Whether x − y is exact in doubles, by Two-Sum. An infinite difference has the error NaN, which is neither positive
/// nor negative: unless `guarded` it passes, and that is the bug.
template <bool guarded>
bool is_exact_difference(double x, double y) {
  const double difference = x - y;
  const double y_part = x - difference;
  const double error = (x - (difference + y_part)) + (y_part - y);
  return guarded ? error == 0 : !(error > 0 || error < 0);
}

/// Computes determinants exactly where all differences are exact in double, and by EPICK elsewhere.
template <bool guarded>
struct ExactDifferences : EpickKernel {
  using EpickKernel::orient3d;
  Sign orient3d(const Point3& a, const Point3& b, const Point3& c, const Point3& x) const {
    for (const Point3* p : {&b, &c, &x}) {
      for (int axis = 0; axis < 3; ++axis) {
        if (!is_exact_difference<guarded>((*p)[axis], a[axis])) return EpickKernel::orient3d(a, b, c, x);
      }
    }
    const Point3 u = b - a, v = c - a, w = x - a;
    if (!is_finite(u) || !is_finite(v) || !is_finite(w)) return sign_of(signed_volume<double>(a, b, c, x));
    return sign_of(det3<Dyadic>(lift<Dyadic>(u), lift<Dyadic>(v), lift<Dyadic>(w)));
  }
};

/// A number m·2^e that keeps the leading `window` bits of m and drops the others.
template <long window>
class Windowed {
 public:
  Windowed() = default;
  explicit Windowed(double x) {
    int e = 0;
    m_ = std::ldexp(std::frexp(x, &e), 53);
    e_ = e - 53;
  }

  friend Windowed operator+(const Windowed& a, const Windowed& b) {
    if (sgn(a.m_) == 0) return b;
    if (sgn(b.m_) == 0) return a;
    const long low = std::min(a.e_, b.e_);
    return Windowed(a.aligned_to(low) + b.aligned_to(low), low);
  }
  friend Windowed operator-(const Windowed& a, const Windowed& b) { return a + Windowed(-b.m_, b.e_); }
  friend Windowed operator*(const Windowed& a, const Windowed& b) { return Windowed(a.m_ * b.m_, a.e_ + b.e_); }
  friend Sign sign_of(const Windowed& a) { return static_cast<Sign>(sgn(a.m_)); }

 private:
  Windowed(const mpz_class& m, long e) : m_(m), e_(e) {
    const long excess = static_cast<long>(mpz_sizeinbase(m_.get_mpz_t(), 2)) - window;
    if (excess <= 0) return;
    m_ /= mpz_class(1) << static_cast<unsigned long>(excess);
    e_ += excess;
  }
  mpz_class aligned_to(long low) const { return m_ << static_cast<unsigned long>(e_ - low); }

  mpz_class m_ = 0;
  long e_ = 0;
};

}  // namespace tribunal::planted
