// Signs on a grid of machine words: the formulas of core/signed_volume.h with each intermediate result in the
// narrowest integer that holds it. FormulaKernel<FixedInteger<3>> gives the same signs in almost three times the time.
#pragma once

#include <cstdint>

#include "core/kernel.h"
#include "exact/filtered/stages/fixed_integer.h"

namespace tribunal {

/// Exact where all coordinates are integers of magnitude below 2⁶¹.
class GridKernel {
 public:
  template <class X>
  Sign orient3d(const Point3& a, const Point3& b, const Point3& c, const X& x) const {
    const Vec3<Word> o = lift<Word>(a);
    return volume_sign(arm<Word>(o, b), arm<Word>(o, c), arm<Word>(o, x));
  }

  template <class X>
  Sign orient2d(Axis dropped, const Point3& a, const Point3& b, const X& x) const {
    const Vec3<Word> o = lift<Word>(a);
    const Vec2<Word> f = project<Word>(arm<Word>(o, b), dropped), g = project<Word>(arm<Word>(o, x), dropped);
    return sign_of(minor(f.u, g.v, f.v, g.u));
  }

  template <class X>
  Sign compare(Axis axis, const Point3& a, const X& x) const {
    return sign_of(signed_length<Word>(axis, a, x));
  }

  Sign compare_hits(const Ray& r, const Triangle& s, const Triangle& t) const {
    return order_of_hits<FixedInteger<6>>(r, s, t);
  }

 private:
  using Word = std::int64_t;
  __extension__ using Wide = __int128;
  __extension__ using Unsigned = unsigned __int128;

  /// a·b − c·d. Differences are below 2⁶², so a minor is below 2¹²⁵.
  static Wide minor(Word a, Word b, Word c, Word d) { return Wide{a} * b - Wide{c} * d; }

  /// high·2⁶⁴ + low.
  struct Product {
    Wide high;
    std::uint64_t low;
  };

  static Product times(Word a, Wide m) {
    const Wide low = Wide{a} * static_cast<std::uint64_t>(m);
    return {Wide{a} * static_cast<Word>(m >> 64) + (low >> 64), static_cast<std::uint64_t>(low)};
  }

  /// det(u, v, w), expanded along its first row.
  static Sign volume_sign(const Vec3<Word>& u, const Vec3<Word>& v, const Vec3<Word>& w) {
    const Product x = times(u.x, minor(v.y, w.z, v.z, w.y));
    const Product y = times(u.y, minor(v.z, w.x, v.x, w.z));
    const Product z = times(u.z, minor(v.x, w.y, v.y, w.x));
    const Unsigned low = Unsigned{x.low} + y.low + z.low;
    const Wide high = x.high + y.high + z.high + static_cast<Wide>(low >> 64);
    return high != 0 ? sign_of(high) : static_cast<std::uint64_t>(low) != 0 ? Sign::positive : Sign::zero;
  }
};

static_assert(Kernel<GridKernel>);

}  // namespace tribunal
