#include "exact/kernels/expansion_kernel.h"

#include <cmath>
#include <optional>
#include <type_traits>
#include <vector>

#include "exact/kernels/expansion.h"
#include "exact/kernels/expansion_bound.h"
#include "exact/kernels/expansion_range.h"
#include "exact/kernels/rational_kernel.h"

namespace tribunal {
namespace {

using namespace detail;

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

/// Only asked where nothing underflows. n₁/d₁ − n₂/d₂ as in core/kernel.h, with the minus of both denominators left
/// out: they turn the first sign twice.
std::optional<Sign> order_by_bound(const Hits& h) {
  const Triangle &s = h.s, &t = h.t;
  const Estimate n1 = estimated_volume(s.a, s.b, s.c, h.ray.o), d1 = estimated_volume(s.a, s.b, s.c, h.ray.d);
  const Estimate n2 = estimated_volume(t.a, t.b, t.c, h.ray.o), d2 = estimated_volume(t.a, t.b, t.c, h.ray.d);
  const Estimate difference{n2.value * d1.value - n1.value * d2.value,
                            n2.permanent * d1.permanent + n1.permanent * d2.permanent};
  const auto sign = certain(difference, order_operations, 0);
  const auto sign1 = certain(d1, volume_operations, 0), sign2 = certain(d2, volume_operations, 0);
  if (!sign || !sign1 || !sign2) return std::nullopt;
  return *sign * *sign1 * *sign2;
}

/// The sign by expansions, or by GMP where the operands cannot be moved into the range. `sign` asks a kernel.
template <class Operands, class Asked>
Sign exactly(const ExpansionRange& range, Operands o, const Asked& sign, ExpansionTally& tally) {
  if (o.are_within(range) || o.bring_within(range)) {
    ++tally.expansions;
    return sign(o, ExactKernel{});
  }
  ++tally.dyadic;
  return sign(o, RationalKernel{});
}

Sign by_bound(Sign s, ExpansionTally& tally) {
  ++tally.bound;
  return s;
}

template <class X>
Sign adaptive_orient3d(const Point3& a, const Point3& b, const Point3& c, const X& x, ExpansionTally& tally) {
  if (const auto s = volume_by_bound(a, b, c, x)) return by_bound(*s, tally);
  return exactly(
      volume_range, Operands<X>{a, b, c, x},
      [](const auto& o, const auto& k) { return k.orient3d(o.a, o.b, o.c, o.x); }, tally);
}

Point3 without(Axis dropped, Point3 p) {
  p[static_cast<int>(dropped)] = 0;
  return p;
}

Direction without(Axis dropped, const Direction& d) { return {without(dropped, d.v)}; }

/// What the dropped axis has is of no account, and must not keep the operands out of the range.
template <class X>
Sign adaptive_orient2d(Axis dropped, const Point3& a, const Point3& b, const X& x, ExpansionTally& tally) {
  if (const auto s = area_by_bound(dropped, a, b, x)) return by_bound(*s, tally);
  const Point3 flat = without(dropped, a);
  return exactly(
      volume_range, Operands<X>{flat, without(dropped, b), flat, without(dropped, x)},
      [=](const auto& o, const auto& k) { return k.orient2d(dropped, o.a, o.b, o.x); }, tally);
}

Sign adaptive_order(const Hits& h, ExpansionTally& tally) {
  if (h.are_within(order_range)) {
    if (const auto s = order_by_bound(h)) return by_bound(*s, tally);
  }
  return exactly(
      order_range, h, [](const auto& o, const auto& k) { return k.compare_hits(o.ray, o.s, o.t); }, tally);
}

}  // namespace

Sign ExpansionKernel::orient3d(const Point3& a, const Point3& b, const Point3& c, const Point3& x) const {
  return counted([&](auto& tally) { return adaptive_orient3d(a, b, c, x, tally); });
}

Sign ExpansionKernel::orient3d(const Point3& a, const Point3& b, const Point3& c, const Direction& x) const {
  return counted([&](auto& tally) { return adaptive_orient3d(a, b, c, x, tally); });
}

Sign ExpansionKernel::orient2d(Axis dropped, const Point3& a, const Point3& b, const Point3& x) const {
  return counted([&](auto& tally) { return adaptive_orient2d(dropped, a, b, x, tally); });
}

Sign ExpansionKernel::orient2d(Axis dropped, const Point3& a, const Point3& b, const Direction& x) const {
  return counted([&](auto& tally) { return adaptive_orient2d(dropped, a, b, x, tally); });
}

Sign ExpansionKernel::compare_hits(const Ray& r, const Triangle& s, const Triangle& t) const {
  return counted([&](auto& tally) { return adaptive_order({r, s, t}, tally); });
}

Sign ExpansionKernel::orient3d(const Point3& a, const Point3& b, const Point3& c, const RayPoint& x) const {
  return counted([&](auto& tally) {
    if (const auto s = volume_by_bound(a, b, c, x)) return by_bound(*s, tally);
    ++tally.dyadic;
    return RationalKernel{}.orient3d(a, b, c, x);
  });
}

Sign ExpansionKernel::orient2d(Axis dropped, const Point3& a, const Point3& b, const RayPoint& x) const {
  return counted([&](auto& tally) {
    if (const auto s = area_by_bound(dropped, a, b, x)) return by_bound(*s, tally);
    ++tally.dyadic;
    return RationalKernel{}.orient2d(dropped, a, b, x);
  });
}

Sign ExpansionKernel::compare(Axis axis, const Point3& a, const RayPoint& x) const {
  return RationalKernel{}.compare(axis, a, x);
}

}  // namespace tribunal
