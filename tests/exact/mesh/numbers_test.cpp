// Numerals: correctly rounded, the same in every locale, and refused for the right reason.
#include "exact/mesh/numbers.h"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "tests/exact/comma_locale.h"
#include "tests/tracer/support.h"

namespace tribunal {
namespace {

template <class Number>
Number value_of(const std::string& numeral) {
  Number x{};
  EXPECT_EQ(parse_number(numeral, x), NumberFault::none) << numeral;
  return x;
}

template <class Number>
NumberFault fault_of(const std::string& numeral) {
  Number x{};
  return parse_number(numeral, x);
}

TEST(Numbers, AreRoundedCorrectly) {
  EXPECT_EQ(value_of<double>("0.1" + std::string(400, '0')), 0.1);
  EXPECT_EQ(value_of<double>("9007199254740993"), 0x1p53) << "a tie goes to the even neighbour";
  EXPECT_EQ(value_of<double>("9007199254740993." + std::string(800, '0') + "1"), 0x1.0000000000001p53);
  EXPECT_EQ(value_of<double>("4.9406564584124654e-324"), 0x1p-1074);
  EXPECT_EQ(value_of<double>("1.7976931348623157e308"), std::numeric_limits<double>::max());
  EXPECT_EQ(value_of<double>("+2."), 2);
  EXPECT_EQ(value_of<double>("-.5E1"), -5);
  EXPECT_EQ(value_of<float>("0.1"), 0.1f);
  EXPECT_EQ(value_of<float>("1.00000005960464477540"), 0x1.000002p0f) << "rounded once, not through binary64";
}

TEST(Numbers, TooSmallForTheFormatAreZerosOfTheirSign) {
  for (const char* tiny : {"1e-400", "2e-324", "0.0001e-320", "123e-99999999999999999999", "1e-9223372036854775807"}) {
    const double x = value_of<double>(tiny);
    const double y = value_of<double>(std::string("-") + tiny);
    EXPECT_TRUE(x == 0 && !std::signbit(x)) << tiny;
    EXPECT_TRUE(y == 0 && std::signbit(y)) << tiny;
  }
  EXPECT_EQ(value_of<double>("0." + std::string(400, '0') + "1"), 0);
  EXPECT_EQ(value_of<float>("1e-46"), 0);
  EXPECT_EQ(value_of<double>("3e-324"), 0x1p-1074);
}

TEST(Numbers, TooLargeForTheFormatAreRefused) {
  for (const char* huge : {"1e309", "-1e999", "1e99999999999999999999", "0.001e312", "1e9223372036854775807"}) {
    EXPECT_EQ(fault_of<double>(huge), NumberFault::out_of_range) << huge;
  }
  EXPECT_EQ(fault_of<double>("1" + std::string(400, '0')), NumberFault::out_of_range);
  EXPECT_EQ(fault_of<float>("1e39"), NumberFault::out_of_range);
  EXPECT_EQ(fault_of<long long>("99999999999999999999"), NumberFault::out_of_range);
}

TEST(Numbers, OtherTokensAreRefused) {
  EXPECT_EQ(fault_of<double>(""), NumberFault::missing);
  for (const char* word : {"x", "1x", "0x1p3", "1e", "1e+", "+-1", "--1", "+", "-", ".", "1,5", "1 2"}) {
    EXPECT_EQ(fault_of<double>(word), NumberFault::malformed) << word;
  }
  for (const char* word : {"nan", "-nan", "inf", "-infinity", "NAN", "nan(1)"}) {
    EXPECT_EQ(fault_of<double>(word), NumberFault::not_finite) << word;
  }
  for (const char* word : {"1.0", "1e3", "", "0x10"}) EXPECT_NE(fault_of<long long>(word), NumberFault::none) << word;
  EXPECT_EQ(value_of<long long>("+12"), 12);
  EXPECT_EQ(value_of<long long>("-0"), 0);
}

/// Whether no binary64 number is nearer to the decimal n·10^−20 than x.
bool is_nearest(double x, const mpz_class& n) {
  mpz_class scale;
  mpz_ui_pow_ui(scale.get_mpz_t(), 10, 20);
  const mpq_class exact(n, scale);
  const mpq_class error = abs(mpq_class(x) - exact);
  const double neighbours[] = {std::nextafter(x, -1e300), std::nextafter(x, 1e300)};
  return error <= abs(mpq_class(neighbours[0]) - exact) && error <= abs(mpq_class(neighbours[1]) - exact);
}

TEST(Numbers, AreNearestAmongRationals) {
  testing::Random random(7);
  for (int i = 0; i < 10000; ++i) {
    const std::string digits =
        std::to_string(1000000000 + random.below(1000000000)) + std::to_string(1000000000 + random.below(1000000000));
    EXPECT_TRUE(is_nearest(value_of<double>("0." + digits), mpz_class(digits))) << digits;
  }
}

TEST(Numbers, DoNotAskTheLocale) {
  const CommaLocale comma;
  ASSERT_TRUE(comma.speaks());
  EXPECT_EQ(value_of<double>("1.5"), 1.5);
  EXPECT_EQ(fault_of<double>("1,5"), NumberFault::malformed);
}

}  // namespace
}  // namespace tribunal
