// The correctly rounded parameter of a hit, bit for bit, against another formula over fractions, rounded by MPFR.
#include "exact/filtered/rounded_parameter.h"

#include <gtest/gtest.h>

#include <bit>
#include <limits>
#include <stdexcept>

#include "exact/filtered/hit_fraction.h"
#include "tests/exact/exact_parameter.h"
#include "tests/exact/scaled_rays.h"

namespace tribunal {
namespace {

using testing::environments;
using testing::ExactParameter;
using testing::InEnvironment;
using testing::scaled_scene;
using testing::ScaledScene;

constexpr double infinity = std::numeric_limits<double>::infinity();

std::uint64_t bits(double x) { return std::bit_cast<std::uint64_t>(x); }

/// Whether two numbers have the same bits; +0 and −0 count as equal.
bool are_equal(double x, double y) { return bits(x) == bits(y) || ((bits(x) | bits(y)) << 1) == 0; }

/// Counts of what was seen in a population of cases.
struct Seen {
  std::uint64_t pairs = 0, wrong = 0, by_filter = 0, subnormal = 0, infinite = 0, zero = 0;

  void operator()(const Ray& r, const Triangle& t, unsigned environment) {
    const ExactParameter exact(r, t);
    if (exact.parallel) return;
    const double expected = exact.rounded();
    ++pairs;
    if (const auto certain = filter_rounded_parameter(r, t)) {
      ++by_filter;
      wrong += !are_equal(*certain, expected);
    }
    {
      const InEnvironment foreign(environment);
      wrong += !are_equal(rounded_parameter(r, t), expected);
    }
    const int kind = std::fpclassify(expected);
    subnormal += kind == FP_SUBNORMAL;
    infinite += kind == FP_INFINITE;
    zero += kind == FP_ZERO;
  }
};

/// Small integers, scaled over the whole range of the format: parameters of all sizes, many of them short fractions.
TEST(RoundedParameter, IsThatOfAnotherFormulaAtEveryScale) {
  for (const Format format : {Format::binary32, Format::binary64}) {
    Seen seen;
    for (std::uint64_t k = 0; k < 700; ++k) {
      const ScaledScene scene = scaled_scene(format, k);
      for (const Ray& r : scene.rays) {
        for (const Triangle& t : scene.triangles) seen(r, t, environments[k % std::size(environments)]);
      }
    }
    EXPECT_EQ(seen.wrong, 0U);
    EXPECT_GT(seen.pairs, 80'000U);
    EXPECT_GT(seen.by_filter, 15'000U);
    EXPECT_GT(seen.zero, 500U);
    if (format == Format::binary32) continue;
    EXPECT_GT(seen.pairs - seen.by_filter, 60'000U);
    EXPECT_GT(seen.subnormal, 50U);
    EXPECT_GT(seen.infinite, 50U);
  }
}

double full(Draw& draw, double size) {
  const auto mantissa = static_cast<double>(draw.between(-(std::int64_t{1} << 53), std::int64_t{1} << 53));
  return mantissa * 0x1p-53 * size;
}

Point3 full_point(Draw& draw, double size) {
  const double x = full(draw, size);
  const double y = full(draw, size);
  const double z = full(draw, size);
  return {x, y, z};
}

/// Full mantissas; half of the sources next to the plane, where doubles have no right digit.
TEST(RoundedParameter, IsThatOfAnotherFormulaForFullMantissas) {
  Draw draw(980, 1, 0);
  Seen seen;
  for (int i = 0; i < 60'000; ++i) {
    const double size = std::ldexp(1, static_cast<int>(draw.between(-30, 30)));
    const Point3 a = full_point(draw, size);
    const Point3 b = full_point(draw, size);
    const Point3 c = full_point(draw, size);
    const double s = std::fabs(full(draw, 1));
    const Point3 on_plane = a + s * (b - a) + 0.25 * (c - a);
    const Point3 anywhere = full_point(draw, size);
    const Point3 d = full_point(draw, std::ldexp(size, static_cast<int>(draw.between(-40, 40))));
    seen({i % 2 == 0 ? on_plane : anywhere, {d}}, {a, b, c},
         environments[static_cast<std::size_t>(i) % std::size(environments)]);
  }
  EXPECT_EQ(seen.wrong, 0U);
  EXPECT_GT(seen.by_filter, 29'900U) << "the filter should tell nearly all of those that start away from the plane";
  EXPECT_GT(seen.pairs - seen.by_filter, 29'900U);
}

/// A plane z = height, at right angles to the ray.
double along_z(double from, double to, double d) {
  const Triangle t{{-1, -1, to}, {1, -1, to}, {0, 1, to}};
  return rounded_parameter({{0, 0, from}, {{0, 0, d}}}, t);
}

TEST(RoundedParameter, TiesGoToEven) {
  for (const unsigned environment : environments) {
    const InEnvironment foreign(environment);
    EXPECT_EQ(bits(along_z(-1, 0x1p53, 1)), bits(0x1p53));
    EXPECT_EQ(bits(along_z(-1, 0x1p53 + 2, 1)), bits(0x1p53 + 4));
    EXPECT_EQ(bits(along_z(0, 1, 0x1p1023)), bits(0x1p-1023));
    EXPECT_EQ(bits(along_z(0, 0x1p-1000, 0x1p74)), 1U);
    EXPECT_EQ(bits(along_z(0, 0x1p-1000, 0x1p75)), 0U) << "half of the least number";
    EXPECT_EQ(bits(along_z(0, 3 * 0x1p-1000, 0x1p75)), 2U);
    EXPECT_EQ(bits(along_z(0, 0x1.8p-1000, 0x1p75)), 1U);
    EXPECT_EQ(bits(along_z(0, 5 * 0x1p-1000, 0x1p75)), 2U);
    EXPECT_EQ(bits(along_z(1 - 0x1p53, 0x1p53, 0x1p-970)), bits(infinity)) << "2^1024 - 2^970";
    EXPECT_EQ(bits(along_z(2 - 0x1p53, 0x1p53, 0x1p-970)), bits(std::numeric_limits<double>::max()));
    EXPECT_EQ(bits(along_z(0, -1, 0x1p-1070)), bits(-infinity));
    EXPECT_EQ(bits(along_z(0, 1, 3)), bits(0x1.5555555555555p-2));
    EXPECT_EQ(bits(along_z(7, 7, 3)), 0U);
  }
}

/// 2⁵³ + 1 ± 2⁻⁶⁰ takes 114 bits; without the last of them it is a tie.
TEST(RoundedParameter, TheFilterAbstainsNextToATie) {
  const Triangle tilted{{0, 0, 0}, {1, 0, 0x1p-30}, {0, 1, 1}};
  const Ray above{{0x1p-30, 1, -0x1p53}, {{0, 0, 1}}}, below{{-0x1p-30, 1, -0x1p53}, {{0, 0, 1}}};
  EXPECT_FALSE(filter_rounded_parameter(above, tilted) || filter_rounded_parameter(below, tilted));
  EXPECT_EQ(rounded_parameter(above, tilted), 0x1p53 + 2);
  EXPECT_EQ(rounded_parameter(below, tilted), 0x1p53);
}

TEST(RoundedParameter, CarriesIntoTheNextBinadeAndOutOfTheSubnormals) {
  EXPECT_EQ(rounded(mpq_class(mpz_class((mpz_class(1) << 54) - 1), 2)), 0x1p53);
  mpq_class just_below(mpz_class((mpz_class(1) << 53) - 1), mpz_class(1) << 1075);
  just_below.canonicalize();
  EXPECT_EQ(rounded(just_below), 0x1p-1022);
  EXPECT_EQ(rounded(-just_below), -0x1p-1022);
}

TEST(RoundedParameter, ThereIsNoneAlongAPlane) {
  EXPECT_THROW(rounded_parameter({{0, 0, 1}, {{1, 0, 0}}}, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}), std::domain_error);
  EXPECT_THROW(rounded_parameter({{0, 0, 1}, {{1, 0, 1}}}, {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}), std::domain_error);
}

}  // namespace
}  // namespace tribunal
