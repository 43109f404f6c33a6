#include "exact/filtered/filtered_kernel.h"

#include <bit>
#include <cstdint>

#include "exact/filtered/filter.h"
#include "exact/filtered/stages/exact_stages.h"
#include "exact/filtered/term_filter.h"
#include "exact/filtered/within_filter.h"

namespace tribunal {

using namespace detail;

namespace {

/// The operands of one sign; X is a point or a direction.
template <class X>
struct Operands {
  Point3 a, b, c;
  X x;

  bool move_to_grid(int bits) {
    if constexpr (std::is_same_v<X, Direction>) {
      return tribunal::move_to_grid({&a, &b, &c}, &x, bits);
    } else {
      return tribunal::move_to_grid({&a, &b, &c, &x}, nullptr, bits);
    }
  }
};

struct Hits {
  Ray ray;
  Triangle s, t;

  bool move_to_grid(int bits) {
    return tribunal::move_to_grid({&ray.o, &s.a, &s.b, &s.c, &t.a, &t.b, &t.c}, &ray.d, bits);
  }
};

template <class X>
Staged<Sign> exact_orient3d(const Point3& a, const Point3& b, const Point3& c, const X& x) {
  return decide_exactly(Operands<X>{a, b, c, x},
                        [](const auto& o, const auto& k) { return k.orient3d(o.a, o.b, o.c, o.x); });
}

template <class X>
Staged<Sign> staged_orient3d(const Point3& a, const Point3& b, const Point3& c, const X& x) {
  if (const auto sign = filter_orient3d(a, b, c, x, volume_filter)) return {*sign, Stage::filter};
  if (const auto sign = filter_orient3d_by_terms(a, b, c, x, volume_terms_filter)) return {*sign, Stage::filter};
  return exact_orient3d(a, b, c, x);
}

Point3 without(Axis dropped, Point3 p) {
  p[static_cast<int>(dropped)] = 0;
  return p;
}

Direction without(Axis dropped, const Direction& d) { return {without(dropped, d.v)}; }

template <class X>
Staged<Sign> staged_orient2d(Axis dropped, const Point3& a, const Point3& b, const X& x) {
  if (const auto sign = filter_orient2d(dropped, a, b, x, area_filter)) return {*sign, Stage::filter};
  const Point3 flat = without(dropped, a);
  return decide_exactly(Operands<X>{flat, without(dropped, b), flat, without(dropped, x)},
                        [=](const auto& o, const auto& k) { return k.orient2d(dropped, o.a, o.b, o.x); });
}

/// An integer for each finite double, in the same order: comparing these does not depend on the floating-point
/// environment.
std::int64_t rank(double x) {
  const auto pattern = std::bit_cast<std::int64_t>(x);
  return pattern >= 0 ? pattern : INT64_MIN - pattern;
}

}  // namespace

Sign FilteredKernel::orient3d(const Point3& a, const Point3& b, const Point3& c, const Point3& x) const {
  const auto [sign, stage] = staged_orient3d(a, b, c, x);
  return counted(sign, stage);
}

Sign FilteredKernel::orient3d(const Point3& a, const Point3& b, const Point3& c, const Direction& x) const {
  const auto [sign, stage] = staged_orient3d(a, b, c, x);
  return counted(sign, stage);
}

Sign FilteredKernel::orient2d(Axis dropped, const Point3& a, const Point3& b, const Point3& x) const {
  const auto [sign, stage] = staged_orient2d(dropped, a, b, x);
  return counted(sign, stage);
}

Sign FilteredKernel::orient2d(Axis dropped, const Point3& a, const Point3& b, const Direction& x) const {
  const auto [sign, stage] = staged_orient2d(dropped, a, b, x);
  return counted(sign, stage);
}

Sign FilteredKernel::compare(Axis axis, const Point3& a, const Point3& x) const {
  const int i = static_cast<int>(axis);
  const std::int64_t from = rank(a[i]), to = rank(x[i]);
  return counted(to > from ? Sign::positive : to < from ? Sign::negative : Sign::zero, Stage::filter);
}

Sign FilteredKernel::compare(Axis axis, const Point3&, const Direction& x) const {
  return counted(sign_of(rank(x.v[static_cast<int>(axis)])), Stage::filter);
}

Sign FilteredKernel::compare_hits(const Ray& r, const Triangle& s, const Triangle& t) const {
  if (const auto sign = filter_compare_hits(r, s, t, order_filter, volume_filter)) return counted(*sign, Stage::filter);
  if (const auto sign = filter_compare_hits_by_terms(r, s, t, order_terms_filter, volume_terms_filter)) {
    return counted(*sign, Stage::filter);
  }
  const auto [sign, stage] =
      decide_exactly<2>(Hits{r, s, t}, [](const auto& o, const auto& k) { return k.compare_hits(o.ray, o.s, o.t); });
  return counted(sign, stage);
}

Sign FilteredKernel::orient3d(const Point3& a, const Point3& b, const Point3& c, const RayPoint& x) const {
  if (const auto sign = SidesAlongRay(x.ray, {a, b, c}).at(x.t)) return counted(*sign, Stage::filter);
  const DefaultRounding in_this_scope;
  return counted(RationalKernel{}.orient3d(a, b, c, x), Stage::exact);
}

Sign FilteredKernel::orient2d(Axis dropped, const Point3& a, const Point3& b, const RayPoint& x) const {
  const DefaultRounding in_this_scope;
  return counted(RationalKernel{}.orient2d(dropped, a, b, x), Stage::exact);
}

Sign FilteredKernel::compare(Axis axis, const Point3& a, const RayPoint& x) const {
  const DefaultRounding in_this_scope;
  return counted(RationalKernel{}.compare(axis, a, x), Stage::exact);
}

Sign orient3d_exactly(const Triangle& t, const Point3& x) { return exact_orient3d(t.a, t.b, t.c, x).result; }

Sign orient3d_exactly(const Triangle& t, const Direction& x) { return exact_orient3d(t.a, t.b, t.c, x).result; }

}  // namespace tribunal
