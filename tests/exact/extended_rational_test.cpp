// IEEE arithmetic without rounding: the rules of infinities and NaN, and exactness across the limits of a word.
#include "exact/kernels/extended_rational.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace tribunal {
namespace {

const double inf = std::numeric_limits<double>::infinity();

/// Numbers on which binary64 does not round in + − × and comparisons, nor in division where the quotient is dyadic.
const std::vector<double> numbers = {0, 1, -1, 2, -2, 0.5, -0.25, 1024, -4096, inf, -inf, std::nan("")};

void expect_same(const ExtendedRational& x, double expected, const char* operation, double a, double b) {
  const bool same = std::isnan(expected) ? x.is_nan() : x == ExtendedRational(expected);
  EXPECT_TRUE(same) << a << " " << operation << " " << b;
}

TEST(ExtendedRational, FollowsIeeeWhereNothingRounds) {
  for (const double a : numbers) {
    for (const double b : numbers) {
      const ExtendedRational x(a), y(b);
      expect_same(x + y, a + b, "+", a, b);
      expect_same(x - y, a - b, "-", a, b);
      expect_same(x * y, a * b, "*", a, b);
      expect_same(x / y, a / b, "/", a, b);
      EXPECT_EQ(x < y, a < b) << a << " < " << b;
      EXPECT_EQ(x <= y, a <= b) << a << " <= " << b;
      EXPECT_EQ(x > y, a > b) << a << " > " << b;
      EXPECT_EQ(x >= y, a >= b) << a << " >= " << b;
      EXPECT_EQ(x == y, a == b) << a << " == " << b;
      EXPECT_EQ(x != y, a != b) << a << " != " << b;
    }
    expect_same(-ExtendedRational(a), -a, "negated", a, a);
  }
}

TEST(ExtendedRational, HasOneZero) {
  EXPECT_TRUE(1 / ExtendedRational(-0.0) == ExtendedRational(inf));
  EXPECT_TRUE(1 / -ExtendedRational(0) == ExtendedRational(inf));
}

/// Words, and what does not fit a word, against GMP alone.
TEST(ExtendedRational, IsExactWhereWordsOverflow) {
  const std::vector<double> edges = {3,      -7,      0x1p31, -0x1.fffffep31, 0x1p52 + 1, -0x1p53,   0x1p62,
                                     0x1p63, -0x1p63, 0x1p64, 0x1p-1074,      0.1,        -0x1p1000, 1e-6};
  int big = 0;
  for (const double a : edges) {
    for (const double b : edges) {
      for (const double c : edges) {
        const mpq_class x(a), y(b), z(c);
        const ExtendedRational e(a), f(b), g(c);
        EXPECT_EQ((e * f + g).fraction(), x * y + z) << a << " " << b << " " << c;
        EXPECT_EQ((e / f - g).fraction(), x / y - z) << a << " " << b << " " << c;
        EXPECT_EQ(e / f < g / e, x / y < z / x) << a << " " << b << " " << c;
        EXPECT_EQ(e * f == g * e, x * y == z * x) << a << " " << b << " " << c;
        EXPECT_TRUE((e / f) * f == e) << a << " " << b;
        big += !mpq_class(x * y + z).get_num().fits_slong_p();
      }
    }
  }
  EXPECT_GT(big, 500);
}

}  // namespace
}  // namespace tribunal
