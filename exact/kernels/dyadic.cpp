#include "exact/kernels/dyadic.h"

#include <cmath>

namespace tribunal {
namespace {

static_assert(GMP_NUMB_BITS == 64);

__extension__ using Wide = unsigned __int128;
__extension__ using SignedWide = __int128;

}  // namespace

class Dyadic::View {
 public:
  explicit View(const Dyadic& a) : m_(a.big_ ? a.big_->get_mpz_t() : mpz_roinit_n(words_, a.limbs_, a.size_)) {}
  View(const View&) = delete;
  View& operator=(const View&) = delete;

  operator mpz_srcptr() const { return m_; }

 private:
  mpz_t words_;
  mpz_srcptr m_;
};

Dyadic::Dyadic(double x) {
  constexpr double integers_fit = 0x1p53;
  long word = 0;
  if (std::fabs(x) < integers_fit && std::trunc(x) == x) {
    word = static_cast<long>(x);
  } else {
    int exponent = 0;
    const double fraction = std::frexp(x, &exponent);
    word = static_cast<long>(std::ldexp(fraction, 53));
    e_ = exponent - 53L;
  }
  size_ = value(sign_of(word));
  limbs_[0] = static_cast<mp_limb_t>(std::labs(word));
}

Dyadic::Dyadic(const mpz_class& m, long e) : e_(e) {
  const auto size = mpz_size(m.get_mpz_t());
  if (size > room) {
    big_ = std::make_unique<const mpz_class>(m);
    return;
  }
  std::copy_n(mpz_limbs_read(m.get_mpz_t()), size, limbs_);
  size_ = static_cast<int>(size) * sgn(m);
}

int Dyadic::shifted(long bits, mp_limb_t* to) const {
  const long whole = bits / limb_bits;
  const auto rest = static_cast<unsigned>(bits % limb_bits);
  const int n = std::abs(size_), end = n + static_cast<int>(whole);
  if (rest == 0) {
    std::copy_n(limbs_, n, to + whole);
    return end;
  }
  to[end] = mpn_lshift(to + whole, limbs_, n, rest);
  return end + (to[end] != 0);
}

Dyadic Dyadic::sum(const Dyadic& a, const Dyadic& b, bool minus) {
  if (b.is_zero()) return a;
  const long e = a.is_zero() ? b.e_ : std::min(a.e_, b.e_);
  if (!a.has_room_for(a.is_zero() ? 0 : a.e_ - e) || !b.has_room_for(b.e_ - e)) {
    mpz_class x, y;
    if (!a.is_zero()) mpz_mul_2exp(x.get_mpz_t(), View(a), static_cast<mp_bitcnt_t>(a.e_ - e));
    mpz_mul_2exp(y.get_mpz_t(), View(b), static_cast<mp_bitcnt_t>(b.e_ - e));
    if (minus) return {mpz_class(x - y), e};
    return {mpz_class(x + y), e};
  }
  mp_limb_t x[room] = {}, y[room] = {};
  int n = a.is_zero() ? 0 : a.shifted(a.e_ - e, x);
  n = std::max(n, b.shifted(b.e_ - e, y));
  Dyadic result;
  result.e_ = e;
  const bool b_negative = (b.size_ < 0) != minus;
  bool negative = b_negative;
  if (a.is_zero() || (a.size_ < 0) == b_negative) {
    result.limbs_[n] = mpn_add_n(result.limbs_, x, y, n);
    ++n;
  } else if (mpn_cmp(x, y, n) >= 0) {
    negative = a.size_ < 0;
    mpn_sub_n(result.limbs_, x, y, n);
  } else {
    mpn_sub_n(result.limbs_, y, x, n);
  }
  while (n > 0 && result.limbs_[n - 1] == 0) --n;
  result.size_ = negative ? -n : n;
  return result;
}

Dyadic operator*(const Dyadic& a, const Dyadic& b) {
  const int m = std::abs(a.size_), n = std::abs(b.size_);
  if (a.big_ || b.big_ || m + n > Dyadic::room) {
    mpz_class product;
    mpz_mul(product.get_mpz_t(), Dyadic::View(a), Dyadic::View(b));
    return {product, a.e_ + b.e_};
  }
  Dyadic result;
  if (m == 0 || n == 0) return result;
  result.e_ = a.e_ + b.e_;
  const mp_limb_t top =
      m >= n ? mpn_mul(result.limbs_, a.limbs_, m, b.limbs_, n) : mpn_mul(result.limbs_, b.limbs_, n, a.limbs_, m);
  const int size = m + n - (top == 0);
  result.size_ = (a.size_ < 0) != (b.size_ < 0) ? -size : size;
  return result;
}

mpq_class Dyadic::fraction() const {
  mpq_class q;
  if (e_ >= 0) {
    mpz_mul_2exp(q.get_num_mpz_t(), View(*this), static_cast<mp_bitcnt_t>(e_));
    return q;
  }
  mpz_set(q.get_num_mpz_t(), View(*this));
  mpz_mul_2exp(q.get_den_mpz_t(), q.get_den_mpz_t(), static_cast<mp_bitcnt_t>(-e_));
  q.canonicalize();
  return q;
}

}  // namespace tribunal
