// Expansions held against exact fractions, and their kernel against the reference kernel wherever cases are hard.
#include "exact/kernels/expansion.h"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>

#include "exact/cases/families/draw.h"
#include "exact/cases/family_table.h"
#include "exact/classes/classify.h"
#include "exact/kernels/expansion_kernel.h"
#include "exact/kernels/expansion_range.h"
#include "exact/kernels/rational_kernel.h"

namespace tribunal {
namespace {

using namespace detail;

template <class Terms>
mpq_class fraction(const ExactExpansion<Terms>& e) {
  mpq_class sum;
  for (std::size_t i = 0; i < e.size(); ++i) sum += mpq_class(e.terms()[i]);
  return sum;
}

/// Whether each term is larger than all before it together.
template <class Terms>
bool is_nonoverlapping(const ExactExpansion<Terms>& e) {
  mpq_class sum;
  for (std::size_t i = 0; i < e.size(); ++i) {
    const mpq_class term(e.terms()[i]);
    if (abs(term) <= abs(sum)) return false;
    sum += term;
  }
  return true;
}

/// Draws numbers with 2^lo ≤ |x| < 2^hi, many of them powers of two or next to one.
class Numbers {
 public:
  Numbers(std::uint64_t seed, int lo, int hi) : draw_(9, seed, 0), lo_(lo), hi_(hi) {}

  double operator()() {
    const auto kind = draw_.below(8);
    const auto low_bits = static_cast<double>(draw_.below(kind < 3 ? 2 : std::uint64_t{1} << 52));
    const double significand = kind == 0 ? 2 - 0x1p-52 : 1 + low_bits * 0x1p-52;
    const int exponent = static_cast<int>(draw_.between(lo_, hi_ - 1));
    const double x = std::ldexp(significand, exponent);
    return draw_.below(2) == 0 ? x : -x;
  }
  Point3 point() {
    Point3 p;
    for (int i = 0; i < 3; ++i) p[i] = draw_.below(16) == 0 ? 0 : (*this)();
    return p;
  }

 private:
  Draw draw_;
  int lo_, hi_;
};

TEST(ExactExpansion, SumsAndProductsAreExactAndNonoverlapping) {
  Numbers number(1, -60, 60);
  for (int i = 0; i < 3000; ++i) {
    VolumeExpansion e, f;
    mpq_class exact_e, exact_f;
    for (int j = 0; j < i % 4; ++j) {
      const double x = number(), y = number();
      e = e + VolumeExpansion(x);
      f = f - VolumeExpansion(y);
      exact_e += mpq_class(x);
      exact_f -= mpq_class(y);
    }
    ASSERT_EQ(fraction(e), exact_e);
    ASSERT_EQ(fraction(e * f - f), exact_e * exact_f - exact_f);
    ASSERT_TRUE(is_nonoverlapping(e * f) && is_nonoverlapping(e * f - f));
    ASSERT_EQ(sign_of(e - f), sign_of(exact_e - exact_f));
    ASSERT_EQ(fraction(e + -e), 0);
    const LongExpansion few = (e * f * e).compressed<std::vector<double>>();
    ASSERT_EQ(fraction(few), exact_e * exact_f * exact_e);
    ASSERT_TRUE(is_nonoverlapping(few));
    ASSERT_LE(few.size(), (e * f * e).size());
  }
}

/// Operands with numbers at both ends of the range, where a wider range would let products underflow or overflow.
TEST(ExactExpansion, VolumesAreExactToTheEndsOfTheRange) {
  const auto [least, end] = volume_range;
  for (const auto& [lo, hi] : {std::pair{least, least + 2}, {least, least + 90}, {end - 90, end}, {end - 2, end}}) {
    Numbers number(2, lo, hi);
    for (int i = 0; i < 3000; ++i) {
      const Point3 a = number.point(), b = number.point(), c = number.point(), d = number.point();
      ASSERT_TRUE(is_within(volume_range, {&a, &b, &c, &d}, nullptr));
      const VolumeExpansion volume = signed_volume<VolumeExpansion>(a, b, c, d);
      ASSERT_TRUE(volume.size() == 0 || std::isfinite(volume.terms().back()));
      ASSERT_EQ(fraction(volume), signed_volume<mpq_class>(a, b, c, d));
      ASSERT_TRUE(is_nonoverlapping(volume));
    }
  }
}

/// Coordinates in the least binade of the range, of points that are nearly coplanar, so that only the lowest bits of
/// products remain.
TEST(ExactExpansion, TheLeastBitsOfTheLeastNumbersCount) {
  int beyond_bound = 0;
  for (const ExpansionRange& range : {volume_range, order_range}) {
    Numbers number(3, range.least, range.least + 2);
    for (int i = 0; i < 2000; ++i) {
      const Point3 a = number.point(), b = number.point(), c = number.point();
      const Point3 near = b + (c - b) * 0.5;
      const Ray r{a, {near - a}};
      ExpansionTally tally;
      const ExpansionKernel k(&tally);
      const RationalKernel reference;
      ASSERT_EQ(k.orient3d(a, b, c, near), reference.orient3d(a, b, c, near));
      ASSERT_EQ(k.orient2d(Axis::y, b, c, near), reference.orient2d(Axis::y, b, c, near));
      ASSERT_EQ(k.compare_hits(r, {b, c, near + a}, {b, near + a, c}),
                reference.compare_hits(r, {b, c, near + a}, {b, near + a, c}));
      beyond_bound += tally.expansions > 0;
    }
  }
  EXPECT_GT(beyond_bound, 2000) << "the bound was certain of most: this test has no teeth";
}

TEST(ExpansionRange, MovesOperandsByPowersOfTwoOrNotAtAll) {
  const double largest = std::numeric_limits<double>::max(), least = std::numeric_limits<double>::denorm_min();
  Point3 a(least, 3 * least, largest), b(0, -5 * least, 1);
  Direction d{{largest, 0, least}};
  EXPECT_FALSE(bring_within(volume_range, {&a, &b}, &d)) << "the last axis spans 1024 binades";
  EXPECT_EQ(a, Point3(least, 3 * least, largest));
  b.z = -largest / 4;
  d.v.x = 0;
  ASSERT_TRUE(bring_within(volume_range, {&a, &b}, &d));
  EXPECT_TRUE(is_within(volume_range, {&a, &b}, &d));
  EXPECT_EQ(a.y / b.y, 3.0 / -5.0);
  EXPECT_EQ(a.z / b.z, -4.0);
}

/// The answers of two kernels to the same case.
struct Comparison {
  ExpansionTally tally{};
  std::uint64_t signs = 0;

