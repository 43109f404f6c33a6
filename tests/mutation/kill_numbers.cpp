// The part of kill_kernels.cpp that is about exact numbers: each computes beside GMP's fractions, operation by
// operation.
#include <gmpxx.h>

#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "exact/kernels/bounded_integer.h"
#include "exact/kernels/dyadic.h"
#include "exact/kernels/expansion.h"
#include "exact/kernels/extended_rational.h"
#include "tests/mutation/kill.h"

using namespace tribunal;
using namespace tribunal::killing;

namespace {

Sign as_sign(int s) { return s > 0 ? Sign::positive : s < 0 ? Sign::negative : Sign::zero; }

bool is_long(const mpq_class& q) { return mpz_size(q.get_num_mpz_t()) + mpz_size(q.get_den_mpz_t()) > 60; }

// --- dyadics --------------------------------------------------------------------------------------------------------

struct BesideDyadic {
  Dyadic x{};
  mpq_class q{};
};

BesideDyadic drawn_dyadic(Draw& draw) {
  const double x = draw.number(draw.below(Draw::kinds));
  return std::isfinite(x) ? BesideDyadic{Dyadic(x), mpq_class(x)} : BesideDyadic{};
}

void require_equal(const BesideDyadic& p) {
  require(p.x.fraction() == p.q && sign_of(p.x) == as_sign(sgn(p.q)), "a dyadic number");
}

BesideDyadic combined(const BesideDyadic& a, const BesideDyadic& b, int operation) {
  switch (operation) {
    case 0:
      return {a.x + b.x, a.q + b.q};
    case 1:
      return {a.x - b.x, a.q - b.q};
    case 2:
      return {-a.x, -a.q};
    default:
      return {a.x * b.x, a.q * b.q};
  }
}

/// Copies, moves and assigns to itself.
void check_ownership(BesideDyadic& p) {
  Dyadic copy(p.x), other;
  other = copy;
  Dyadic& same = p.x;
  p.x = same;
  require_equal(p);
  p.x = std::move(same);
  require_equal(p);
  const Dyadic moved(std::move(copy));
  p.x = moved;
  require_equal({other, p.q});
  p.x = std::move(other);
  require_equal(p);
}

void check_dyadics() {
  Draw draw;
  std::vector<BesideDyadic> pool(12);
  for (int n = 0; n < 12'000; ++n) {
    BesideDyadic& p = pool[static_cast<std::size_t>(draw.below(12))];
    const BesideDyadic a = pool[static_cast<std::size_t>(draw.below(12))],
                       b = pool[static_cast<std::size_t>(draw.below(12))];
    p = draw.below(4) == 0 ? drawn_dyadic(draw) : combined(a, b, draw.below(4));
    require_equal(p);
    if (n % 16 == 0) check_ownership(p);
    if (is_long(p.q)) p = drawn_dyadic(draw);
  }
  for (const double x : {0.0, -0.0, 1.0, -1.5, 0x1p53, -0x1p53, 0x1p53 - 1, 5e-324, -1.7976931348623157e308}) {
    require(Dyadic(x).fraction() == mpq_class(x), "a dyadic number of a double");
  }
}

// --- rational numbers with infinities -------------------------------------------------------------------------------

/// IEEE's rules on fractions: `q` where finite; else an infinity of the sign, or NaN for 0.
struct Extended {
  bool finite = true;
  int sign = 0;
  mpq_class q{};

