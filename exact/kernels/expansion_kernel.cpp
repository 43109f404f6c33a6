#include "exact/kernels/expansion_kernel.h"

#include <cmath>
#include <optional>
#include <type_traits>
#include <vector>

#include "exact/kernels/expansion.h"
#include "exact/kernels/expansion_range.h"
#include "exact/kernels/rational_kernel.h"

namespace tribunal {
namespace {

using namespace detail;

/// A number type that adds where others subtract: the formula on the magnitudes of its operands is then its permanent,
/// the sum of the magnitudes of its monomials.
struct Magnitude {
  double value = 0;

  Magnitude() = default;
  explicit Magnitude(double x) : value(std::fabs(x)) {}

  friend Magnitude operator+(const Magnitude& a, const Magnitude& b) { return Magnitude(a.value + b.value); }
  friend Magnitude operator-(const Magnitude& a, const Magnitude& b) { return Magnitude(a.value + b.value); }
  friend Magnitude operator*(const Magnitude& a, const Magnitude& b) { return Magnitude(a.value * b.value); }
};

Vec3<Magnitude> magnitudes(const Vec3<double>& v) { return {Magnitude(v.x), Magnitude(v.y), Magnitude(v.z)}; }

/// A formula in double, with its permanent.
struct Estimate {
  double value, permanent;

  /// The sign, if |value| > operations·u·permanent, where u = 2⁻⁵³ and `operations` is one more than the most roundings
  /// that a monomial goes through.
  ///
  /// A monomial that goes through n roundings comes out as itself times a factor within (1 ± u)ⁿ, if nothing underflows
  /// or overflows. So value is off by at most ((1 + u)ⁿ − 1)·P, P the exact permanent; and the computed one is at least
  /// (1 − u)ⁿ·P. The quotient is below n·u·(1 + 2n·u), and the bound's own rounding adds a factor 1 + u: together less
  /// than (n + 1)·u for n < 2²⁰.
  std::optional<Sign> certain(int operations) const {
    if (std::fabs(value) > operations * 0x1p-53 * permanent) return sign_of(value);
    return permanent == 0 ? std::optional(Sign::zero) : std::nullopt;
  }
};

/// n = 8: three differences, two products, and the sums of a minor and of two more minors.
constexpr int volume_operations = 9;
/// n = 4: two differences, a product, a sum.
constexpr int area_operations = 5;
/// n = 18: two volumes, their product, a sum.
constexpr int order_operations = 19;

Estimate volume_of(const Vec3<double>& u, const Vec3<double>& v, const Vec3<double>& w) {
  return {det3(u, v, w), det3(magnitudes(u), magnitudes(v), magnitudes(w)).value};
}

template <class X>
Estimate estimated_volume(const Point3& a, const Point3& b, const Point3& c, const X& x) {
  const Vec3<double> o = lift<double>(a);
  return volume_of(arm<double>(o, b), arm<double>(o, c), arm<double>(o, x));
}

template <class X>
Estimate estimated_area(Axis dropped, const Point3& a, const Point3& b, const X& x) {
  const Vec3<double> o = lift<double>(a);
  const Vec2<double> f = project<double>(arm<double>(o, b), dropped), g = project<double>(arm<double>(o, x), dropped);
  return {f.u * g.v - f.v * g.u, std::fabs(f.u * g.v) + std::fabs(f.v * g.u)};
}

/// The operands of one sign, to be moved; X is a point or a direction.
template <class X>
struct Operands {
  Point3 a, b, c;
  X x;

  bool are_within(const ExpansionRange& range) const {
    if constexpr (std::is_same_v<X, Direction>)
      return is_within(range, {&a, &b, &c}, &x);
    else
      return is_within(range, {&a, &b, &c, &x}, nullptr);
  }
  bool bring_within(const ExpansionRange& range) {
    if constexpr (std::is_same_v<X, Direction>)
      return detail::bring_within(range, {&a, &b, &c}, &x);
    else
      return detail::bring_within(range, {&a, &b, &c, &x}, nullptr);
  }
};

struct Hits {
  Ray ray;
  Triangle s, t;

  bool are_within(const ExpansionRange& range) const {
    return is_within(range, {&ray.o, &s.a, &s.b, &s.c, &t.a, &t.b, &t.c}, &ray.d);
  }
  bool bring_within(const ExpansionRange& range) {
    return detail::bring_within(range, {&ray.o, &s.a, &s.b, &s.c, &t.a, &t.b, &t.c}, &ray.d);
  }
};

/// Volumes and areas on expansions, and the order of two hits on volumes in few terms.
struct ExactKernel : FormulaKernel<VolumeExpansion> {
  Sign compare_hits(const Ray& r, const Triangle& s, const Triangle& t) const {
    const HitParameter<LongExpansion> f = parameter(r, s), g = parameter(r, t);
    return sign_of(f.num * g.den - g.num * f.den) * sign_of(f.den) * sign_of(g.den);
  }

