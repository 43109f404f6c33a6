#include "exact/kernels/product_sum.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>

#include "exact/kernels/expansion.h"
#include "exact/kernels/expansion_bound.h"
#include "exact/kernels/rational_kernel.h"

namespace tribunal {
namespace {

using namespace detail;

__extension__ using Wide = unsigned __int128;
using Word = std::uint64_t;

/// |x| = significand·2^unit, for any finite x.
struct Decoded {
  Word significand;
  int unit;
};

Decoded decoded(double x) {
  const auto pattern = std::bit_cast<Word>(x);
  const int field = static_cast<int>(pattern >> 52 & 0x7ff);
  const Word fraction = pattern & 0xfffffffffffff;
  return field == 0 ? Decoded{fraction, -1074} : Decoded{fraction | Word{1} << 52, field - 1075};
}

/// Integers of four words in two's complement.
class Accumulator {
 public:
  /// The bits of the magnitude, or one more; 0 for zero.
  int bits() const {
    const Word sign = negative() ? ~Word{0} : 0;
    for (std::size_t i = words; i-- > 0;) {
      if (const Word w = words_[i] ^ sign; w != 0)
        return static_cast<int>(64 * i) + static_cast<int>(std::bit_width(w));
    }
    return negative() ? 1 : 0;
  }

  Sign sign() const { return negative() ? Sign::negative : bits() > 0 ? Sign::positive : Sign::zero; }

  /// By less than 64·words bits.
  void shift_left(int bits) {
    if (bits == 0) return;
    const auto whole = static_cast<std::size_t>(bits / 64);
    const int rest = bits % 64;
    for (std::size_t i = words; i-- > 0;) {
      const Word high = i >= whole ? words_[i - whole] : 0;
      const Word low = i > whole ? words_[i - whole - 1] : 0;
      words_[i] = rest == 0 ? high : high << rest | low >> (64 - rest);
    }
  }

  void add(const std::array<Word, 3>& magnitude, bool negative) {
    const Word flip = negative ? ~Word{0} : 0;
    Wide carry = negative ? 1 : 0;
    for (std::size_t i = 0; i < words; ++i) {
      carry += Wide{words_[i]} + ((i < magnitude.size() ? magnitude[i] : 0) ^ flip);
      words_[i] = static_cast<Word>(carry);
      carry >>= 64;
    }
  }

 private:
  static constexpr std::size_t words = 4;

  bool negative() const { return static_cast<std::int64_t>(words_[words - 1]) < 0; }