  static Extended of(const mpq_class& q) { return {true, sgn(q), q}; }
  static Extended infinite(int sign) { return {false, sign, {}}; }
  bool nan() const { return !finite && sign == 0; }
};

Extended sum(const Extended& a, const Extended& b) {
  if (a.nan() || b.nan() || (!a.finite && !b.finite && a.sign != b.sign)) return Extended::infinite(0);
  if (!a.finite) return a;
  return b.finite ? Extended::of(a.q + b.q) : b;
}

Extended negated(const Extended& a) { return a.finite ? Extended::of(-a.q) : Extended::infinite(-a.sign); }

Extended product(const Extended& a, const Extended& b) {
  return a.finite && b.finite ? Extended::of(a.q * b.q) : Extended::infinite(a.sign * b.sign);
}

Extended quotient(const Extended& a, const Extended& b) {
  if (a.nan() || b.nan() || (!a.finite && !b.finite)) return Extended::infinite(0);
  if (!b.finite) return Extended::of(0);
  if (b.sign == 0) return Extended::infinite(a.sign);
  return a.finite ? Extended::of(a.q / b.q) : Extended::infinite(a.sign * b.sign);
}

bool less(const Extended& a, const Extended& b) {
  if (a.nan() || b.nan()) return false;
  if (a.finite && b.finite) return a.q < b.q;
  return (a.finite ? 0 : a.sign) < (b.finite ? 0 : b.sign);
}

bool equal(const Extended& a, const Extended& b) {
  if (a.nan() || b.nan() || a.finite != b.finite) return false;
  return a.finite ? a.q == b.q : a.sign == b.sign;
}

struct BesideExtended {
  ExtendedRational x{};
  Extended q{};
};

BesideExtended drawn_extended(Draw& draw) {
  constexpr double special[] = {infinity, -infinity, not_a_number, 0.0, 1.0, -1.0};
  const double x = draw.below(3) == 0 ? special[draw.below(6)] : draw.number(draw.below(Draw::kinds));
  if (std::isfinite(x)) return {ExtendedRational(x), Extended::of(mpq_class(x))};
  return {ExtendedRational(x), Extended::infinite(std::isnan(x) ? 0 : x > 0 ? 1 : -1)};
}

BesideExtended combined(const BesideExtended& a, const BesideExtended& b, int operation) {
  switch (operation) {
    case 0:
      return {a.x + b.x, sum(a.q, b.q)};
    case 1:
      return {a.x - b.x, sum(a.q, negated(b.q))};
    case 2:
      return {a.x * b.x, product(a.q, b.q)};
    case 3:
      return {a.x / b.x, quotient(a.q, b.q)};
    default:
      return {-a.x, negated(a.q)};
  }
}

void require_equal(const BesideExtended& p) {
  require(p.x.is_finite() == p.q.finite && p.x.is_nan() == p.q.nan(), "a kind of number");
  if (p.q.finite) require(p.x.fraction() == p.q.q, "a rational number");
}

void require_order(const BesideExtended& a, const BesideExtended& b) {
  const bool is_less = less(a.q, b.q), is_more = less(b.q, a.q), is_same = equal(a.q, b.q);
  require((a.x < b.x) == is_less && (a.x > b.x) == is_more, "less and more");
  require((a.x == b.x) == is_same && (a.x != b.x) == !is_same, "the same");
  require((a.x <= b.x) == (is_less || is_same) && (a.x >= b.x) == (is_more || is_same), "at most and at least");
}

void check_extended() {
  Draw draw;
  std::vector<BesideExtended> pool(12);
  for (int n = 0; n < 12'000; ++n) {
    BesideExtended& p = pool[static_cast<std::size_t>(draw.below(12))];
    const BesideExtended a = pool[static_cast<std::size_t>(draw.below(12))];
    const BesideExtended b = draw.below(8) == 0 ? a : pool[static_cast<std::size_t>(draw.below(12))];
    require_order(a, b);
    p = draw.below(3) == 0 ? drawn_extended(draw) : combined(a, b, draw.below(5));
    require_equal(p);
    require_order(p, combined(p, BesideExtended{}, 0));
    if (p.q.finite && is_long(p.q.q)) p = drawn_extended(draw);
  }
  require(ExtendedRational(-7).fraction() == -7 && ExtendedRational(0).is_finite(), "of an int");
}

// --- integers of fixed width ----------------------------------------------------------------------------------------

template <int Bits>
mpz_class value_of(const BoundedInteger<Bits>& x) {
  constexpr std::size_t words = BoundedInteger<Bits>::words + 1;
  const auto w = x.template in_words<words>();
  mpz_class v;
  for (std::size_t i = words; i-- > 0;) v = (v << 64) + mpz_class(static_cast<unsigned long>(w[i]));
  if (static_cast<std::int64_t>(w[words - 1]) < 0) v -= mpz_class(1) << static_cast<mp_bitcnt_t>(64 * words);
  return v;
}

template <int Bits>
void require_value(const BoundedInteger<Bits>& x, const mpz_class& due) {
  require(value_of(x) == due && sign_of(x) == as_sign(sgn(due)), "an integer of fixed width");
}

/// An integer below 2^bits, of any length.
double drawn_integer(Draw& draw, int bits) {
  if (draw.below(8) == 0) return 0;
  const double significand = static_cast<double>(draw.bits() >> 11) * 0x1p-53;
  const double x = std::trunc(std::ldexp(significand, draw.within(1, bits)));
  return draw.below(2) == 0 ? x : -x;
}

template <int Bits>
void check_integers(Draw& draw) {
  using Integer = BoundedInteger<Bits>;
  for (int n = 0; n < 1'500; ++n) {
    double x[4];
    mpz_class z[4];
    for (int i = 0; i < 4; ++i) z[i] = mpz_class(x[i] = drawn_integer(draw, Bits));
    const Integer a(x[0]), b(x[1]), c(x[2]), d(x[3]);
    require_value(a, z[0]);
    require_value(a + b, z[0] + z[1]);
    require_value(a - b, z[0] - z[1]);
    require_value(a - a, 0);
    require_value(a * b, z[0] * z[1]);
    require_value(a * b - c * d, z[0] * z[1] - z[2] * z[3]);
    require_value((a - b) * (a * b - c * d) + a * a * a,
                  (z[0] - z[1]) * (z[0] * z[1] - z[2] * z[3]) + z[0] * z[0] * z[0]);
    require_value((a * b) + d, z[0] * z[1] + z[3]);
  }
}

// --- expansions -----------------------------------------------------------------------------------------------------

template <class Terms>
mpq_class value_of(const detail::ExactExpansion<Terms>& e) {
  mpq_class sum;
  for (std::size_t i = 0; i < e.size(); ++i) {
    require(abs(sum) < abs(mpq_class(e.terms()[i])), "a term is larger than the sum of those before");
    sum += mpq_class(e.terms()[i]);
  }
  return sum;
}

template <class Terms>
void require_value(const detail::ExactExpansion<Terms>& e, const mpq_class& due) {
  require(value_of(e) == due && sign_of(e) == as_sign(sgn(due)), "an expansion");
}

template <class E>
void check_expansions() {
  Draw draw;
  for (int n = 0; n < 1'500; ++n) {
    const int kind = draw.within(0, 4);
    double x[4];
    for (double& v : x) v = draw.number(kind);
    const E a(x[0]), b(x[1]), c(x[2]), d(x[3]);
    const mpq_class p(x[0]), q(x[1]), r(x[2]), s(x[3]);
    require_value(a, p);
    require_value(a + b, p + q);
    require_value(a - b, p - q);
    require_value(-(a + b), -(p + q));
    require_value((a - b) * c, (p - q) * r);
    require_value(c * (a - b), (p - q) * r);
    const E minor = (a - b) * (c - d) - a * c;
    const mpq_class due = (p - q) * (r - s) - p * r;
    require_value(minor, due);
    require_value(minor * (a + d), due * (p + s));
    require_value(minor - minor, 0);
    const auto few = minor.template compressed<std::vector<double>>();
    require_value(few, due);
    require(few.size() <= minor.size() && (minor - minor).size() == 0, "fewer terms");
    const detail::Rounded sum = detail::exact_sum(x[0], x[1]), product = detail::exact_product(x[0], x[1]);
    require(sum.result == x[0] + x[1] && mpq_class(sum.result) + mpq_class(sum.error) == p + q, "an exact sum");
    require(product.result == x[0] * x[1] && mpq_class(product.result) + mpq_class(product.error) == p * q,
            "a product");
  }
}

}  // namespace

void check_numbers() {
  check_dyadics();
  check_extended();
  Draw draw;
  check_integers<19>(draw);
  check_integers<40>(draw);
  check_integers<61>(draw);
  check_integers<125>(draw);
  check_integers<253>(draw);
  check_expansions<detail::VolumeExpansion>();
  check_expansions<detail::LongExpansion>();
}