 private:
  static HitParameter<LongExpansion> parameter(const Ray& r, const Triangle& t) {
    const HitParameter<VolumeExpansion> p = hit_parameter<VolumeExpansion>(r, t);
    return {p.num.compressed<std::vector<double>>(), p.den.compressed<std::vector<double>>()};
  }
};

static_assert(Kernel<ExactKernel>);

/// The sign by the first who can tell. `estimate` gives it, or nothing, from operands in the range; `sign` asks a
/// kernel.
template <class Operands, class Estimated, class Asked>
Sign decide(const ExpansionRange& range, Operands o, const Estimated& estimate, const Asked& sign,
            ExpansionTally* tally) {
  ExpansionTally unheeded;
  ExpansionTally& decided = tally != nullptr ? *tally : unheeded;
  if (!o.are_within(range) && !o.bring_within(range)) {
    ++decided.dyadic;
    return sign(o, RationalKernel{});
  }
  if (const std::optional<Sign> s = estimate(o)) {
    ++decided.bound;
    return *s;
  }
  ++decided.expansions;
  return sign(o, ExactKernel{});
}

template <class X>
Sign adaptive_orient3d(const Point3& a, const Point3& b, const Point3& c, const X& x, ExpansionTally* tally) {
  return decide(
      volume_range, Operands<X>{a, b, c, x},
      [](const auto& o) { return estimated_volume(o.a, o.b, o.c, o.x).certain(volume_operations); },
      [](const auto& o, const auto& k) { return k.orient3d(o.a, o.b, o.c, o.x); }, tally);
}

Point3 without(Axis dropped, Point3 p) {
  p[static_cast<int>(dropped)] = 0;
  return p;
}

Direction without(Axis dropped, const Direction& d) { return {without(dropped, d.v)}; }

/// What the dropped axis has is of no account, and must not keep the operands out of the range.
template <class X>
Sign adaptive_orient2d(Axis dropped, const Point3& a, const Point3& b, const X& x, ExpansionTally* tally) {
  const Point3 flat = without(dropped, a);
  return decide(
      volume_range, Operands<X>{flat, without(dropped, b), flat, without(dropped, x)},
      [=](const auto& o) { return estimated_area(dropped, o.a, o.b, o.x).certain(area_operations); },
      [=](const auto& o, const auto& k) { return k.orient2d(dropped, o.a, o.b, o.x); }, tally);
}

/// A volume that has the factor of a ray's parameter: the numerator, or the denominator but for its sign.
template <class X>
Estimate estimated_volume(const Triangle& t, const X& x) {
  return estimated_volume(t.a, t.b, t.c, x);
}

/// n₁/d₁ − n₂/d₂ as in core/kernel.h, with the minus of both denominators left out: they turn the first sign twice.
std::optional<Sign> estimated_order(const Hits& h) {
  const Estimate n1 = estimated_volume(h.s, h.ray.o), d1 = estimated_volume(h.s, h.ray.d);
  const Estimate n2 = estimated_volume(h.t, h.ray.o), d2 = estimated_volume(h.t, h.ray.d);
  const Estimate difference{n2.value * d1.value - n1.value * d2.value,
                            n2.permanent * d1.permanent + n1.permanent * d2.permanent};
  const auto sign = difference.certain(order_operations);
  const auto sign1 = d1.certain(volume_operations), sign2 = d2.certain(volume_operations);
  if (!sign || !sign1 || !sign2) return std::nullopt;
  return *sign * *sign1 * *sign2;
}

}  // namespace

Sign ExpansionKernel::orient3d(const Point3& a, const Point3& b, const Point3& c, const Point3& x) const {
  return adaptive_orient3d(a, b, c, x, tally_);
}

Sign ExpansionKernel::orient3d(const Point3& a, const Point3& b, const Point3& c, const Direction& x) const {
  return adaptive_orient3d(a, b, c, x, tally_);
}

Sign ExpansionKernel::orient2d(Axis dropped, const Point3& a, const Point3& b, const Point3& x) const {
  return adaptive_orient2d(dropped, a, b, x, tally_);
}

Sign ExpansionKernel::orient2d(Axis dropped, const Point3& a, const Point3& b, const Direction& x) const {
  return adaptive_orient2d(dropped, a, b, x, tally_);
}

Sign ExpansionKernel::compare_hits(const Ray& r, const Triangle& s, const Triangle& t) const {
  return decide(
      order_range, Hits{r, s, t}, estimated_order,
      [](const Hits& h, const auto& k) { return k.compare_hits(h.ray, h.s, h.t); }, tally_);
}

}  // namespace tribunal
