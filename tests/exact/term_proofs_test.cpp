// The constants of the filters by terms: proved by Gappa for terms that pass so many roundings, and the roundings
// counted in the shipped lines by a symbolic number type.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "exact/filtered/term_filter.h"
#include "exact/filtered/within_filter.h"
#include "tests/exact/proofs.h"

namespace tribunal {
namespace {

/// A sum of terms, none of them twice. Each is the product of some letters, in alphabetical order, and has the number
/// of roundings that it passed. The rounding of a difference of two coordinates, an arm, counts among the arm's own.
class Roundings {
 public:
  struct Comparison;
  static std::vector<Comparison> compared;  ///< what was asked to be greater than what

  Roundings() = default;
  explicit Roundings(double coordinate) : is_coordinate_(true) { terms_[letter(coordinate)] = 0; }
  static Roundings constant() { return of({{"", 0}}); }
  static void begin_anew() { arm_count = first_arm; }

  const std::map<std::string, int>& terms() const { return terms_; }
  std::size_t degree() const { return terms_.empty() ? 0 : terms_.begin()->first.size(); }
  int most() const {
    int most = 0;
    for (const auto& [letters, roundings] : terms_) most = std::max(most, roundings);
    return most;
  }

  friend Roundings operator+(const Roundings& a, const Roundings& b) {
    Roundings sum = a.rounded();
    for (const auto& [letters, roundings] : b.rounded().terms_) sum.add(letters, roundings);
    return sum;
  }
  friend Roundings operator-(const Roundings& a, const Roundings& b) {
    return a.is_coordinate_ && b.is_coordinate_ ? of({{next_letter(), 0}}) : a + b;
  }
  friend Roundings operator-(const Roundings& a) { return a; }
  friend Roundings operator*(const Roundings& a, const Roundings& b) {
    Roundings product;
    for (const auto& [left, n] : a.terms_) {
      for (const auto& [right, m] : b.terms_) {
        std::string letters = left + right;
        std::ranges::sort(letters);
        product.add(letters, n + m + 1);
      }
    }
    return product;
  }
  friend bool operator>(const Roundings& a, const Roundings& b);
  friend bool operator<(const Roundings&, const Roundings&) { return true; }

 private:
  static std::string letter(double coordinate) { return {static_cast<char>(coordinate)}; }
  static std::string next_letter() { return letter(arm_count++); }
  static Roundings of(std::map<std::string, int> terms) {
    Roundings sum;
    sum.terms_ = std::move(terms);
    return sum;
  }

  void add(const std::string& letters, int roundings) {
    EXPECT_TRUE(terms_.emplace(letters, roundings).second) << letters << " came twice: it may cancel";
  }
  Roundings rounded() const {
    Roundings sum = *this;
    for (auto& [letters, roundings] : sum.terms_) ++roundings;
    return sum;
  }

