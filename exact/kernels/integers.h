// Five points as integers, each axis times one power of two, where integers of a fixed width hold every volume.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/operands.h"
#include "exact/kernels/bounded_integer.h"
#include "exact/kernels/dyadic.h"

namespace tribunal {

__extension__ using Wide = __int128;

/// Each coordinate of a point is m·2^shift with |m| < 2^bits, with a shift for each axis; that of a direction has
/// `of_direction` on top, which does not turn it.
struct IntegerForm {
  std::array<int, 3> shift{};
  int of_direction = 0;
  int bits = 0;

  Point3 operator()(const Point3& p) const { return moved(p, 0); }
  Direction operator()(const Direction& d) const { return {moved(d.v, of_direction)}; }
  Triangle operator()(const Triangle& t) const { return {(*this)(t.a), (*this)(t.b), (*this)(t.c)}; }
  Segment operator()(const Segment& s) const { return {(*this)(s.p), (*this)(s.q)}; }
  Ray operator()(const Ray& r) const { return {(*this)(r.o), (*this)(r.d)}; }

 private:
  Point3 moved(const Point3& p, int more) const {
    return {apply(p.x, shift[0] + more), apply(p.y, shift[1] + more), apply(p.z, shift[2] + more)};
  }

  /// x/2^shift, an integer. The factor is a normal number, or else the C library does it.
  static double apply(double x, int by) {
    if (std::abs(by) > 1022) return std::ldexp(x, -by);
    return x * std::bit_cast<double>(static_cast<std::uint64_t>(1023 - by) << 52);
  }
};

/// Exponents of the lowest and the highest bit of any number seen.
class BitRange {
 public:
  void see(double x) {
    const auto word = std::bit_cast<std::uint64_t>(x);
    const int biased = static_cast<int>(word >> 52 & 0x7ff);
    const std::uint64_t fraction = word & 0xfffffffffffff;
    const std::uint64_t m = biased == 0 ? fraction : fraction | std::uint64_t{1} << 52;
    if (m == 0) return;
    const int unit = std::max(biased, 1) - 1075;
    lowest_ = std::min(lowest_, unit + std::countr_zero(m));
    highest_ = std::max(highest_, unit + 63 - std::countl_zero(m));
  }

  bool saw_zeros_alone() const { return lowest_ > highest_; }
  int lowest() const { return lowest_; }
  int highest() const { return highest_; }
  int bits() const { return saw_zeros_alone() ? 0 : highest_ - lowest_ + 1; }

  /// The range of all numbers divided by 2^by.
  void add(const BitRange& other, int by) {
    if (other.saw_zeros_alone()) return;
    lowest_ = std::min(lowest_, other.lowest_ - by);
    highest_ = std::max(highest_, other.highest_ - by);
  }

 private:
  int lowest_ = std::numeric_limits<int>::max(), highest_ = std::numeric_limits<int>::min();
};

namespace integers_detail {

inline const Point3* end_of(const Segment& s) { return &s.q; }
inline const Point3* end_of(const Ray&) { return nullptr; }
inline const Direction* direction_of(const Segment&) { return nullptr; }
inline const Direction* direction_of(const Ray& r) { return &r.d; }

}  // namespace integers_detail

template <class P>
IntegerForm integer_form(const P& probe, const Triangle& t) {
  const Point3* const end = integers_detail::end_of(probe);
  const Direction* const direction = integers_detail::direction_of(probe);
  IntegerForm form;
  BitRange headings;
  for (int axis = 0; axis < 3; ++axis) {
    BitRange range, heading;
    for (const Point3* p : {&t.a, &t.b, &t.c, &source(probe), end}) {
      if (p != nullptr) range.see((*p)[axis]);
    }
    if (direction != nullptr) heading.see(direction->v[axis]);
    const BitRange& scale = range.saw_zeros_alone() ? heading : range;
    const int shift = scale.saw_zeros_alone() ? 0 : scale.lowest();
    form.shift[static_cast<std::size_t>(axis)] = shift;
    form.bits = std::max(form.bits, range.bits());
    headings.add(heading, shift);
  }
  if (!headings.saw_zeros_alone()) form.of_direction = headings.lowest();
  form.bits = std::max(form.bits, headings.bits());
  return form;
}

/// f.template operator()<N>(probe, triangle) with the smallest exact N for these operands: an `Integer` of so many
/// bits on the operands scaled to integers, else GMP dyadics. What f decides must not change where an axis, or the
/// direction, is scaled by a positive factor.
template <template <int> class Integer = BoundedInteger, class P, class F>
auto with_exact_number(const P& probe, const Triangle& t, const F& f) {
  const IntegerForm form = integer_form(probe, t);
  if (form.bits <= 19) return f.template operator()<Integer<19>>(form(probe), form(t));  // volumes in one word
  if (form.bits <= 40) return f.template operator()<Integer<40>>(form(probe), form(t));  // in two
  if (form.bits <= 61) return f.template operator()<Integer<61>>(form(probe), form(t));  // in three
  if (form.bits <= 125) return f.template operator()<Integer<125>>(form(probe), form(t));
  if (form.bits <= 253) return f.template operator()<Integer<253>>(form(probe), form(t));
  return f.template operator()<Dyadic>(probe, t);
}

}  // namespace tribunal
