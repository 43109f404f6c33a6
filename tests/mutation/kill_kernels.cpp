// Kills mutants of the exact kernels: returns 0 iff signs of volumes, areas, lengths and orders of hits are right over
// the whole range of binary64, of points, directions and points of rays. What is right is computed with GMP's
// fractions, and by whom it has to be decided by exponents that frexp gives.
#include <gmpxx.h>

#include <algorithm>
#include <climits>
#include <cmath>
#include <type_traits>

#include "exact/kernels/expansion_bound.h"
#include "exact/kernels/expansion_kernel.h"
#include "exact/kernels/expansion_range.h"
#include "exact/kernels/integers.h"
#include "exact/kernels/lattice_kernel.h"
#include "exact/kernels/product_sum.h"
#include "exact/kernels/rational_kernel.h"
#include "tests/mutation/kill.h"

using namespace tribunal;
using namespace tribunal::killing;

void check_numbers();

namespace {

const FormulaKernel<mpq_class> oracle;

/// The exponents of the lowest and highest bits of numbers, by frexp.
struct Bits {
  int lowest = INT_MAX, highest = INT_MIN;

  void see(double x, int by = 0) {
    if (x == 0) return;
    int e = 0;
    auto whole = static_cast<std::int64_t>(std::ldexp(std::frexp(x, &e), 53));
    highest = std::max(highest, e - 1 + by);
    for (e -= 53; whole % 2 == 0; ++e) whole /= 2;
    lowest = std::min(lowest, e + by);
  }
  bool any() const { return lowest <= highest; }
  int count() const { return any() ? highest - lowest + 1 : 0; }
};

/// The exponents of leading bits alone.
struct Leading {
  int lowest = INT_MAX, highest = INT_MIN;

