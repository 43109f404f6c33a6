// Numbers of twice the precision: unevaluated sums of two doubles, for bounds that one double is too coarse for.
// Sources: Dekker, "A floating-point technique for extending the available precision", Numer. Math. 18, 1971; Knuth,
// TAOCP 2, section 4.2.2; Joldes, Muller, Popescu, "Tight and rigorous error bounds for basic building blocks of
// double-word arithmetic", ACM TOMS 44(2), 2017.
#pragma once

#include <cmath>

namespace tribunal::detail {

/// The number hi + lo, where hi is that sum rounded to nearest.
///
/// Laws, in round-to-nearest and where nothing overflows. (1) Sums and differences of two numbers with lo = 0 are
/// exact. (2) Sums, differences and products are off by at most 8·2⁻¹⁰⁶ = 2⁻¹⁰³ of the exact result (proved there: 3
/// and 5, and a little), and products by some multiples of 2⁻¹⁰⁷⁴ more where a part underflows.
struct DoubleDouble {
  double hi = 0, lo = 0;

  DoubleDouble() = default;
  explicit DoubleDouble(double x) : hi(x) {}

  /// a + b, exactly.
  static DoubleDouble sum(double a, double b) {
    const double s = a + b, of_b = s - a;
    return {s, (a - (s - of_b)) + (b - of_b)};
  }
  /// a + b, exactly, where a = 0 or |a| ≥ |b|.
  static DoubleDouble quick_sum(double a, double b) {
    const double s = a + b;
    return {s, b - (s - a)};
  }
  /// a·b, exactly unless the error underflows.
  static DoubleDouble product(double a, double b) {
    const double p = a * b;
    return {p, std::fma(a, b, -p)};
  }

  friend DoubleDouble operator-(const DoubleDouble& a) { return {-a.hi, -a.lo}; }
  friend DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) {
    const DoubleDouble s = sum(a.hi, b.hi), t = sum(a.lo, b.lo), v = quick_sum(s.hi, s.lo + t.hi);
    return quick_sum(v.hi, t.lo + v.lo);
  }
  friend DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b) { return a + -b; }
  friend DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) {
    const DoubleDouble p = product(a.hi, b.hi);
    return quick_sum(p.hi, p.lo + (a.hi * b.lo + a.lo * b.hi));
  }

 private:
  DoubleDouble(double h, double l) : hi(h), lo(l) {}
};

}  // namespace tribunal::detail
