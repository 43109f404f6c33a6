#include "exact/kernels/extended_rational.h"

#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace tribunal {
namespace {

constexpr long lowest = std::numeric_limits<long>::min();

/// The sum of a/b and c/d, unless it overflows. The least word is left out: its negative is no word.
bool add(long a, long b, long c, long d, long* num, long* den) {
  long ad = 0, cb = 0;
  if (b == d) {
    *den = b;
    return !__builtin_add_overflow(a, c, num) && *num != lowest;
  }
  return !__builtin_mul_overflow(a, d, &ad) && !__builtin_mul_overflow(c, b, &cb) &&
         !__builtin_add_overflow(ad, cb, num) && !__builtin_mul_overflow(b, d, den) && *num != lowest;
}

bool multiply(long a, long b, long c, long d, long* num, long* den) {
  return !__builtin_mul_overflow(a, c, num) && !__builtin_mul_overflow(b, d, den) && *num != lowest && *den != lowest;
}

int sign_of_word(long x) { return (x > 0) - (x < 0); }

}  // namespace

ExtendedRational::ExtendedRational(double x) {
  constexpr double integers_fit = 0x1p53;
  if (std::isfinite(x) && std::fabs(x) < integers_fit && std::trunc(x) == x) {
    num_ = static_cast<long>(x);
  } else if (std::isfinite(x)) {
    *this = ExtendedRational(mpq_class(x));
  } else {
    num_ = std::isnan(x) ? 0 : x > 0 ? 1 : -1;
    den_ = 0;
  }
}

/// The number is kept in two words if it fits.
ExtendedRational::ExtendedRational(mpq_class x) {
  if (x.get_num().fits_slong_p() && x.get_den().fits_slong_p() && x.get_num() != lowest) {
    num_ = x.get_num().get_si();
    den_ = x.get_den().get_si();
  } else {
    big_ = std::make_shared<const mpq_class>(std::move(x));
  }
}

ExtendedRational ExtendedRational::reduced(long num, long den) {
  if (den == 1) return {num, den};
  const long divisor = std::gcd(num, den);
  return {num / divisor, den / divisor};
}

int ExtendedRational::sign() const { return big_ ? sgn(*big_) : sign_of_word(num_); }

mpq_class ExtendedRational::fraction() const { return big_ ? *big_ : mpq_class(num_, den_); }

ExtendedRational ExtendedRational::operator-() const {
  return big_ ? ExtendedRational(mpq_class(-*big_)) : ExtendedRational(-num_, den_);
}

ExtendedRational operator+(const ExtendedRational& a, const ExtendedRational& b) {
  if (!a.is_finite() || !b.is_finite()) {
    if (a.is_finite()) return b;
    return b.is_finite() || a.num_ == b.num_ ? a : ExtendedRational(0, 0);
  }
  long num = 0, den = 0;
  if (!a.big_ && !b.big_ && add(a.num_, a.den_, b.num_, b.den_, &num, &den)) {
    return ExtendedRational::reduced(num, den);
  }
  return ExtendedRational(mpq_class(a.fraction() + b.fraction()));
}

ExtendedRational operator*(const ExtendedRational& a, const ExtendedRational& b) {
  if (!a.is_finite() || !b.is_finite()) return {static_cast<long>(a.sign() * b.sign()), 0L};
  long num = 0, den = 0;
  if (!a.big_ && !b.big_ && multiply(a.num_, a.den_, b.num_, b.den_, &num, &den)) {
    return ExtendedRational::reduced(num, den);
  }
  return ExtendedRational(mpq_class(a.fraction() * b.fraction()));
}

ExtendedRational operator/(const ExtendedRational& a, const ExtendedRational& b) {
  if (!b.is_finite()) return b.is_nan() || !a.is_finite() ? ExtendedRational(0, 0) : ExtendedRational(0);
  if (b.sign() == 0) return {static_cast<long>(a.sign()), 0L};
  if (!a.is_finite()) return {static_cast<long>(a.sign() * b.sign()), 0L};
  if (b.big_) return ExtendedRational(mpq_class(a.fraction() / *b.big_));
  const long upside_down = b.num_ < 0 ? -b.den_ : b.den_;
  return a * ExtendedRational(upside_down, std::labs(b.num_));
}

bool operator==(const ExtendedRational& a, const ExtendedRational& b) {
  if (a.is_nan() || b.is_nan()) return false;
  if (a.big_ && b.big_) return *a.big_ == *b.big_;
  return !a.big_ && !b.big_ && a.num_ == b.num_ && a.den_ == b.den_;
}

bool operator<(const ExtendedRational& a, const ExtendedRational& b) {
  if (a.is_nan() || b.is_nan()) return false;
  if (a.sign() != b.sign()) return a.sign() < b.sign();
  if (a.big_ || b.big_) {
    if (!a.is_finite() || !b.is_finite()) return a.is_finite() ? b.sign() > 0 : a.sign() < 0;
    return a.fraction() < b.fraction();
  }
  return static_cast<__int128>(a.num_) * b.den_ < static_cast<__int128>(b.num_) * a.den_;
}

}  // namespace tribunal