  void see(double x, int by = 0) {
    if (x == 0) return;
    int e = 0;
    std::frexp(x, &e);
    lowest = std::min(lowest, e - 1 + by);
    highest = std::max(highest, e - 1 + by);
  }
  int span() const { return lowest <= highest ? highest - lowest : 0; }
};

// --- the range of expansions ----------------------------------------------------------------------------------------

bool lies_within(const detail::ExpansionRange& range, const Point3& p) {
  for (int axis = 0; axis < 3; ++axis) {
    const double x = std::fabs(p[axis]);
    if (x != 0 && (x < std::ldexp(1, range.least) || x >= std::ldexp(1, range.end))) return false;
  }
  return true;
}

/// Whether powers of two, one an axis and one for the direction, bring all coordinates within the range.
bool can_be_within(const detail::ExpansionRange& range, std::initializer_list<Point3> points, const Direction* d) {
  const int room = range.end - 1 - range.least;
  Leading of_direction;
  for (int axis = 0; axis < 3; ++axis) {
    Leading on_axis;
    for (const Point3& p : points) on_axis.see(p[axis]);
    if (on_axis.span() > room) return false;
    const int by = on_axis.lowest <= on_axis.highest ? range.end - 1 - on_axis.highest : 0;
    if (d != nullptr) of_direction.see(d->v[axis], by);
  }
  return of_direction.span() <= room;
}

/// Whether expansions can compute with the operands: as they are, or moved.
bool suit(const detail::ExpansionRange& range, std::initializer_list<Point3> points, const Direction* d) {
  const auto lies = [&](const Point3& p) { return lies_within(range, p); };
  return (std::all_of(points.begin(), points.end(), lies) && (d == nullptr || lies(d->v))) ||
         can_be_within(range, points, d);
}

void check_range(const detail::ExpansionRange& range, const Five& f, bool with_direction) {
  Point3 a = f.t.a, b = f.t.b;
  Direction d{f.q};
  Direction* const given = with_direction ? &d : nullptr;
  const bool lies = lies_within(range, a) && lies_within(range, b) && (!with_direction || lies_within(range, d.v));
  require(detail::is_within(range, {&a, &b}, given) == lies, "within the range");
  const bool can = can_be_within(range, {a, b}, given);
  require(detail::bring_within(range, {&a, &b}, given) == can, "can be brought within the range");
  if (!can) {
    require(a == f.t.a && b == f.t.b && d.v == f.q, "left as it was");
    return;
  }
  require(lies_within(range, a) && lies_within(range, b) && (!with_direction || lies_within(range, d.v)),
          "brought within");
  const mpq_class zero;
  for (int axis = 0; axis < 3; ++axis) {
    // a, b and the direction keep their proportions on the axis, and the direction its own over the axes.
    require(mpq_class(a[axis]) * mpq_class(f.t.b[axis]) == mpq_class(b[axis]) * mpq_class(f.t.a[axis]), "proportions");
    require(std::signbit(a[axis]) == std::signbit(f.t.a[axis]) && (a[axis] == 0) == (f.t.a[axis] == 0), "signs");
    require(std::signbit(d.v[axis]) == std::signbit(f.q[axis]) && (d.v[axis] == 0) == (f.q[axis] == 0), "direction");
  }
}

// --- signs ----------------------------------------------------------------------------------------------------------

ExpansionTally total;

/// The sign of one question, and that one of the three decided it: GMP only where expansions cannot.
template <class Ask>
void expect(const Ask& ask, Sign due, bool expansions_can, const char* what) {
  ExpansionTally tally;
  require(ask(ExpansionKernel(&tally)) == due && ask(ExpansionKernel()) == due, what);
  require(tally.bound + tally.expansions + tally.dyadic == 1, "one of three decides");
  if (tally.bound == 0) require((tally.expansions == 1) == expansions_can, "expansions where they can");
  require(ask(ProductSumKernel()) == due && ask(RationalKernel()) == due, what);
  total.bound += tally.bound, total.expansions += tally.expansions, total.dyadic += tally.dyadic;
}

template <class X>
const Direction* direction_in(const X& x) {
  if constexpr (std::is_same_v<X, Direction>) return &x;
  return nullptr;
}

/// Whether the operands of a sign can be brought within the range; `flat` drops an axis.
template <class X, class Flat>
bool can(const Triangle& t, const X& x, const Flat& flat) {
  if constexpr (std::is_same_v<X, RayPoint>) {
    return false;
  } else if constexpr (std::is_same_v<X, Direction>) {
    const Direction d{flat(x.v)};
    return suit(detail::volume_range, {flat(t.a), flat(t.b), flat(t.c)}, &d);
  } else {
    return suit(detail::volume_range, {flat(t.a), flat(t.b), flat(t.c), flat(x)}, nullptr);
  }
}

template <class X>
void expect_signs(const Triangle& t, const X& x) {
  expect([&](const auto& k) { return k.orient3d(t.a, t.b, t.c, x); }, oracle.orient3d(t.a, t.b, t.c, x),
         can(t, x, [](const Point3& p) { return p; }), "orient3d");
  for (const Axis axis : {Axis::x, Axis::y, Axis::z}) {
    const auto flat = [&](Point3 p) {
      p[static_cast<int>(axis)] = 0;
      return p;
    };
    expect([&](const auto& k) { return k.orient2d(axis, t.a, t.b, x); }, oracle.orient2d(axis, t.a, t.b, x),
           can(Triangle{t.a, t.b, t.a}, x, flat), "orient2d");
    const Sign length = oracle.compare(axis, t.a, x);
    require(ExpansionKernel().compare(axis, t.a, x) == length && ProductSumKernel().compare(axis, t.a, x) == length &&
                RationalKernel().compare(axis, t.a, x) == length,
            "compare");
  }
}

void expect_order(const Five& f, const Five& g) {
  const Ray r{f.p, {f.q}};
  const Triangle &s = f.t, &t = g.t;
  if (oracle.orient3d(s.a, s.b, s.c, r.d) == Sign::zero || oracle.orient3d(t.a, t.b, t.c, r.d) == Sign::zero) return;
  const bool fits = suit(detail::order_range, {r.o, s.a, s.b, s.c, t.a, t.b, t.c}, &r.d);
  const auto order = [&](const Triangle& u, const Triangle& v) {
    expect([&](const auto& k) { return k.compare_hits(r, u, v); }, oracle.compare_hits(r, u, v), fits, "order of hits");
  };
  order(s, t);
  order(t, s);
  const bool fits_twice = suit(detail::order_range, {r.o, s.a, s.b, s.c}, &r.d);
  expect([&](const auto& k) { return k.compare_hits(r, s, s); }, Sign::zero, fits_twice, "one hit");
}

/// Easy operands must not cost exact numbers.
void expect_bound() {
  Draw draw;
  for (int n = 0; n < 3'000; ++n) {
    const Triangle t = draw.triangle(9);
    const Point3 x = draw.point(9);
    const Sign volume = oracle.orient3d(t.a, t.b, t.c, x);
    const auto bound = detail::volume_by_bound(t.a, t.b, t.c, x);
    require(bound.has_value() == (volume != Sign::zero) && bound.value_or(Sign::zero) == volume, "volumes of integers");
    const auto area = detail::area_by_bound(Axis::z, t.a, t.b, Direction{x});
    const Sign due = oracle.orient2d(Axis::z, t.a, t.b, Direction{x});
    require(area.has_value() == (due != Sign::zero) && area.value_or(Sign::zero) == due, "areas of integers");
    const RayPoint p{{t.c, {x}}, 2};
    const auto at = detail::volume_by_bound(t.a, t.b, t.c, p);
    require(at.value_or(Sign::zero) == oracle.orient3d(t.a, t.b, t.c, p), "volumes of points of rays");
    const auto flat = detail::area_by_bound(Axis::x, t.a, t.b, p);
    require(flat.value_or(Sign::zero) == oracle.orient2d(Axis::x, t.a, t.b, p), "areas of points of rays");
  }
}

// --- sums of products -----------------------------------------------------------------------------------------------

/// Products of every kind, subnormal numbers among them, of which some are taken away again but for a last digit.
void expect_product_sums() {
  Draw draw;
  for (int n = 0; n < 6'000; ++n) {
    ProductSum sum;
    mpq_class due;
    double x[3] = {};
    bool negative = false;
    for (int i = draw.within(0, 6); i > 0; --i) {
      const bool again = draw.below(2) == 0;
      for (double& v : x) v = again ? v : draw.number(draw.below(3) == 0 ? n % Draw::kinds : 7);
      if (again && draw.below(2) == 0) x[0] = std::nextafter(x[0], 0);
      if (!is_finite(Point3(x[0], x[1], x[2]))) continue;
      negative = again ? !negative : draw.below(2) == 0;
      sum.add(x[0], x[1], x[2], negative);
      const mpq_class product = mpq_class(x[0]) * mpq_class(x[1]) * mpq_class(x[2]);
      due += negative ? mpq_class(-product) : product;
    }
    require(sum.sign() == static_cast<Sign>(sgn(due)), "a sum of products");
  }
  constexpr double least = 5e-324;
  for (const int shift : {1, 63, 64, 65, 100, 128}) {
    ProductSum sum;  // −1 unit, and less than that at so many bits below
    sum.add(std::ldexp(least, 10), std::ldexp(1.0, 52 + shift), least, true);
    sum.add(std::ldexp(least, 9), 0x1p52, least, false);
    require(sum.sign() == Sign::negative, "a sum of products far apart");
  }
  ProductSum one;
  one.add(least, least, least, true);
  one.add(least, least, least, true);
  require(one.sign() == Sign::negative, "the least sum");
}

/// Differences that overflow, and one of which the error alone does.
void expect_overflow() {
  constexpr double most = std::numeric_limits<double>::max(), odd = -(0x1p1022 + 0x3p970);
  for (int axis = 0; axis < 3; ++axis) {
    for (const double far : {odd, most, -odd}) {
      const auto turned = [&](const Point3& p) {
        return Point3(p[(3 - axis) % 3], p[(4 - axis) % 3], p[(5 - axis) % 3]);
      };
      const Triangle t{turned({-most, 0, 0}), turned({far, 1, 0}), turned({far, 1, 1})};
      expect_signs(t, turned({far, 1, 0.5}));
      expect_signs(t, turned({odd, 2, 0.5}));
      expect_signs(t, Direction{turned({far, 1, 0})});
    }
  }
}

// --- integers -------------------------------------------------------------------------------------------------------

template <class N>
struct WidthOf {
  static constexpr int bits = INT_MAX;
};
template <int B>
struct WidthOf<BoundedInteger<B>> {
  static constexpr int bits = B;
};

const Point3& end_of(const Segment& s) { return s.q; }
const Point3& end_of(const Ray& r) { return r.d.v; }

/// The narrowest integers that hold the operands, and the same signs on them.
template <class P>
void expect_integers(const P& probe, const Triangle& t) {
  constexpr bool is_ray = std::is_same_v<P, Ray>;
  int bits = 0;
  Bits headings;
  for (int axis = 0; axis < 3; ++axis) {
    Bits range, heading;
    for (const Point3* p : {&t.a, &t.b, &t.c, &source(probe)}) range.see((*p)[axis]);
    (is_ray ? heading : range).see(end_of(probe)[axis]);
    const Bits& scale = range.any() ? range : heading;
    bits = std::max(bits, range.count());
    if (heading.any()) {
      headings.lowest = std::min(headings.lowest, heading.lowest - scale.lowest);
      headings.highest = std::max(headings.highest, heading.highest - scale.lowest);
    }
  }
  bits = std::max(bits, headings.count());
  require(integer_form(probe, t).bits == bits, "bits");
  with_exact_number(probe, t, [&]<class N>(const P& p, const Triangle& u) {
    constexpr int widths[] = {19, 40, 61, 125, 253, INT_MAX};
    const int narrowest = *std::find_if(std::begin(widths), std::end(widths), [&](int w) { return bits <= w; });
    require(WidthOf<N>::bits == narrowest, "the narrowest integers");
    const typename ExactKernelOn<N>::Kernel k;
    require(k.orient3d(u.a, u.b, u.c, source(p)) == oracle.orient3d(t.a, t.b, t.c, source(probe)) &&
                k.orient3d(u.a, u.b, u.c, target(p)) == oracle.orient3d(t.a, t.b, t.c, target(probe)),
            "volumes on integers");
    for (const Axis axis : {Axis::x, Axis::y, Axis::z}) {
      require(k.orient2d(axis, u.a, u.b, target(p)) == oracle.orient2d(axis, t.a, t.b, target(probe)),
              "areas on integers");
      require(k.compare(axis, u.a, target(p)) == oracle.compare(axis, t.a, target(probe)), "lengths on integers");
    }
    if constexpr (is_ray) {
      if (k.orient3d(u.a, u.b, u.c, p.d) != Sign::zero)
        require(k.compare_hits(p, u, u) == Sign::zero, "order on integers");
    }
  });
}

}  // namespace

int main() {
  check_numbers();
  expect_bound();
  expect_product_sums();
  expect_overflow();
  Draw draw;
  Five before{};
  for (int n = 0; n < 12 * Draw::kinds * degeneracies; ++n) {
    const Five f = drawn(draw, n % Draw::kinds, n / Draw::kinds % degeneracies);
    const double at = std::fabs(draw.number(n % Draw::kinds));
    if (!f.finite()) continue;
    expect_signs(f.t, f.q);
    expect_signs(f.t, Direction{f.q});
    if (std::isfinite(at)) expect_signs(f.t, RayPoint{{f.p, {f.q}}, at});
    if (n % 3 == 0) expect_order(f, before);
    expect_integers(Segment{f.p, f.q}, f.t);
    expect_integers(Ray{f.p, {f.q}}, f.t);
    expect_integers(Ray{Point3(0), {f.q}}, {Point3(0), Point3(0), Point3(0)});
    for (const auto& range : {detail::volume_range, detail::order_range}) {
      check_range(range, f, false);
      check_range(range, f, true);
    }
    before = f;
  }
  require(total.bound > 0 && total.expansions > 0 && total.dyadic > 0, "every way was needed");
}
