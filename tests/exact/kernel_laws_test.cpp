// The laws that core/kernel.h states, for every kernel that promises them.
#include <gmpxx.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/kernel.h"
#include "core/tolerance_kernel.h"
#include "exact/cases/families/draw.h"
#include "exact/filtered/filtered_kernel.h"
#include "exact/kernels/expansion_kernel.h"
#include "exact/kernels/product_sum.h"
#include "exact/kernels/rational_kernel.h"
#include "exact/methods/cgal_kernels.h"

namespace tribunal {
namespace {

/// Coordinates with full significands, exponents within ±span, zeros and repeats among them.
class Corpus {
 public:
  Corpus(std::uint64_t seed, int span) : draw_(9, seed, 0), span_(span) {}

  double number() {
    if (draw_.below(8) == 0) return draw_.below(2) == 0 ? 0.0 : -0.0;
    const auto significand = static_cast<double>(draw_.between(-(std::int64_t{1} << 53), std::int64_t{1} << 53));
    return std::ldexp(significand, static_cast<int>(draw_.between(-span_, span_)) - 53);
  }
  Point3 point() {
    Point3 p;
    for (int i = 0; i < 3; ++i) p[i] = number();
    return p;
  }
  /// Small integers: degenerate often, and every sum and shift of them is exact.
  Point3 lattice_point() {
    Point3 p;
    for (int i = 0; i < 3; ++i) p[i] = static_cast<double>(draw_.between(-3, 3));
    return p;
  }

