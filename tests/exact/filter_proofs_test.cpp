// The constants of the filters: proved by Gappa, derived again from the source lines by an error-tracking number type,
// and tried on every input of small floating-point formats.
#include <gtest/gtest.h>

#include <cmath>

#include "exact/cases/families/draw.h"
#include "exact/filtered/filter.h"
#include "exact/filtered/filtered.h"
#include "exact/filtered/term_filter.h"
#include "exact/kernels/rational_kernel.h"
#include "tests/exact/proofs.h"

namespace tribunal {

namespace {

/// Expects that a filter's constant covers what is proved, with room for the up to seven roundings of the bound
/// itself.
void expect_covers(const FilterConstants<double>& filter, double proved, double units) {
  EXPECT_NEAR(proved / rounding, units, units * 2e-4);
  EXPECT_LT(proved * (1 + 8 * rounding), filter.k);
}

TEST(FilterProofs, GappaProvesTheConstants) {
  expect_covers(volume_filter, proved_by("volume.g").at("volume - exact"), 46);
  expect_covers(area_filter, proved_by("area.g").at("area - exact"), 8);
  expect_covers(order_filter, proved_by("order.g").at("difference - exact"), 1248);
}

TEST(FilterProofs, GappaProvesTheSharedVolumesFusedAndNot) {
  for (const char* script : {"shared_volumes.g", "shared_volumes_fused.g"}) {
    const auto proved = proved_by(script);
    double worst = 0;
    for (const char* volume : {"source - SOURCE", "toward - TOWARD", "ab - AB", "ac - AC"}) {
      EXPECT_LE(proved.at(volume), 46.001 * rounding) << script << volume;
    }
    EXPECT_LE(proved.at("target - TARGET"), 104.001 * rounding) << script;
    for (const auto& [claim, bound] : proved) worst = std::max(worst, bound);
    EXPECT_EQ(worst, proved.at("bc - BC")) << script;
    EXPECT_LT(worst * (1 + 8 * rounding), pair_filter<Segment>.k);
    EXPECT_LE(worst, 168.001 * rounding);
    for (const char* identity : {"target - (source + toward)", "bc - (toward - ab + ac)"}) {
      EXPECT_LT(proved.at(identity), pair_filter<Segment>.k / 2) << script;
    }
  }
}

TEST(FilterProofs, GappaProvesWhatIsConcluded) {
  const auto proved = proved_by("decision.g");
  EXPECT_EQ(proved.size(), 5U);
  for (const auto& [claim, bound] : proved) EXPECT_LT(bound, 0) << claim;
  for (const double k : {pair_filter<Segment>.k, pair_filter<Ray>.k}) {
    EXPECT_GE(k * (1 - 4 * rounding), 169 * rounding) << "what decision.g takes the bound to be";
  }
}

TEST(FilterProofs, GappaProvesThatARayMissesByItsSource) {
  const auto proved = proved_by("ray_decision.g");
  ASSERT_EQ(proved.size(), 2U);
  for (const auto& [claim, bound] : proved) EXPECT_LT(bound, pair_filter<Ray>.k) << claim;
  EXPECT_LT(proved_by("ray_range.g").at("e_source + e_toward + e_bound"), pair_filter<Ray>.tiny);
  EXPECT_EQ(pair_filter<Ray>.huge, 0x1p150);
  EXPECT_EQ(pair_filter<Ray>.direction, 0x1p-150);
}

TEST(FilterProofs, GappaProvesTheRangeGuards) {
  const auto proved = proved_by("range.g");
  EXPECT_LT(proved.at("e_edge + e_bound"), volume_filter.tiny);
  EXPECT_LT(proved.at("e_edge + e_bound"), pair_filter<Segment>.tiny);
  EXPECT_LT(proved.at("e_edge + e_bound"), pair_filter<Ray>.tiny);
  EXPECT_LT(proved.at("e_minor + e_bound * 1b-150"), area_filter.tiny);
  EXPECT_LT(proved.at("o_order"), order_filter.tiny);
  for (const char* largest : {"m_edge", "n_order"}) EXPECT_LT(proved.at(largest), 0x1p1000);
  EXPECT_EQ(volume_filter.huge, 0x1p150);
  EXPECT_EQ(pair_filter<Segment>.huge, 0x1p150);
  EXPECT_EQ(area_filter.huge, 0x1p150);
  EXPECT_EQ(order_filter.huge, 0x1p100);
}

void expect_units(const Tracked& x, double units) { EXPECT_NEAR(x.error / rounding, units, units * 1e-9); }

TEST(FilterProofs, TheTrackedErrorOfTheSourceLinesIsTheProvedOne) {
  const Point3 any{0, 0, 0};
  expect_units(signed_volume<Tracked>(any, any, any, any), 46);
  expect_units(signed_area<Tracked>(Axis::z, any, any, any), 8);
  const SharedVolumes<Tracked> v = shared_volumes<Segment>(arms_of<Tracked>(Segment{}, Triangle{}));
  for (const Tracked& x : {v.sides.source, v.sides.toward, v.edges.ab, v.edges.ac}) expect_units(x, 46);
  expect_units(v.sides.target, 104);
  expect_units(v.edges.bc, 168);
  const Tracked volume = signed_volume<Tracked>(any, any, any, any);
  expect_units(volume * volume - volume * volume, 1248);
}

/// The filter's constants where one operation is off by at most 2^-bits: the units that Gappa proves, the terms of
/// higher order bounded by (1 + u)^n, over a divisor that makes them too small.
template <int bits>
FilterConstants<Toy<bits>> toy_filter(double units, double magnitude, int depth, double divisor = 1) {
  const double u = std::ldexp(1.0, -bits);
  const double bound = (units + magnitude * (std::pow(1 + u, depth) - 1 - depth * u) / u) * u * std::pow(1 + u, 4);
  FilterConstants<Toy<bits>> c;
  c.k.x = bound / divisor;
  c.huge.x = 1e9;
  return c;
}

/// Every float of `bits` bits in three binades, with zero and both signs.
std::vector<double> toy_floats(int bits) {
  std::vector<double> all{0};
  for (int e = 0; e < 3; ++e) {
    for (int m = 1 << (bits - 1); m < 1 << bits; ++m) {
      all.push_back(std::ldexp(m, e));
      all.push_back(-std::ldexp(m, e));
    }
  }
  return all;
}

/// The shipped orient2d filter, computed with 4 bits, on all triangles whose coordinates are floats of `bits` bits and
/// one of them zero. With fewer bits of arithmetic the bound exceeds every area, and nothing is certain.
template <int bits>
Outcome enumerate_areas(double divisor) {
  const auto c = toy_filter<4>(8, 2, 4, divisor);
  const std::vector<double> all = toy_floats(bits);
  Outcome outcome;
  for (const double ax : all) {
    for (const double bx : all) {
      for (const double by : all) {
        for (const double px : all) {
          for (const double py : all) {
            const Point3 a(ax, 0, 0), b(bx, by, 0), p(px, py, 0);
            outcome.add(filter_orient2d(Axis::z, a, b, p, c), signed_area<double>(Axis::z, a, b, p));
          }
        }
      }
    }
  }
  return outcome;
}

TEST(ToyFloats, NoCertainAreaIsWrong) {
  for (const Outcome& o : {enumerate_areas<2>(1), enumerate_areas<3>(1)}) {
    EXPECT_EQ(o.wrong, 0U);
    EXPECT_GT(o.certain, 100U);
    EXPECT_GT(o.undecided, 100U);
  }
}

TEST(ToyFloats, AConstantTooSmallGivesWrongAreas) { EXPECT_GT(enumerate_areas<3>(8).wrong, 0U); }

/// The constant of a bound by terms, each off by `depth` roundings, in a bound that is rounded eight times itself.
template <int bits>
FilterConstants<Toy<bits>> toy_terms_filter(int depth, double divisor = 1) {
  const double u = std::ldexp(1.0, -bits);
  FilterConstants<Toy<bits>> c;
  c.k.x = (std::pow(1 + u, depth) - 1) / std::pow(1 - u, 8) / divisor;
  c.huge.x = 1e9;
  return c;
}

/// A shipped filter of det3 on all nine-tuples of these values, computed with `bits` bits.
template <int bits, class Filter>
Outcome enumerate_volumes(std::initializer_list<double> values, const Filter& filter) {
  std::vector<Vec3<double>> vectors;
  for (const double x : values) {
    for (const double y : values) {
      for (const double z : values) vectors.push_back({x, y, z});
    }
  }
  const auto toy = [](const Vec3<double>& v) {
    return Vec3<Toy<bits>>{Toy<bits>(v.x), Toy<bits>(v.y), Toy<bits>(v.z)};
  };
  Outcome outcome;
  for (const auto& u : vectors) {
    for (const auto& v : vectors) {
      for (const auto& w : vectors) outcome.add(filter(toy(u), toy(v), toy(w)), det3(u, v, w));
    }
  }
  return outcome;
}

constexpr std::initializer_list<double> six_bits = {-63, -41, 0, 47, 53};

Outcome volumes_by_largest(double divisor) {
  const auto c = toy_filter<6>(46, 6, 8, divisor);
  return enumerate_volumes<6>(six_bits,
                              [&](const auto& u, const auto& v, const auto& w) { return filter_volume(u, v, w, c); });
}

Outcome volumes_by_terms(double divisor) {
  const auto c = toy_terms_filter<6>(8, divisor);
  return enumerate_volumes<6>(six_bits,
                              [&](const auto& u, const auto& v, const auto& w) { return filter_terms(u, v, w, c); });
}

TEST(ToyFloats, NoCertainVolumeIsWrong) {
  const Outcome o = volumes_by_largest(1);
  EXPECT_EQ(o.certain + o.undecided, 1'953'125U);
  EXPECT_EQ(o.wrong, 0U);
  EXPECT_GT(o.certain, 1000U);
  EXPECT_GT(o.undecided, 1000U);
}

TEST(ToyFloats, AConstantTooSmallGivesWrongVolumes) { EXPECT_GT(volumes_by_largest(16).wrong, 0U); }

TEST(ToyFloats, TermsDecideMoreVolumesAndNoneWrong) {
  const Outcome o = volumes_by_terms(1);
  EXPECT_EQ(o.wrong, 0U);
  EXPECT_GT(o.certain, volumes_by_largest(1).certain);
  EXPECT_GT(o.undecided, 1000U);
}

TEST(ToyFloats, AConstantTooSmallGivesWrongVolumesByTerms) { EXPECT_GT(volumes_by_terms(8).wrong, 0U); }

/// Counts wrong certain answers of a shipped test on all 2¹⁵ pairs of a segment and a triangle with two values per
/// axis, for many pairs of values, against exact volumes.
template <int bits, class Filter>
Outcome enumerate_hits(int rounds, const Filter& filter) {
  Outcome outcome;
  for (int round = 0; round < rounds; ++round) {
    const int full = 1 << bits, seed = 7919 * round + 1;
    const auto value = [&](int k) { return static_cast<double>((seed * (2 * k + 3) * 31 + k * k * 17) % full); };
    for (int pattern = 0; pattern < 1 << 15; ++pattern) {
      Point3 v[5];
      for (int i = 0; i < 15; ++i) v[i / 3][i % 3] = value(2 * (i % 5) + (pattern >> i & 1));
      const Segment s{v[0], v[1]};
      const Triangle t{v[2], v[3], v[4]};
      const std::optional<bool> hit = filter(s, t);
      hit ? ++outcome.certain : ++outcome.undecided;
      outcome.wrong += hit && *hit != hits_exactly(s, t);
    }
  }
  return outcome;
}

Outcome hits_by_largest(double divisor) {
  const PairConstants<Toy<10>> c{toy_filter<10>(168, 18, 12, divisor), {}};
  return enumerate_hits<10>(20, [&](const Segment& s, const Triangle& t) { return filter_hits(s, t, c); });
}

Outcome hits_by_terms(double divisor) {
  const auto c = toy_terms_filter<10>(8, divisor);
  return enumerate_hits<10>(20, [&](const Segment& s, const Triangle& t) { return filter_hits_by_terms(s, t, c); });
}

TEST(ToyFloats, NoCertainHitIsWrong) {
  const Outcome o = hits_by_largest(1);
  EXPECT_EQ(o.wrong, 0U);
  EXPECT_GT(o.certain, 1000U);
  EXPECT_GT(o.undecided, 1000U);
}

TEST(ToyFloats, AConstantTooSmallGivesWrongHits) { EXPECT_GT(hits_by_largest(256).wrong, 0U); }

TEST(ToyFloats, TermsDecideMoreHitsAndNoneWrong) {
  const Outcome o = hits_by_terms(1);
  EXPECT_EQ(o.wrong, 0U);
  EXPECT_GT(o.certain, hits_by_largest(1).certain);
  EXPECT_GT(o.undecided, 1000U);
}

TEST(ToyFloats, AConstantTooSmallGivesWrongHitsByTerms) { EXPECT_GT(hits_by_terms(16).wrong, 0U); }

/// A 16-bit format in which underflow is near: least normal number 2⁻⁶⁰, arms below 2¹².
constexpr int toy_least = -60, toy_huge = 12;
using SmallToy = Toy<16, toy_least>;

/// The constants of ray_range.g for that format, with the direction at least 2^direction: there t is below
/// 2·2^huge/2^direction, and underflow adds less than 3·(2·huge²·(1 + 3u) + 2)·t·flush, three terms and two sums.
PairConstants<SmallToy> small_toy_filter(int direction, int guarded_direction) {
  const double flush = std::ldexp(1.0, toy_least), huge = std::ldexp(1.0, toy_huge);
  const double t_max = 2.1 * huge / std::ldexp(1.0, direction);
  PairConstants<SmallToy> c;
  c.k.x = toy_filter<16>(168, 18, 12).k.x;
  c.tiny.x = 7 * huge * huge * t_max * flush;
  c.huge.x = huge;
  c.direction.x = std::ldexp(1.0, guarded_direction);
  return c;
}

/// Tries the shipped conclusion on rays that are aimed at a point of the triangle or near it, with independent scales
/// of direction and geometry, and components that underflow one by one. Judged exactly.
Outcome conclude_on_rays(std::uint64_t cases, const PairConstants<SmallToy>& c) {
  Outcome outcome;
  for (std::uint64_t k = 0; k < cases; ++k) {
    Draw draw(978, 1, k);
    const int most = draw.below(2) == 0 ? 3 : 31;
    const auto number = [&] { return static_cast<double>(draw.between(-most, most)); };
    Point3 a, b, c_, o, off;
    for (Point3* p : {&a, &b, &c_, &o, &off}) {
      for (int axis = 0; axis < 3; ++axis) (*p)[axis] = number();
    }
    const Point3 aim = a + b + c_ * 2.0 + (draw.below(2) == 0 ? Point3(0, 0, 0) : off);
    const int size = static_cast<int>(draw.between(-20, 6)), length = static_cast<int>(draw.between(toy_least - 9, 2));
    const auto scaled = [](const Point3& p, int e) { return p * std::ldexp(1.0, e); };
    const Ray r{scaled(o, size), {scaled(aim - o * 4.0, length)}};
    const Triangle t{scaled(a, size), scaled(b, size), scaled(c_, size)};
    const std::optional<bool> hit = filter_hits(r, t, c);
    hit ? ++outcome.certain : ++outcome.undecided;
    outcome.wrong += hit && *hit != hits_exactly(r, t);
  }
  return outcome;
}

TEST(ToyFloats, NoCertainAnswerToARayIsWrong) {
  const Outcome o = conclude_on_rays(2'000'000, small_toy_filter(-12, -12));
  EXPECT_EQ(o.wrong, 0U);
  EXPECT_GT(o.certain, 10'000U);
  EXPECT_GT(o.undecided, 10'000U);
}

TEST(ToyFloats, WithoutTheGuardOfDirectionsRaysAreLost) {
  EXPECT_GT(conclude_on_rays(2'000'000, small_toy_filter(-12, -1000)).wrong, 0U);
}

/// Two triangles across one ray, one of them the other with some coordinates moved a little: 10-bit numbers, 10-bit
/// arithmetic.
Outcome orders_by_terms(double divisor) {
  const auto volume = toy_terms_filter<10>(8, divisor), order = toy_terms_filter<10>(18, divisor);
  Outcome outcome;
  for (std::uint64_t k = 0; k < 200'000; ++k) {
    Draw draw(977, 1, k);
    const auto point = [&] {
      return Point3(static_cast<double>(draw.between(-511, 511)), static_cast<double>(draw.between(-511, 511)),
                    static_cast<double>(draw.between(-511, 511)));
    };
    const Ray r{point(), {point()}};
    const Triangle s{point(), point(), point()};
    Triangle t = s;
    for (Point3* v : {&t.a, &t.b, &t.c}) v->x += static_cast<double>(draw.between(-2, 2));
    outcome.add(filter_compare_hits_by_terms(r, s, t, order, volume), RationalKernel().compare_hits(r, s, t));
  }
  return outcome;
}

TEST(ToyFloats, NoCertainOrderIsWrongByTerms) {
  const Outcome o = orders_by_terms(1);
  EXPECT_EQ(o.wrong, 0U);
  EXPECT_GT(o.certain, 100U);
  EXPECT_GT(o.undecided, 1000U);
}

TEST(ToyFloats, AConstantTooSmallGivesWrongOrdersByTerms) { EXPECT_GT(orders_by_terms(32).wrong, 0U); }

}  // namespace
}  // namespace tribunal