  std::array<Word, words> words_{};  ///< lowest first
};

/// A coordinate of an arm: the exact sum of two doubles, its own where an operation of the sum overflows.
Rounded difference(double a, double b) {
  const Rounded d = exact_sum(b, -a);
  return std::isfinite(d.result) && std::isfinite(d.error) ? d : Rounded{b, -a};
}

Vec3<Rounded> exact_arm(const Point3& o, const Point3& p) {
  return {difference(o.x, p.x), difference(o.y, p.y), difference(o.z, p.z)};
}

Vec3<Rounded> exact_arm(const Point3&, const Direction& d) { return {{d.v.x, 0}, {d.v.y, 0}, {d.v.z, 0}}; }

/// The eight products that x·y·z comes to, without those that are zero.
void add_products(ProductSum& sum, const Rounded& x, const Rounded& y, const Rounded& z, bool negative) {
  for (const double i : {x.result, x.error}) {
    for (const double j : {y.result, y.error}) {
      for (const double k : {z.result, z.error}) {
        if (i != 0 && j != 0 && k != 0) sum.add(i, j, k, negative);
      }
    }
  }
}

template <class X>
Sign volume_sign(const Point3& a, const Point3& b, const Point3& c, const X& x) {
  if (const auto s = volume_by_bound(a, b, c, x)) return *s;
  const Vec3<Rounded> u = exact_arm(a, b), v = exact_arm(a, c), w = exact_arm(a, x);
  ProductSum sum;
  add_products(sum, u.x, v.y, w.z, false);
  add_products(sum, u.x, v.z, w.y, true);
  add_products(sum, u.y, v.z, w.x, false);
  add_products(sum, u.y, v.x, w.z, true);
  add_products(sum, u.z, v.x, w.y, false);
  add_products(sum, u.z, v.y, w.x, true);
  return sum.sign();
}

template <class X>
Sign area_sign(Axis dropped, const Point3& a, const Point3& b, const X& x) {
  if (const auto s = area_by_bound(dropped, a, b, x)) return *s;
  const Vec2<Rounded> f = project<Rounded>(exact_arm(a, b), dropped), g = project<Rounded>(exact_arm(a, x), dropped);
  ProductSum sum;
  add_products(sum, f.u, g.v, {1, 0}, false);
  add_products(sum, f.v, g.u, {1, 0}, true);
  return sum.sign();
}

}  // namespace

void ProductSum::add(double x, double y, double z, bool negative) {
  const Decoded a = decoded(x), b = decoded(y), c = decoded(z);
  const Wide ab = Wide{a.significand} * b.significand;
  const Wide low = Wide{static_cast<Word>(ab)} * c.significand;
  const Wide high = Wide{static_cast<Word>(ab >> 64)} * c.significand + static_cast<Word>(low >> 64);
  const bool minus = std::signbit(x) != std::signbit(y);
  products_[count_++] = {a.unit + b.unit + c.unit,
                         (minus != std::signbit(z)) != negative,
                         {static_cast<Word>(low), static_cast<Word>(high), static_cast<Word>(high >> 64)}};
}

Sign ProductSum::sign() {
  constexpr int decided = 168;
  std::array<int, most> order;  // unit · 64 + index
  for (std::size_t i = 0; i < count_; ++i) order[i] = products_[i].unit * 64 + static_cast<int>(i);
  std::sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count_), std::greater<>());
  Accumulator sum;
  int unit = 0;
  for (std::size_t i = 0; i < count_; ++i) {
    const Product& next = products_[static_cast<std::size_t>(order[i] & 63)];
    if (const int bits = sum.bits(); bits > 0) {
      if (bits + unit - next.unit > decided) return sum.sign();
      sum.shift_left(unit - next.unit);
    }
    unit = next.unit;
    sum.add(next.magnitude, next.negative);
  }
  return sum.sign();
}

Sign ProductSumKernel::orient3d(const Point3& a, const Point3& b, const Point3& c, const Point3& x) const {
  return volume_sign(a, b, c, x);
}

Sign ProductSumKernel::orient3d(const Point3& a, const Point3& b, const Point3& c, const Direction& x) const {
  return volume_sign(a, b, c, x);
}

Sign ProductSumKernel::orient2d(Axis dropped, const Point3& a, const Point3& b, const Point3& x) const {
  return area_sign(dropped, a, b, x);
}

Sign ProductSumKernel::orient2d(Axis dropped, const Point3& a, const Point3& b, const Direction& x) const {
  return area_sign(dropped, a, b, x);
}

Sign ProductSumKernel::compare_hits(const Ray& r, const Triangle& s, const Triangle& t) const {
  return RationalKernel{}.compare_hits(r, s, t);
}

Sign ProductSumKernel::orient3d(const Point3& a, const Point3& b, const Point3& c, const RayPoint& x) const {
  if (const auto s = volume_by_bound(a, b, c, x)) return *s;
  return RationalKernel{}.orient3d(a, b, c, x);
}

Sign ProductSumKernel::orient2d(Axis dropped, const Point3& a, const Point3& b, const RayPoint& x) const {
  if (const auto s = area_by_bound(dropped, a, b, x)) return *s;
  return RationalKernel{}.orient2d(dropped, a, b, x);
}

Sign ProductSumKernel::compare(Axis axis, const Point3& a, const RayPoint& x) const {
  return RationalKernel{}.compare(axis, a, x);
}

}  // namespace tribunal
