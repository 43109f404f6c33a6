// Five points as integers times one power of two, where machine integers hold every volume.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/operands.h"
#include "exact/kernels/dyadic.h"

namespace tribunal {

__extension__ using Wide = __int128;

/// Coordinates of up to this many bits: differences have one more, a volume is at most six products of three
/// differences, so 3·(bits + 1) + 3 ≤ 63 and ≤ 127.
inline constexpr int bits_for_words = 19;
inline constexpr int bits_for_wide = 40;

/// Every coordinate is m·2^shift with |m| < 2^bits.
struct IntegerForm {
  int shift = 0;
  int bits = 0;

  double apply(double x) const { return std::ldexp(x, -shift); }
  Point3 operator()(const Point3& p) const { return {apply(p.x), apply(p.y), apply(p.z)}; }
  Direction operator()(const Direction& d) const { return {(*this)(d.v)}; }
  Triangle operator()(const Triangle& t) const { return {(*this)(t.a), (*this)(t.b), (*this)(t.c)}; }
  Segment operator()(const Segment& s) const { return {(*this)(s.p), (*this)(s.q)}; }
  Ray operator()(const Ray& r) const { return {(*this)(r.o), (*this)(r.d)}; }
};

/// Exponents of the lowest and the highest bit of any coordinate seen.
class BitRange {
 public:
  void see(const Point3& p) {
    for (int axis = 0; axis < 3; ++axis) see(p[axis]);
  }
  void see(const Direction& d) { see(d.v); }
  IntegerForm form() const { return lowest_ > highest_ ? IntegerForm{} : IntegerForm{lowest_, highest_ - lowest_ + 1}; }

 private:
  void see(double x) {
    if (x == 0) return;
    const auto word = std::bit_cast<std::uint64_t>(x);
    const int biased = static_cast<int>(word >> 52 & 0x7ff);
    const std::uint64_t fraction = word & 0xfffffffffffff;
    const std::uint64_t m = biased == 0 ? fraction : fraction | std::uint64_t{1} << 52;
    const int unit = std::max(biased, 1) - 1075;
    lowest_ = std::min(lowest_, unit + std::countr_zero(m));
    highest_ = std::max(highest_, unit + 63 - std::countl_zero(m));
  }

  int lowest_ = std::numeric_limits<int>::max(), highest_ = std::numeric_limits<int>::min();
};

template <class P>
IntegerForm integer_form(const P& probe, const Triangle& t) {
  BitRange range;
  range.see(t.a);
  range.see(t.b);
  range.see(t.c);
  range.see(source(probe));
  range.see(target(probe));
  return range.form();
}

/// f.template operator()<N>(probe, triangle) with the smallest exact N for these operands: 64-bit or 128-bit integers
/// on the operands scaled to integers, else GMP dyadics. What f decides must not change under scaling.
template <class P, class F>
auto with_exact_number(const P& probe, const Triangle& t, const F& f) {
  const IntegerForm form = integer_form(probe, t);
  if (form.bits <= bits_for_words) return f.template operator()<std::int64_t>(form(probe), form(t));
  if (form.bits <= bits_for_wide) return f.template operator()<Wide>(form(probe), form(t));
  return f.template operator()<Dyadic>(probe, t);
}

}  // namespace tribunal
