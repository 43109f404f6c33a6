#include "exact/kernels/dyadic.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tribunal {

Dyadic::Dyadic(double x) {
  constexpr double integers_fit = 0x1p53;
  if (std::fabs(x) < integers_fit && std::trunc(x) == x) {
    word_ = static_cast<long>(x);
    return;
  }
  int exponent = 0;
  const double fraction = std::frexp(x, &exponent);
  word_ = static_cast<long>(std::ldexp(fraction, 53));
  e_ = exponent - 53L;
}

const mpz_class& Dyadic::integer(mpz_class& scratch) const {
  if (big_) return *big_;
  return scratch = word_;
}

const mpz_class& Dyadic::aligned_to(long lower, mpz_class& scratch) const {
  const mpz_class& m = integer(scratch);
  if (e_ == lower) return m;
  mpz_mul_2exp(scratch.get_mpz_t(), m.get_mpz_t(), static_cast<mp_bitcnt_t>(e_ - lower));
  return scratch;
}

Dyadic operator+(const Dyadic& a, const Dyadic& b) {
  long sum = 0;
  if (!a.big_ && !b.big_ && a.e_ == b.e_ && !__builtin_add_overflow(a.word_, b.word_, &sum)) return {sum, a.e_};
  const long e = std::min(a.e_, b.e_);
  mpz_class scratch_a, scratch_b;
  return {mpz_class(a.aligned_to(e, scratch_a) + b.aligned_to(e, scratch_b)), e};
}

Dyadic operator-(const Dyadic& a, const Dyadic& b) {
  long difference = 0;
  if (!a.big_ && !b.big_ && a.e_ == b.e_ && !__builtin_sub_overflow(a.word_, b.word_, &difference)) {
    return {difference, a.e_};
  }
  const long e = std::min(a.e_, b.e_);
  mpz_class scratch_a, scratch_b;
  return {mpz_class(a.aligned_to(e, scratch_a) - b.aligned_to(e, scratch_b)), e};
}

Dyadic operator*(const Dyadic& a, const Dyadic& b) {
  long product = 0;
  if (!a.big_ && !b.big_ && !__builtin_mul_overflow(a.word_, b.word_, &product)) return {product, a.e_ + b.e_};
  mpz_class scratch_a, scratch_b;
  return {mpz_class(a.integer(scratch_a) * b.integer(scratch_b)), a.e_ + b.e_};
}

mpq_class Dyadic::fraction() const {
  mpz_class scratch;
  if (e_ >= 0) return mpq_class(aligned_to(0, scratch));
  mpq_class q(integer(scratch), mpz_class(1) << static_cast<mp_bitcnt_t>(-e_));
  q.canonicalize();
  return q;
}

}  // namespace tribunal
