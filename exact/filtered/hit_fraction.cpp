#include "exact/filtered/hit_fraction.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>
#include <stdexcept>

#include "core/kernel.h"
#include "exact/filtered/stages/default_rounding.h"
#include "exact/kernels/dyadic.h"

namespace tribunal {
namespace {

constexpr int digits = std::numeric_limits<double>::digits;  ///< 53
constexpr long least_unit = -1074, greatest_unit = 971;      ///< exponents of a last place, of subnormals and DBL_MAX

long bits_of(const mpz_class& x) { return static_cast<long>(mpz_sizeinbase(x.get_mpz_t(), 2)); }

mpz_class shifted(const mpz_class& x, long by) { return x << static_cast<mp_bitcnt_t>(by); }

/// num / (den·2^unit) as quotient and rest. The divisor is den·2^unit, or den where 2^unit is a fraction.
struct Division {
  Division(const mpz_class& num, const mpz_class& den, long unit) : divisor(unit > 0 ? shifted(den, unit) : den) {
    const mpz_class dividend = unit < 0 ? shifted(num, -unit) : num;
    mpz_fdiv_qr(quotient.get_mpz_t(), rest.get_mpz_t(), dividend.get_mpz_t(), divisor.get_mpz_t());
  }

  /// The nearest integer, ties to even.
  std::uint64_t nearest() const {
    const std::uint64_t below = quotient.get_ui();
    const int half = cmp(mpz_class(2 * rest), divisor);
    return below + std::uint64_t{half > 0 || (half == 0 && below % 2 == 1)};
  }

  mpz_class divisor, quotient, rest;
};

/// count·2^unit for a count of at most 2⁵³, which is 2⁵² or more unless the unit is the least. The count's leading bit
/// adds one to the exponent, as it should: the least unit belongs to exponent 0 without that bit and to exponent 1 with
/// it. A count of 2⁵³ carries once more, and so may reach infinity.
double pattern(std::uint64_t count, long unit) {
  return std::bit_cast<double>((static_cast<std::uint64_t>(unit - least_unit) << (digits - 1)) + count);
}

/// `rounded` of a positive number. It lies in (2^(e−1), 2^(e+1)), so its last place is 2^(e−53), or 2^(e−52) where that
/// leaves a quotient of 54 bits; but never less than the least.
double rounded_positive(const mpz_class& num, const mpz_class& den) {
  const long e = bits_of(num) - bits_of(den);
  long unit = std::max(e - digits, least_unit);
  if (unit > greatest_unit) return std::numeric_limits<double>::infinity();
  Division division(num, den, unit);
  if (bits_of(division.quotient) > digits) division = Division(num, den, ++unit);
  if (unit > greatest_unit) return std::numeric_limits<double>::infinity();
  return pattern(division.nearest(), unit);
}

}  // namespace

double rounded(const mpq_class& x) {
  if (sgn(x) == 0) return 0;
  const double magnitude = rounded_positive(abs(x.get_num()), x.get_den());
  const std::uint64_t bits = std::bit_cast<std::uint64_t>(magnitude);
  return std::bit_cast<double>(sgn(x) < 0 && bits != 0 ? bits | std::uint64_t{1} << 63 : bits);
}

mpq_class hit_fraction(const Ray& r, const Triangle& t) {
  const DefaultRounding in_this_scope;
  const HitParameter<Dyadic> hit = hit_parameter<Dyadic>(r, t);
  if (sign_of(hit.den) == Sign::zero) throw std::domain_error("hit_fraction: the ray does not cross the plane");
  return hit.num.fraction() / hit.den.fraction();
}

}  // namespace tribunal