  void hold(const Query& query, const Triangle& other) {
    const ExpansionKernel k(&tally);
    const RationalKernel reference;
    const Triangle& t = query.triangle();
    std::visit([&](const auto& probe) { ASSERT_EQ(classify(probe, t, k), classify(probe, t, reference)); },
               query.probe);
    if (const Ray* r = std::get_if<Ray>(&query.probe)) {
      ASSERT_EQ(k.compare_hits(*r, t, other), reference.compare_hits(*r, t, other));
    }
    signs = tally.bound + tally.expansions + tally.dyadic;
  }
};

TEST(ExpansionKernel, AgreesWithTheReferenceOnAllFamilies) {
  constexpr std::uint64_t cases_of_each = 4000;
  Comparison all;
  for (const Family& family : families_of(Operands::triangles)) {
    for (const Format format : {Format::binary64, Format::binary32}) {
      Triangle last{};
      for (std::uint64_t k = 0; k < cases_of_each; ++k) {
        const Trial trial = family.make(format, 14, k);
        all.hold(trial.query, last);
        ASSERT_FALSE(HasFailure()) << family.name << " " << name_of(format) << " " << k;
        last = trial.query.triangle();
      }
    }
  }
  EXPECT_GT(all.signs, 500'000u);
  EXPECT_GT(all.tally.bound, 100'000u);
  EXPECT_GT(all.tally.expansions, 100'000u);
  EXPECT_GT(all.tally.dyadic, 1'000u);
  EXPECT_LT(all.tally.dyadic, all.signs / 8) << "GMP decides what expansions are for";
  std::printf("[ signs ] %llu by the bound, %llu by expansions, %llu by GMP\n",
              static_cast<unsigned long long>(all.tally.bound), static_cast<unsigned long long>(all.tally.expansions),
              static_cast<unsigned long long>(all.tally.dyadic));
}

/// Every segment and ray on the corners of a cube against every triangle on them, at a size where nothing is exact
/// in double: (1, 1, 1) and its neighbours as far as they can be from each other with differences that round.
TEST(ExpansionKernel, AgreesWithTheReferenceOnASmallScopeThatRounds) {
  const auto corner = [](int i) {
    const double near[] = {0x1.0000000000001p0, 0x1.fffffffffffffp-54};
    return Point3(near[i & 1], near[i >> 1 & 1], near[i >> 2 & 1]);
  };
  Comparison all;
  for (int code = 0; code < 8 * 8 * 8 * 8 * 8; ++code) {
    const auto digit = [&](int i) { return code >> (3 * i) & 7; };
    const Triangle t{corner(digit(0)), corner(digit(1)), corner(digit(2))};
    const Point3 p = corner(digit(3)), q = corner(digit(4));
    const Probe probe = digit(0) % 2 == 0 ? Probe(Segment{p, q}) : Probe(Ray{p, {q}});
    all.hold({probe, t}, {t.c, t.a, q});
    ASSERT_FALSE(HasFailure()) << code;
  }
  EXPECT_EQ(all.tally.dyadic, 0u);
  EXPECT_GT(all.tally.expansions, 10'000u);
}

}  // namespace
}  // namespace tribunal
