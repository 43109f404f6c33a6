// Kills mutants of the certified test and of the kernel behind it: returns 0 iff answers, signs and stages are right
// over the whole range of binary64, in every rounding mode. What is right is computed with GMP's fractions, or, of a
// parameter, by another formula and MPFR.
#include <gmpxx.h>
#include <xmmintrin.h>

#include <stdexcept>

#include "core/due.h"
#include "core/segura_feito.h"
#include "exact/classes/class_table.h"
#include "exact/filtered/crossing.h"
#include "exact/filtered/double_double.h"
#include "exact/filtered/filter.h"
#include "exact/filtered/filtered.h"
#include "exact/filtered/filtered_kernel.h"
#include "exact/filtered/hit_fraction.h"
#include "exact/filtered/rounded_parameter.h"
#include "exact/filtered/stages/exact_stages.h"
#include "exact/filtered/term_filter.h"
#include "exact/filtered/within_filter.h"
#include "tests/exact/exact_parameter.h"
#include "tests/mutation/kill.h"

using namespace tribunal;
using namespace tribunal::detail;
using namespace tribunal::killing;

namespace {

const FormulaKernel<mpq_class> oracle;

struct EveryKind {
  Draw draw;

  /// Calls ask(five) for operands of every kind and degeneracy, as often as said.
  template <class Ask>
  void operator()(int rounds, const Ask& ask) {
    for (int n = 0; n < rounds * Draw::kinds * degeneracies; ++n) {
      const Five f = drawn(draw, n % Draw::kinds, n / Draw::kinds % degeneracies);
      if (f.finite()) ask(f);
    }
  }
};

// --- signs ----------------------------------------------------------------------------------------------------------

/// The operands of one sign.
template <class X>
struct FourPoints {
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

/// The stage that decides where no filter does.
template <class Operands>
Stage stage_without_filter(const Operands& o) {
  Operands narrow = o, wide = o;
  return narrow.move_to_grid(61) || wide.move_to_grid(125) ? Stage::integers : Stage::exact;
}

Tally total;

/// The sign and the stage of one question to the kernel.
template <class Ask>
void expect_sign(const Ask& ask, Sign due, Stage stage, const char* what) {
  Tally tally;
  require(ask(FilteredKernel(&tally)) == due, what);
  require(ask(FilteredKernel()) == due, what);
  require(tally[stage] == 1 && tally.deepest() == stage, "a sign's stage");
  total += tally;
}

template <class X>
void expect_signs(const Point3& a, const Point3& b, const Point3& c, const X& x) {
  const Sign volume = oracle.orient3d(a, b, c, x);
  const bool filtered =
      filter_orient3d(a, b, c, x, volume_filter) || filter_orient3d_by_terms(a, b, c, x, volume_terms_filter);
  const Stage stage = filtered ? Stage::filter : stage_without_filter(FourPoints<X>{a, b, c, x});
  expect_sign([&](const auto& k) { return k.orient3d(a, b, c, x); }, volume, stage, "orient3d");
  require(orient3d_exactly(Triangle{a, b, c}, x) == volume, "orient3d_exactly");
  for (const Axis axis : all_axes) {
    const auto flat = [&](Point3 p) {
      p[static_cast<int>(axis)] = 0;
      return p;
    };
    X flat_x = x;
    if constexpr (std::is_same_v<X, Direction>) {
      flat_x.v = flat(x.v);
    } else {
      flat_x = flat(x);
    }
    const Stage of_area = filter_orient2d(axis, a, b, x, area_filter)
                              ? Stage::filter
                              : stage_without_filter(FourPoints<X>{flat(a), flat(b), flat(a), flat_x});
    expect_sign([&](const auto& k) { return k.orient2d(axis, a, b, x); }, oracle.orient2d(axis, a, b, x), of_area,
                "orient2d");
    expect_sign([&](const auto& k) { return k.compare(axis, a, x); }, oracle.compare(axis, a, x), Stage::filter,
                "compare");
  }
}

void expect_signs_of_points_of_rays(const Five& f, double at) {
  const RayPoint x{{f.p, {f.q}}, at};
  const auto& [a, b, c] = f.t;
  const Stage stage = SidesAlongRay(x.ray, f.t).at(at) ? Stage::filter : Stage::exact;
  expect_sign([&](const auto& k) { return k.orient3d(a, b, c, x); }, oracle.orient3d(a, b, c, x), stage,
              "orient3d of a point of a ray");
  for (const Axis axis : all_axes) {
    expect_sign([&](const auto& k) { return k.orient2d(axis, a, b, x); }, oracle.orient2d(axis, a, b, x), Stage::exact,
                "orient2d of a point of a ray");
    expect_sign([&](const auto& k) { return k.compare(axis, a, x); }, oracle.compare(axis, a, x), Stage::exact,
                "compare with a point of a ray");
  }
}

struct TwoHits {
  Ray ray;
  Triangle s, t;
  bool move_to_grid(int bits) {
    return tribunal::move_to_grid({&ray.o, &s.a, &s.b, &s.c, &t.a, &t.b, &t.c}, &ray.d, bits);
  }
};

void expect_order(const Ray& r, const Triangle& s, const Triangle& t) {
  const Sign due = oracle.compare_hits(r, s, t);
  const bool filtered = filter_compare_hits(r, s, t, order_filter, volume_filter) ||
                        filter_compare_hits_by_terms(r, s, t, order_terms_filter, volume_terms_filter);
  const Stage stage = filtered ? Stage::filter : stage_without_filter(TwoHits{r, s, t});
  expect_sign([&](const auto& k) { return k.compare_hits(r, s, t); }, due, stage, "the order of hits");
  require(compare_hits(r, s, t) == due, "compare_hits");
}

void signs(EveryKind& every) {
  int n = 0;
  every(7, [&](const Five& f) {
    expect_signs(f.t.a, f.t.b, f.t.c, f.p);
    expect_signs(f.t.a, f.t.b, f.t.c, Direction{f.q});
    constexpr double at[] = {0, 1, 0.5, 0x1p-149, 0x1p-160, 0x1p149, 0x1p160, 0x1p-1074, 0x1.fp1023};
    expect_signs_of_points_of_rays(f, at[++n % 9]);
    const Triangle other = n % 2 == 0 ? Triangle{f.t.b, f.t.a, f.q} : Triangle{f.t.b, f.t.c, f.t.a};
    expect_order({f.p, {f.q}}, f.t, other);
  });
  // Small triangles far away: the bound by the largest arms is too wide for their order, that by terms is not.
  Draw draw;
  for (n = 0; n < 300; ++n) {
    const Point3 far = 0x1p30 * draw.point(4), d = far + draw.point(6);
    const auto beside = [&](double by) {
      return Triangle{by * far + draw.point(6), by * far + draw.point(6), by * far + draw.point(6)};
    };
    const Triangle s = beside(1), t = beside(1.5);
    expect_order({Point3(0), {d}}, s, t);
  }
  for (const Stage s : deciding_stages) require(total[s] > 100, "a stage that never decided");
}

// --- answers --------------------------------------------------------------------------------------------------------

template <class P>
struct ProbeAndTriangle {
  P probe;
  Triangle triangle;
  bool move_to_grid(int bits) { return tribunal::move_to_grid(probe, triangle, bits); }
};

template <class P>
void expect_answer(const P& probe, const Triangle& t) {
  Answer due = segura_feito(probe, t, oracle);
  const bool hit = due.hit;
  const bool filtered =
      filter_hits(probe, t, pair_filter<P>) || filter_hits_by_terms<double>(probe, t, volume_terms_filter);
  due.stage = filtered ? Stage::filter : stage_without_filter(ProbeAndTriangle<P>{probe, t});
  require(intersect(probe, t) == due, "intersect");
  require(intersect(TrianglePair{probe, t}) == due, "intersect a pair");
  require(hits(probe, t) == hit && hits_past_filter(probe, t) == hit && hits_exactly(probe, t) == hit, "hits");
  const Answer classified = classify(probe, t);
  require(classified.hit == hit && classified.contact == due.contact, "classify");
  require(classified.class_id == class_of(probe, t, oracle), "the class");
  require(classified.stage >= Stage::filter, "a stage of a class");
}

void expect_answer_within(const Ray& r, const Bounds& bounds, const Triangle& t) {
  Answer due = segura_feito(r, bounds, t, oracle);
  const auto filtered = filter_hits_within(r, bounds, t);
  due.stage = filtered ? Stage::filter : Stage::exact;
  const Answer answer = intersect(r, bounds, t);
  require(answer == due && hits(r, bounds, t) == due.hit, "intersect within bounds");
}

void answers(EveryKind& every) {
  int n = 0;
  every(8, [&](const Five& f) {
    expect_answer(Segment{f.p, f.q}, f.t);
    expect_answer(Ray{f.p, {f.q}}, f.t);
    constexpr Bounds bounds[] = {{}, {0, 1}, {0.5, 2}, {1, 1}, {0, 0}, {2}, {0x1p-1074, 1}, {1, 0x1p1000}};
    expect_answer_within({f.p, {f.q}}, bounds[++n % 8], f.t);
  });
}

void nonfinite() {
  const Triangle t{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  const Point3 up(1, 1, 1), down(1, 1, -1);
  for (const double bad : {infinity, -infinity, not_a_number}) {
    for (int axis = 0; axis < 3; ++axis) {
      const auto spoilt = [&](Point3 p) {
        p[axis] = bad;
        return p;
      };
      const auto refuses = [&](const auto& probe, const Triangle& triangle) {
        require(intersect(probe, triangle) == refusal(Status::nonfinite), "intersect refuses");
        require(classify(probe, triangle) == refusal(Status::nonfinite), "classify refuses");
        require(!hits(probe, triangle) && !hits_exactly(probe, triangle), "hits nothing");
      };
      refuses(Segment{spoilt(up), down}, t);
      refuses(Segment{up, spoilt(down)}, t);
      refuses(Ray{spoilt(up), {down}}, t);
      refuses(Ray{up, {spoilt(down)}}, t);
      for (const Triangle& u : {Triangle{spoilt(t.a), t.b, t.c}, {t.a, spoilt(t.b), t.c}, {t.a, t.b, spoilt(t.c)}}) {
        refuses(Segment{up, down}, u);
        refuses(Ray{up, {down}}, u);
        require(intersect(Ray{up, {down}}, Bounds{}, u) == refusal(Status::nonfinite), "bounds of a bad triangle");
      }
      require(intersect(Ray{spoilt(up), {down}}, Bounds{0, 1}, t).status == Status::nonfinite, "bounds of a bad ray");
    }
    require(intersect(Ray{up, {down}}, Bounds{bad, 1}, t).status == Status::nonfinite, "a bad bound");
  }
  require(intersect(Ray{up, {down}}, Bounds{0, not_a_number}, t).status == Status::nonfinite, "a NaN bound");
  require(!hits(Ray{up, {down}}, Bounds{0, not_a_number}, t), "a NaN bound hits nothing");
}

// --- crossings and parameters ---------------------------------------------------------------------------------------

/// det(a − o, b − o, x).
Sign det_sign(const Point3& o, const Point3& a, const Point3& b, const Point3& x) {
  return oracle.orient3d(o, a, b, Direction{x});
}

void crossings(EveryKind& every) {
  int n = 0;
  every(3, [&](Five f) {
    // Edges, source and direction in a plane of two axes, so that the perturbation decides.
    if (const int axis = ++n % 4; axis < 3) f.p[axis] = f.t.a[axis] = f.t.b[axis], f.q[axis] = 0;
    const Ray r{f.p, {f.q}};
    const Crossing c = crossing(r, f.t);
    const Sign cone = oracle.orient3d(f.p, f.t.a, f.t.b, f.t.c);
    if (cone == Sign::zero) {
      require(c.holds_source == segura_feito(Segment{f.p, f.p}, f.t, oracle).hit && c.direction == 0, "on the surface");
      return;
    }
    const auto passes = [&](const Point3& a, const Point3& b) {
      for (const Point3& d : {f.q, Point3(1, 0, 0), Point3(0, 1, 0), Point3(0, 0, 1)}) {
        if (const Sign s = det_sign(f.p, a, b, d); s != Sign::zero) return s == cone;
      }
      return false;
    };
    const bool crosses = passes(f.t.a, f.t.b) && passes(f.t.b, f.t.c) && passes(f.t.c, f.t.a);
    require(!c.holds_source && c.direction == (crosses ? value(cone) : 0), "a crossing");
  });
}

void parameters(EveryKind& every) {
  int filtered = 0, exact = 0, parallel = 0;
  every(8, [&](const Five& f) {
    const Ray r{f.p, {f.q}};
    const testing::ExactParameter due(r, f.t);
    if (due.parallel) {
      ++parallel;
      const auto throws = [&](const auto& ask) {
        try {
          ask();
        } catch (const std::domain_error&) {
          return true;
        }
        return false;
      };
      require(throws([&] { (void)hit_fraction(r, f.t); }), "a parallel ray has no fraction");
      require(throws([&] { (void)rounded_parameter(r, f.t); }), "a parallel ray has no parameter");
      return;
    }
    require(hit_fraction(r, f.t) == due.value, "the fraction of a hit");
    const double nearest = due.rounded();
    require(rounded(due.value) == nearest, "rounded");
    require(rounded_parameter(r, f.t) == nearest, "the rounded parameter");
    const auto certain = filter_rounded_parameter(r, f.t);
    require(!certain || *certain == nearest, "a parameter certain and wrong");
    ++(certain ? filtered : exact);
  });
  require(filtered > 100 && exact > 100 && parallel > 50, "a kind of parameter that never came up");
  // Far more, and far less, than the range in which twice the precision suffices.
  const Triangle wide{{0, 0, 0}, {0x1p149, 0, 0}, {0, 0x1p149, 0}};
  for (const double d : {0x1p-930, 0x1p-760, 0x1p-700, 0x1p149}) {
    for (const double o : {0x1p149, 0x1p100, 0x1p-760, 0x1p-930}) {
      const Ray r{{1, 1, o}, {{0, 0, -d}}};
      require(rounded_parameter(r, wide) == o / d, "a parameter at the ends of the range");
    }
  }
  for (const double x : {0x1p-1074, 0x1p-1022, 0x1.fffffffffffffp1023, 1.0, 0x1.0000000000001p0}) {
    const mpq_class q(x), half(mpq_class(std::nextafter(x, infinity) == infinity ? x : std::nextafter(x, infinity)));
    require(rounded(q) == x && rounded(-q) == -x, "a double is its own rounding");
    const mpq_class middle = (q + half) / 2;
    const double even = (std::bit_cast<std::uint64_t>(x) & 1) == 0 ? x : half.get_d();
    require(rounded(middle) == even, "a tie goes to the even one");
  }
  require(rounded(mpq_class(0)) == 0, "zero");
  const mpq_class least(0x1p-1074), greatest(0x1.fffffffffffffp1023), last(0x1p971);
  require(rounded(least / 2) == 0 && rounded(least * 3 / 4) == 0x1p-1074, "below the least");
  require(!std::signbit(rounded(-least / 2)), "a negative number that is rounded to zero");
  require(rounded(greatest + last / 2) == infinity && rounded(-greatest - last) == -infinity, "infinity");
  require(rounded(greatest + last / 4) == 0x1.fffffffffffffp1023 && rounded(greatest * 4) == infinity, "near infinity");
}

// --- numbers --------------------------------------------------------------------------------------------------------

mpq_class exactly(const DoubleDouble& x) { return mpq_class(x.hi) + mpq_class(x.lo); }

void double_doubles(Draw& draw) {
  for (int n = 0; n < 4000; ++n) {
    const auto number = [&] {
      const double hi = draw.number(4);
      return n % 3 == 0 ? DoubleDouble(hi) : DoubleDouble::sum(hi, hi * 0x1p-54 * draw.number(4) / 256);
    };
    const DoubleDouble a = number(), b = number();
    const mpq_class x = exactly(a), y = exactly(b), sum = x + y, difference = x - y, product = x * y;
    const auto is_close = [](const DoubleDouble& z, const mpq_class& due) {
      return abs(exactly(z) - due) <= mpq_class(0x1p-103) * abs(due) && z.hi == z.hi + z.lo;
    };
    const bool single = a.lo == 0 && b.lo == 0;
    require(is_close(a + b, sum) && is_close(a - b, difference) && is_close(a * b, product), "twice the precision");
    require(!single || (exactly(a + b) == sum && exactly(a - b) == difference), "sums of two doubles");
    require(exactly(-a) == -x && exactly(DoubleDouble::product(a.hi, b.hi)) == mpq_class(a.hi) * mpq_class(b.hi),
            "a product of two doubles");
  }
}

template <std::size_t Words>
void fixed_integers(Draw& draw) {
  using Integer = FixedInteger<Words>;
  for (int n = 0; n < 3000; ++n) {
    const int bits = static_cast<int>(64 * Words - 4) / 2;
    const auto number = [&] {
      const int e = draw.within(0, std::min(bits, 900));
      return std::trunc(std::ldexp(draw.number(4) / 256, e));
    };
    const double a = n % 7 == 0 ? 0.0 : number(), b = n % 11 == 0 ? a : n % 13 == 0 ? 0x1p63 : number();
    const Integer x(a), y(b);
    const mpz_class p(a), q(b);
    const auto sign = [](const mpz_class& z) { return static_cast<Sign>(sgn(z)); };
    require(sign_of(x) == sign(p) && sign_of(-x) == sign(-p), "the sign of an integer");
    require(sign_of(x + y) == sign(p + q) && sign_of(x - y) == sign(p - q), "sums of integers");
    require(sign_of(x * y) == sign(p * q) && (x == y) == (p == q), "a product of integers");
    require(x + y - y == x && x - y + y == x && x * y - y * x == Integer(0.0), "laws of integers");
    const Integer square = (x + y) * (x + y), parts = x * x + (x * y + x * y) + y * y;
    if (4 * std::ilogb(std::fabs(a) + std::fabs(b) + 1) < static_cast<int>(64 * Words)) {
      require(square == parts, "the square of a sum");
    }
    require(Words > 3 || sign_of(x * y - Integer(a) * Integer(b)) == Sign::zero, "the same product");
  }
}

void grids(Draw& draw) {
  for (int n = 0; n < 6000; ++n) {
    const Five f = drawn(draw, n % Draw::kinds, n % degeneracies);
    if (!f.finite()) continue;
    for (const int bits : {61, 125}) {
      Segment s{f.p, f.q};
      Ray r{f.p, {f.q}};
      Triangle t = f.t, u = f.t;
      const bool segment = move_to_grid(s, t, bits), ray = move_to_grid(r, u, bits);
      const auto fits = [&](const Point3& p) {
        for (int i = 0; i < 3; ++i) {
          if (p[i] != std::trunc(p[i]) || std::fabs(p[i]) >= std::ldexp(1.0, bits)) return false;
        }
        return true;
      };
      if (segment) {
        for (const Point3& x : {s.p, s.q, t.a, t.b, t.c}) require(fits(x), "a point on the grid");
        require(oracle.orient3d(t.a, t.b, t.c, s.p) == oracle.orient3d(f.t.a, f.t.b, f.t.c, f.p), "moved points");
        require(segura_feito(s, t, oracle) == segura_feito(Segment{f.p, f.q}, f.t, oracle), "a moved segment");
      }
      if (ray) {
        for (const Point3& x : {r.o, r.d.v, u.a, u.b, u.c}) require(fits(x), "a ray on the grid");
        require(segura_feito(r, u, oracle) == segura_feito(Ray{f.p, {f.q}}, f.t, oracle), "a moved ray");
      }
      if (n % Draw::kinds <= 4 && n % degeneracies == 0) require(bits != 125 || (segment && ray), "what a grid holds");
    }
  }
}

void grid_kernel(Draw& draw) {
  const GridKernel k;
  for (int n = 0; n < 4000; ++n) {
    const Five f = drawn(draw, n % 4, n % degeneracies);
    Ray r{f.p, {f.q}};
    Triangle t = f.t;
    if (!f.finite()) continue;
    if (n % 4 == 0) {  // on the grid, but for halves and quarters, and near its middle
      for (Point3* x : {&r.o, &r.d.v, &t.a, &t.b, &t.c}) *x *= 4;
    } else if (!move_to_grid(r, t, 61)) {
      continue;
    }
    const auto& [a, b, c] = t;
    require(k.orient3d(a, b, c, r.o) == oracle.orient3d(a, b, c, r.o), "orient3d on the grid");
    require(k.orient3d(a, b, c, r.d) == oracle.orient3d(a, b, c, r.d), "orient3d of a direction on the grid");
    for (const Axis axis : all_axes) {
      require(k.orient2d(axis, a, b, r.o) == oracle.orient2d(axis, a, b, r.o), "orient2d on the grid");
      require(k.orient2d(axis, a, b, r.d) == oracle.orient2d(axis, a, b, r.d), "orient2d of a direction on the grid");
      require(k.compare(axis, a, r.o) == oracle.compare(axis, a, r.o), "compare on the grid");
      require(k.compare(axis, a, r.d) == oracle.compare(axis, a, r.d), "compare a direction on the grid");
    }
    require(k.compare_hits(r, t, {b, c, r.o}) == oracle.compare_hits(r, t, {b, c, r.o}), "order of hits on the grid");
  }
}

// --- the thread's environment ---------------------------------------------------------------------------------------

/// Rounding modes and flushing: no answer depends on them, and they are as they were afterwards.
void environments(Draw& draw) {
  constexpr unsigned flush = 0x8040, towards[] = {0, 0x2000, 0x4000, 0x6000};
  const unsigned usual = _mm_getcsr();
  for (int n = 0; n < 1500; ++n) {
    const Five f = drawn(draw, n % Draw::kinds, n % degeneracies);
    if (!f.finite()) continue;
    const Ray r{f.p, {f.q}};
    const Segment s{f.p, f.q};
    const Answer ray = segura_feito(r, f.t, oracle), segment = segura_feito(s, f.t, oracle);
    const Answer part = segura_feito(r, Bounds{0.5, 2}, f.t, oracle);
    const Sign order = oracle.compare_hits(r, f.t, {f.t.b, f.t.c, f.q});
    const testing::ExactParameter at(r, f.t);
    const double nearest = at.parallel ? 0 : at.rounded();
    const unsigned foreign = (usual & ~0xe040U) | towards[n % 4] | (n % 3 == 0 ? flush : 0);
    _mm_setcsr(foreign);
    const Answer told[] = {intersect(r, f.t), intersect(s, f.t), intersect(r, Bounds{0.5, 2}, f.t)};
    const Sign told_order = compare_hits(r, f.t, {f.t.b, f.t.c, f.q});
    const Sign side = FilteredKernel().orient3d(f.t.a, f.t.b, f.t.c, f.p);
    const double parameter = at.parallel ? 0 : rounded_parameter(r, f.t);
    const unsigned after = _mm_getcsr() & 0xffc0;
    _mm_setcsr(usual);
    const auto same = [](const Answer& x, const Answer& y) {
      return x.hit == y.hit && x.contact == y.contact && x.at == y.at && x.facing == y.facing;
    };
    require(same(told[0], ray) && same(told[1], segment) && same(told[2], part), "answers in a foreign environment");
    require(told_order == order && side == oracle.orient3d(f.t.a, f.t.b, f.t.c, f.p), "signs in a foreign environment");
    require(parameter == nearest, "a foreign parameter");
    require(after == (foreign & 0xffc0), "the caller's environment");
  }
}

void tallies() {
  Tally a, b;
  a[Stage::filter] = 2;
  b[Stage::exact] = 3;
  a += b;
  const Tally& c = a;
  require(c[Stage::filter] == 2 && c[Stage::exact] == 3 && c[Stage::integers] == 0 && c[Stage::none] == 0, "tallies");
  require(a.deepest() == Stage::exact && Tally().deepest() == Stage::none, "the deepest stage");
  b[Stage::exact] = 0, b[Stage::integers] = 1;
  require(b.deepest() == Stage::integers, "a stage in between");
}

}  // namespace

int main() {
  Draw draw;
  EveryKind every;
  tallies();
  nonfinite();
  double_doubles(draw);
  fixed_integers<3>(draw);
  fixed_integers<6>(draw);
  fixed_integers<12>(draw);
  grids(draw);
  grid_kernel(draw);
  parameters(every);
  crossings(every);
  signs(every);
  answers(every);
  environments(draw);
  std::puts("survived");
}
