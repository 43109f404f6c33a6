#include "exact/kernels/dyadic.h"

#include <cmath>
#include <utility>

namespace tribunal {
namespace {

mpz_class shifted(const mpz_class& m, long bits) {
  mpz_class result;
  mpz_mul_2exp(result.get_mpz_t(), m.get_mpz_t(), static_cast<mp_bitcnt_t>(bits));
  return result;
}

}  // namespace

Dyadic::Dyadic(double x) {
  constexpr double integers_fit = 0x1p53;
  if (std::fabs(x) < integers_fit && std::trunc(x) == x) {
    m_ = static_cast<long>(x);
    return;
  }
  int exponent = 0;
  const double fraction = std::frexp(x, &exponent);
  m_ = static_cast<long>(std::ldexp(fraction, 53));
  e_ = exponent - 53L;
}

Dyadic operator+(const Dyadic& a, const Dyadic& b) {
  if (a.e_ == b.e_) return Dyadic(a.m_ + b.m_, a.e_);
  if (a.e_ < b.e_) return Dyadic(a.m_ + shifted(b.m_, b.e_ - a.e_), a.e_);
  return Dyadic(shifted(a.m_, a.e_ - b.e_) + b.m_, b.e_);
}

Dyadic operator-(const Dyadic& a, const Dyadic& b) {
  if (a.e_ == b.e_) return Dyadic(a.m_ - b.m_, a.e_);
  if (a.e_ < b.e_) return Dyadic(a.m_ - shifted(b.m_, b.e_ - a.e_), a.e_);
  return Dyadic(shifted(a.m_, a.e_ - b.e_) - b.m_, b.e_);
}

mpq_class Dyadic::fraction() const {
  if (e_ >= 0) return mpq_class(shifted(m_, e_));
  mpq_class q(m_, shifted(mpz_class(1), -e_));
  q.canonicalize();
  return q;
}

}  // namespace tribunal