  static constexpr char first_arm = 'A';
  static inline char arm_count = first_arm;
  std::map<std::string, int> terms_;
  bool is_coordinate_ = false;
};

struct Roundings::Comparison {
  Roundings value, bound;
};

std::vector<Roundings::Comparison> Roundings::compared;

bool operator>(const Roundings& a, const Roundings& b) {
  Roundings::compared.push_back({a, b});
  return true;
}

}  // namespace

template <>
inline Roundings detail::magnitude(const Roundings& x) {
  return x;
}

namespace {

std::vector<std::string> letters_of(const Roundings& x) {
  std::vector<std::string> letters;
  for (const auto& [term, roundings] : x.terms()) letters.push_back(term);
  return letters;
}

/// Coordinates as letters from `first` on. What the filter subtracts becomes an arm with a letter of its own.
Vec3<Roundings> vector_from(char first) { return {Roundings(first), Roundings(first + 1), Roundings(first + 2)}; }

Point3 point_from(char first) { return {first, first + 1, first + 2}; }

/// K and the limits of range are constants; `tiny` covers underflow alone and counts as nothing here.
const FilterConstants<Roundings> constants{Roundings::constant(), Roundings(), Roundings::constant()};

/// What a sign of this degree was taken from, last.
Roundings::Comparison sign_taken(std::size_t degree) {
  const auto of_degree = [&](const Roundings::Comparison& c) { return c.value.degree() == degree; };
  std::vector<Roundings::Comparison> all = std::exchange(Roundings::compared, {});
  Roundings::begin_anew();
  std::erase_if(all, [&](const auto& c) { return !of_degree(c) || c.bound.terms().empty(); });
  EXPECT_FALSE(all.empty()) << "no sign was taken";
  return all.empty() ? Roundings::Comparison() : all.back();
}

/// As many roundings as a script takes, of these terms, each of which the bound knows.
void expect_roundings(const Roundings::Comparison& c, std::size_t terms, int value, int bound) {
  EXPECT_EQ(c.value.terms().size(), terms);
  EXPECT_EQ(letters_of(c.value), letters_of(c.bound));
  EXPECT_EQ(c.value.most(), value);
  EXPECT_EQ(c.bound.most(), bound);
}

constexpr int volume_value = 5, volume_bound_roundings = 7;      // d1 … d5 and e1 … e7 of terms.g
constexpr int order_value = 5 + 5 + 2, order_bound = 5 + 5 + 4;  // d, f, g and e, h, i

TEST(TermProofs, TheSourceLinesRoundEachTermOfAVolumeAsTermsGSays) {
  filter_terms(vector_from('a'), vector_from('d'), vector_from('g'), constants);
  expect_roundings(sign_taken(3), 6, volume_value, volume_bound_roundings);
  filter_orient3d_by_terms(point_from('a'), point_from('d'), point_from('g'), point_from('j'), constants);
  expect_roundings(sign_taken(3), 6, volume_value, volume_bound_roundings);
}

TEST(TermProofs, TheSourceLinesRoundEachTermByMinorsAsTermsGSays) {
  sign_of(expanded(minors_of(vector_from('a'), vector_from('d')), vector_from('g')), constants);
  expect_roundings(sign_taken(3), 6, volume_value, volume_bound_roundings);
}

TEST(TermProofs, TheSourceLinesRoundEachTermOfAnOrderAsTermsGSays) {
  const Ray ray{point_from('a'), {point_from('d')}};
  const Triangle s{point_from('g'), point_from('j'), point_from('m')};
  const Triangle t{point_from('p'), point_from('s'), point_from('v')};
  filter_compare_hits_by_terms(ray, s, t, constants, constants);
  expect_roundings(sign_taken(6), 72, order_value, order_bound);
}

TEST(TermProofs, TheSourceLinesRoundEachTermOfASideAsWithinGSays) {
  const auto minors = minors_of(vector_from('a'), vector_from('d'));
  filter_side(expanded(minors, vector_from('g')), expanded(minors, vector_from('j')), Roundings('t'), constants);
  const auto taken = std::exchange(Roundings::compared, {});
  Roundings::begin_anew();
  ASSERT_FALSE(taken.empty());
  expect_roundings(taken.back(), 12, volume_value + 2, volume_bound_roundings + 2);
}

/// The script has the rounding of the bound in it, so what is proved may be as large as K and no larger.
void expect_covers(const FilterConstants<double>& filter, double proved, double units) {
  EXPECT_NEAR(proved / rounding, units, units * 1e-6);
  EXPECT_LT(proved, filter.k);
}

TEST(TermProofs, GappaProvesTheConstants) {
  const auto proved = proved_by("terms.g");
  expect_covers(volume_terms_filter, proved.at("volume"), 8);
  expect_covers(order_terms_filter, proved.at("order"), 18);
}

TEST(TermProofs, GappaProvesTheSideOfAPointOfARay) {
  expect_covers(side_terms_filter, proved_by("within.g").at("side"), 10);
  const auto range = proved_by("within_range.g");
  EXPECT_LT(range.at("e_side_filter"), side_terms_filter.tiny);
  EXPECT_LT(range.at("m_side"), 0x1p1000);
  EXPECT_EQ(side_terms_filter.huge, 0x1p150);
  EXPECT_LE(side_terms_filter.k, 11 * rounding) << "what within_range.g takes it to be";
}

TEST(TermProofs, GappaProvesTheRangeGuards) {
  const auto proved = proved_by("terms_range.g");
  EXPECT_LT(proved.at("e_terms_filter"), volume_terms_filter.tiny);
  EXPECT_LT(proved.at("o_terms_filter"), order_terms_filter.tiny);
  for (const char* largest : {"m_volume", "n_order"}) EXPECT_LT(proved.at(largest), 0x1p1000);
  EXPECT_EQ(volume_terms_filter.huge, 0x1p150);
  EXPECT_EQ(order_terms_filter.huge, 0x1p100);
  EXPECT_LE(volume_terms_filter.k, 9 * rounding) << "what terms_range.g takes it to be";
  EXPECT_LE(order_terms_filter.k, 21 * rounding);
}

}  // namespace
}  // namespace tribunal
