// Floating-point expansions: exact numbers as sums of doubles.
// Sources: J. R. Shewchuk, "Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates",
// Discrete & Computational Geometry 18, 1997, doi:10.1007/PL00009321 (called "the paper" here); Dekker, "A
// floating-point technique for extending the available precision", Numerische Mathematik 18, 1971; Knuth, TAOCP 2,
// section 4.2.2.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "core/sign.h"

namespace tribunal::detail {

/// Two doubles whose sum is an exact result: the result rounded to nearest, and what rounding took away.
struct Rounded {
  double result, error;
};

/// a + b. Exact where no operation overflows: the error of a sum is always a double (Knuth). One may overflow although
/// the result does not: with a = −(2¹⁰²² + 3·2⁹⁷⁰) and b the largest double, s is rounded up, and s − a comes to 2¹⁰²⁴.
/// Then the error is infinite or no number, and never a wrong one: all that is formed of an infinity is either. See S.
/// Boldo, S. Graillat, J.-M. Muller, "On the robustness of the 2Sum and Fast2Sum algorithms", ACM TOMS 44(1), 2017,
/// doi:10.1145/3054947.
inline Rounded exact_sum(double a, double b) {
  const double s = a + b, of_b = s - a;
  return {s, (a - (s - of_b)) + (b - of_b)};
}

/// a as a sum of two doubles of at most 26 bits, the second one signed (Veltkamp, in Dekker's paper).
inline Rounded halves(double a) {
  constexpr double splitter = 0x1p27 + 1;
  const double c = splitter * a, high = c - (c - a);
  return {high, a - high};
}

/// a·b. Exact where nothing overflows and a·b is a multiple of 2⁻¹⁰⁷⁴ (Dekker): the products of halves are then
/// multiples of 2⁻¹⁰⁷⁴ too and have at most 53 bits, so no operation but the first rounds.
inline Rounded exact_product(double a, double b) {
  const double p = a * b;
  const Rounded x = halves(a), y = halves(b);
  const double without_high = p - x.result * y.result;
  const double without_middle = (without_high - x.error * y.result) - x.result * y.error;
  return {p, x.error * y.error - without_middle};
}

/// Room for up to `capacity` terms, with the interface of std::vector that ExactExpansion needs. Copies what is there.
template <std::size_t capacity>
class FixedTerms {
 public:
  FixedTerms() = default;
  FixedTerms(const FixedTerms& other) { *this = other; }
  FixedTerms& operator=(const FixedTerms& other) {
    size_ = other.size_;
    for (std::size_t i = 0; i < size_; ++i) terms_[i] = other.terms_[i];
    return *this;
  }
  void push_back(double x) { terms_[size_++] = x; }
  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  double operator[](std::size_t i) const { return terms_[i]; }
  double back() const { return terms_[size_ - 1]; }

 private:
  std::size_t size_ = 0;
  std::array<double, capacity> terms_;  // terms from size_ on are never read, and cost nothing
};

/// The exact sum of its terms, which are doubles other than zero, in ascending order of magnitude and strongly
/// nonoverlapping (the paper, section 2.1): each is larger than the sum of all before it, so the last one has the sign.
///
/// Laws, in round-to-nearest with ties to even: +, −, × are exact where (1) no operation overflows, and (2) all terms
/// are multiples of some u, v of which the products that are formed are multiples of 2⁻¹⁰⁷⁴. The caller sees to both
/// (`ExpansionRange`). Sums are the paper's FAST-EXPANSION-SUM (theorem 13), products with one double its
/// SCALE-EXPANSION (theorem 19); both keep terms strongly nonoverlapping, and zeros are left out, which changes
/// neither.
template <class Terms>
class ExactExpansion {
 public:
  ExactExpansion() = default;
  explicit ExactExpansion(double x) { append(x); }

  friend ExactExpansion operator+(const ExactExpansion& e, const ExactExpansion& f) { return sum(e, f, 1); }
  friend ExactExpansion operator-(const ExactExpansion& e, const ExactExpansion& f) { return sum(e, f, -1); }
  friend ExactExpansion operator-(const ExactExpansion& e) { return sum({}, e, -1); }

  /// One scaled copy of the longer factor for each term of the shorter.
  friend ExactExpansion operator*(const ExactExpansion& e, const ExactExpansion& f) {
    const bool e_is_longer = e.size() > f.size();
    const ExactExpansion& longer = e_is_longer ? e : f;
    const ExactExpansion& shorter = e_is_longer ? f : e;
    if (shorter.size() == 0) return {};
    ExactExpansion product = longer.times(shorter.terms_[0]);
    for (std::size_t i = 1; i < shorter.size(); ++i) product = product + longer.times(shorter.terms_[i]);
    return product;
  }

  friend Sign sign_of(const ExactExpansion& e) { return e.terms_.empty() ? Sign::zero : sign_of(e.terms_.back()); }

  std::size_t size() const { return terms_.size(); }
  const Terms& terms() const { return terms_; }

  /// The same number in fewer terms, as a rule as few as it takes: two sweeps of exact sums, from the largest term
  /// down and up again (the paper's COMPRESS, theorem 23).
  template <class Other>
  ExactExpansion<Other> compressed() const {
    std::vector<double> kept;
    double carried = 0;
    for (std::size_t i = size(); i-- > 0;) {
      const Rounded s = exact_sum(carried, terms_[i]);
      if (s.error != 0) kept.push_back(s.result);
      carried = s.error != 0 ? s.error : s.result;
    }
    ExactExpansion<Other> e;
    for (std::size_t i = kept.size(); i-- > 0;) {
      const Rounded s = exact_sum(kept[i], carried);
      e.append(s.error);
      carried = s.result;
    }
    e.append(carried);
    return e;
  }

  /// Adds a term larger than all others, or nothing.
  void append(double term) {
    if (term != 0) terms_.push_back(term);
  }

 private:
  /// e + factor·f, where factor is 1 or −1: the terms of both, merged by magnitude, are added one after the other, and
  /// what each sum rounds away is a term.
  static ExactExpansion sum(const ExactExpansion& e, const ExactExpansion& f, double factor) {
    ExactExpansion result;
    double carried = 0;
    std::size_t i = 0, j = 0;
    while (i < e.size() || j < f.size()) {
      const bool from_e = j == f.size() || (i < e.size() && std::fabs(e.terms_[i]) < std::fabs(f.terms_[j]));
      const Rounded s = exact_sum(carried, from_e ? e.terms_[i++] : factor * f.terms_[j++]);
      result.append(s.error);
      carried = s.result;
    }
    result.append(carried);
    return result;
  }

  /// x times this, which has a term.
  ExactExpansion times(double x) const {
    ExactExpansion result;
    const Rounded first = exact_product(terms_[0], x);
    result.append(first.error);
    double carried = first.result;
    for (std::size_t i = 1; i < size(); ++i) {
      const Rounded product = exact_product(terms_[i], x);
      const Rounded low = exact_sum(carried, product.error);
      const Rounded high = exact_sum(product.result, low.result);
      result.append(low.error);
      result.append(high.error);
      carried = high.result;
    }
    result.append(carried);
    return result;
  }

  Terms terms_;
};

/// The most terms that a volume of three differences has: a difference 2, a product of two 2·2·2 = 8, a minor 16, times
/// a difference 2·2·16 = 64, the sum of three 192.
inline constexpr std::size_t most_terms_of_volume = 192;

using VolumeExpansion = ExactExpansion<FixedTerms<most_terms_of_volume>>;
using LongExpansion = ExactExpansion<std::vector<double>>;

}  // namespace tribunal::detail