 private:
  Draw draw_;
  int span_;
};

Point3 scaled(const Point3& p, int e) { return {std::ldexp(p.x, e), std::ldexp(p.y, e), std::ldexp(p.z, e)}; }

using AllKernels =
    testing::Types<FormulaKernel<float>, FormulaKernel<double>, ToleranceKernel, FilteredKernel, EpickKernel,
                   EpeckKernel, ExpansionKernel, ProductSumKernel, RationalKernel, FormulaKernel<mpq_class>>;
using ExactKernels = testing::Types<FilteredKernel, EpickKernel, EpeckKernel, ExpansionKernel, ProductSumKernel,
                                    RationalKernel, FormulaKernel<mpq_class>>;

template <class K>
class KernelLaws : public testing::Test {};
TYPED_TEST_SUITE(KernelLaws, AllKernels);

template <class K>
class ExactLaws : public testing::Test {};
TYPED_TEST_SUITE(ExactLaws, ExactKernels);

TYPED_TEST(KernelLaws, UnitFrameIsPositive) {
  const TypeParam k{};
  const Point3 o{0, 0, 0}, x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  EXPECT_EQ(k.orient3d(o, x, y, z), Sign::positive);
  EXPECT_EQ(k.orient3d(o, x, y, Direction{z}), Sign::positive);
  EXPECT_EQ(k.orient2d(Axis::z, o, x, y), Sign::positive);
  EXPECT_EQ(k.orient2d(Axis::x, o, y, z), Sign::positive);
  EXPECT_EQ(k.orient2d(Axis::y, o, z, x), Sign::positive);
  EXPECT_EQ(k.orient2d(Axis::z, o, x, Direction{y}), Sign::positive);
  EXPECT_EQ(k.compare(Axis::x, o, x), Sign::positive);
  EXPECT_EQ(k.compare(Axis::x, o, Direction{{-1, 0, 0}}), Sign::negative);
}

TYPED_TEST(KernelLaws, SignOfZeroDoesNotMatter) {
  const TypeParam k{};
  Corpus corpus(1, 10);
  const auto plus = [](Point3 p) { return p + Point3(0.0); };
  for (int i = 0; i < 200; ++i) {
    const Point3 a = corpus.lattice_point(), b = corpus.lattice_point(), c = corpus.lattice_point(),
                 d = corpus.lattice_point();
    const auto minus = [](Point3 p) {
      for (int axis = 0; axis < 3; ++axis) p[axis] = p[axis] == 0 ? -0.0 : p[axis];
      return p;
    };
    EXPECT_EQ(k.orient3d(plus(a), plus(b), plus(c), plus(d)), k.orient3d(minus(a), minus(b), minus(c), minus(d)));
    EXPECT_EQ(k.compare(Axis::y, plus(a), plus(b)), k.compare(Axis::y, minus(a), minus(b)));
  }
}

TYPED_TEST(ExactLaws, SwapNegates) {
  const TypeParam k{};
  Corpus corpus(2, 60);
  for (int i = 0; i < 300; ++i) {
    const Point3 a = corpus.point(), b = corpus.point(), c = corpus.point(), d = corpus.point();
    const Sign s = k.orient3d(a, b, c, d);
    EXPECT_EQ(k.orient3d(b, a, c, d), -s);
    EXPECT_EQ(k.orient3d(a, c, b, d), -s);
    EXPECT_EQ(k.orient3d(a, b, d, c), -s);
    for (const Axis axis : all_axes) {
      EXPECT_EQ(k.orient2d(axis, a, b, c), -k.orient2d(axis, b, a, c));
      EXPECT_EQ(k.compare(axis, a, b), -k.compare(axis, b, a));
    }
  }
}

TYPED_TEST(ExactLaws, PowersOfTwoChangeNothing) {
  const TypeParam k{};
  Corpus corpus(3, 20);
  for (int i = 0; i < 100; ++i) {
    const Point3 a = corpus.lattice_point(), b = corpus.lattice_point(), c = corpus.lattice_point(),
                 d = corpus.lattice_point();
    const Sign s = k.orient3d(a, b, c, d);
    for (const int e : {-1074, -1022, -537, -359, -1, 1, 338, 400, 1020}) {
      EXPECT_EQ(k.orient3d(scaled(a, e), scaled(b, e), scaled(c, e), scaled(d, e)), s) << "2^" << e;
      EXPECT_EQ(k.orient3d(scaled(a, e), scaled(b, e), scaled(c, e), Direction{scaled(d - a, e)}), s) << "2^" << e;
      EXPECT_EQ(k.orient2d(Axis::z, scaled(a, e), scaled(b, e), scaled(c, e)), k.orient2d(Axis::z, a, b, c));
    }
    const auto stretch = [](const Point3& p) {
      return Point3(std::ldexp(p.x, 900), std::ldexp(p.y, -900), std::ldexp(p.z, 10));
    };
    EXPECT_EQ(k.orient3d(stretch(a), stretch(b), stretch(c), stretch(d)), s);
    const auto mirror = [](const Point3& p) { return Point3(-p.x, p.y, p.z); };
    EXPECT_EQ(k.orient3d(mirror(a), mirror(b), mirror(c), mirror(d)), -s);
  }
}

TYPED_TEST(ExactLaws, ExactTranslationChangesNothing) {
  const TypeParam k{};
  Corpus corpus(4, 20);
  const Point3 far(0x1p50, -0x1p49, 0x1p51);
  for (int i = 0; i < 300; ++i) {
    const Point3 a = corpus.lattice_point(), b = corpus.lattice_point(), c = corpus.lattice_point(),
                 d = corpus.lattice_point();
    EXPECT_EQ(k.orient3d(a + far, b + far, c + far, d + far), k.orient3d(a, b, c, d));
    EXPECT_EQ(k.orient3d(a + far, b + far, c + far, Direction{d - a}), k.orient3d(a, b, c, d));
  }
}

TYPED_TEST(ExactLaws, DependentPointsGiveZero) {
  const TypeParam k{};
  Corpus corpus(5, 60);
  const double largest = std::numeric_limits<double>::max(), smallest = std::numeric_limits<double>::denorm_min();
  for (int i = 0; i < 200; ++i) {
    const Point3 a = corpus.point(), b = corpus.point(), c = corpus.point();
    EXPECT_EQ(k.orient3d(a, b, c, a), Sign::zero);
    EXPECT_EQ(k.orient3d(a, b, c, c), Sign::zero);
    EXPECT_EQ(k.orient3d(a, b, c, Direction{{0, 0, 0}}), Sign::zero);
    EXPECT_EQ(k.orient2d(Axis::x, a, b, b), Sign::zero);
  }
  EXPECT_EQ(k.orient3d(Point3(0, 0, largest), Point3(largest, 0, largest), Point3(0, largest, largest),
                       Point3(-largest, smallest, largest)),
            Sign::zero)
      << "coplanar at the far end of the range";
  EXPECT_EQ(k.orient3d(Point3(-largest), Point3(largest, 0, 0), Point3(0, largest, 0), Point3(0, 0, smallest)),
            Sign::positive);
}

TYPED_TEST(ExactLaws, DirectionIsTheLimitOfPoints) {
  const TypeParam k{};
  Corpus corpus(6, 20);
  for (int i = 0; i < 300; ++i) {
    const Point3 a = corpus.lattice_point(), b = corpus.lattice_point(), c = corpus.lattice_point(),
                 q = corpus.lattice_point();
    EXPECT_EQ(k.orient3d(a, b, c, Direction{q - a}), k.orient3d(a, b, c, q));
    for (const Axis axis : all_axes) {
      EXPECT_EQ(k.orient2d(axis, a, b, Direction{q - a}), k.orient2d(axis, a, b, q));
      EXPECT_EQ(k.compare(axis, a, Direction{q - a}), k.compare(axis, a, q));
    }
  }
}

/// Five points have an affine dependency: the signed volumes of the five tetrahedra, alternating, sum to zero. So the
/// signs cannot all agree after alternation unless all vanish.
TYPED_TEST(ExactLaws, FivePointsAreConsistent) {
  const TypeParam k{};
  Corpus corpus(7, 4);
  for (int i = 0; i < 500; ++i) {
    Point3 v[5];
    for (Point3& p : v) p = i % 2 == 0 ? corpus.lattice_point() : corpus.point();
    const int s[5] = {value(k.orient3d(v[1], v[2], v[3], v[4])), -value(k.orient3d(v[0], v[2], v[3], v[4])),
                      value(k.orient3d(v[0], v[1], v[3], v[4])), -value(k.orient3d(v[0], v[1], v[2], v[4])),
                      value(k.orient3d(v[0], v[1], v[2], v[3]))};
    int positive = 0, negative = 0;
    for (const int sign : s) {
      positive += sign > 0;
      negative += sign < 0;
    }
    EXPECT_EQ(positive > 0, negative > 0);
  }
}

/// The reference against plain mpq arithmetic, and CGAL's kernels against the reference, where double is lost.
TYPED_TEST(ExactLaws, AgreesWithFractionsWhereDoubleFails) {
  const TypeParam k{};
  const FormulaKernel<mpq_class> fractions;
  const FormulaKernel<double> naive;
  Corpus corpus(8, 2);
  int naive_wrong = 0;
  for (int i = 0; i < 400; ++i) {
    const Point3 a = corpus.point(), b = corpus.point(), c = corpus.point();
    const Point3 d = a + (b - a) * 0.5 + (c - a) * 0.25;  // nearly coplanar
    const Direction e{(b - a) * 0.5 + (c - a) * 0.25};
    EXPECT_EQ(k.orient3d(a, b, c, d), fractions.orient3d(a, b, c, d));
    EXPECT_EQ(k.orient3d(a, b, c, e), fractions.orient3d(a, b, c, e));
    EXPECT_EQ(k.orient2d(Axis::y, a, b, e), fractions.orient2d(Axis::y, a, b, e));
    const Ray r{a, {b - a}};
    const Triangle s{a, c, d}, t{b, d, c};
    EXPECT_EQ(k.compare_hits(r, s, t), fractions.compare_hits(r, s, t));
    naive_wrong += naive.orient3d(a, b, c, d) != fractions.orient3d(a, b, c, d);
  }
  EXPECT_GT(naive_wrong, 20) << "this corpus has no teeth";
}

TEST(Dyadic, RoundTripsAndComputesExactly) {
  Corpus corpus(10, 1000);
  for (int i = 0; i < 500; ++i) {
    const double x = corpus.number(), y = corpus.number(), z = corpus.number();
    const mpq_class fx(x), fy(y), fz(z);
    EXPECT_EQ(Dyadic(x).fraction(), fx);
    EXPECT_EQ((Dyadic(x) + Dyadic(y)).fraction(), fx + fy);
    EXPECT_EQ((Dyadic(x) - Dyadic(y)).fraction(), fx - fy);
    EXPECT_EQ((Dyadic(x) * Dyadic(y) - Dyadic(z)).fraction(), fx * fy - fz);
    EXPECT_EQ(sign_of(Dyadic(x) - Dyadic(y)), sign_of(fx - fy));
    EXPECT_EQ((-Dyadic(x)).fraction(), -fx);
  }
}

/// At these values the machine word overflows and a GMP integer must take over.
TEST(Dyadic, LeavesTheMachineWordInTime) {
  const double corners[] = {
      0x1p53 - 1, -0x1p53, 0x1p62, 0x1p63, 1, -1, 0, 0x1p-1074, std::numeric_limits<double>::max()};
  for (const double x : corners) {
    for (const double y : corners) {
      const Dyadic product = Dyadic(x) * Dyadic(y);
      EXPECT_EQ(product.fraction(), mpq_class(x) * mpq_class(y));
      EXPECT_EQ((product * product - product).fraction(), mpq_class(x) * x * y * y - mpq_class(x) * y);
      EXPECT_EQ((product + product + Dyadic(x)).fraction(), 2 * mpq_class(x) * y + x);
    }
  }
}

/// Numbers of every length about the limbs that a dyadic has room for: sums at every distance, by carries and by
/// cancellation, and products.
TEST(Dyadic, LeavesItsLimbsInTime) {
  const double full = 0x1.fffffffffffffp0;
  for (int gap = 0; gap <= 520; ++gap) {
    const double x = std::ldexp(full, gap);
    const Dyadic long_one = Dyadic(x) + Dyadic(0x1p-52), near_zero = long_one - Dyadic(x);
    const mpq_class exact = mpq_class(x) + mpq_class(0x1p-52);
    EXPECT_EQ(long_one.fraction(), exact) << gap;
    EXPECT_EQ(near_zero.fraction(), mpq_class(0x1p-52)) << gap;
    EXPECT_EQ((long_one + long_one).fraction(), 2 * exact) << gap;
    EXPECT_EQ((long_one * Dyadic(-full)).fraction(), exact * mpq_class(-full)) << gap;
    EXPECT_EQ((long_one * long_one - long_one).fraction(), exact * exact - exact) << gap;
    EXPECT_EQ(sign_of(Dyadic(x) - long_one), Sign::negative) << gap;
    EXPECT_EQ(sign_of(long_one - long_one), Sign::zero) << gap;
    Dyadic copy = near_zero;
    copy = long_one;
    EXPECT_EQ(copy.fraction(), exact) << gap;
    copy = Dyadic(1);
    EXPECT_EQ(copy.fraction(), 1) << gap;
  }
}

}  // namespace
}  // namespace tribunal
