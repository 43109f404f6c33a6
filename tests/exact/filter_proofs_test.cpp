// The constants of the filters: proved by Gappa, derived again from the source lines by an error-tracking number type,
// and tried on every input of small floating-point formats.
#include <gtest/gtest.h>

#include <cmath>

#include "exact/filtered/filter.h"
#include "exact/filtered/filtered.h"
#include "tests/exact/proofs.h"

namespace tribunal {
namespace {

/// Proved, and left room for: the bound itself is rounded up to seven times.
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
    EXPECT_LT(worst * (1 + 8 * rounding), shared_volumes_filter.k);
    EXPECT_LE(worst, 168.001 * rounding);
    for (const char* identity : {"target - (source + toward)", "bc - (toward - ab + ac)"}) {
      EXPECT_LT(proved.at(identity), shared_volumes_filter.k / 2) << script;
    }
  }
}

TEST(FilterProofs, GappaProvesTheRangeGuards) {
  const auto proved = proved_by("range.g");
  EXPECT_LT(proved.at("e_edge + e_bound"), volume_filter.tiny);
  EXPECT_LT(proved.at("e_edge + e_bound"), shared_volumes_filter.tiny);
  EXPECT_LT(proved.at("e_minor + e_bound * 1b-150"), area_filter.tiny);
  EXPECT_LT(proved.at("o_order"), order_filter.tiny);
  for (const char* largest : {"m_edge", "n_order"}) EXPECT_LT(proved.at(largest), 0x1p1000);
  EXPECT_EQ(volume_filter.huge, 0x1p150);
  EXPECT_EQ(shared_volumes_filter.huge, 0x1p150);
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

/// The shipped filter of det3 on all nine-tuples of these values, computed with `bits` bits.
template <int bits>
Outcome enumerate_volumes(std::initializer_list<double> values, double divisor) {
  const auto c = toy_filter<bits>(46, 6, 8, divisor);
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
      for (const auto& w : vectors) outcome.add(filter_volume(toy(u), toy(v), toy(w), c), det3(u, v, w));
    }
  }
  return outcome;
}

TEST(ToyFloats, NoCertainVolumeIsWrong) {
  const Outcome o = enumerate_volumes<6>({-63, -41, 0, 47, 53}, 1);
  EXPECT_EQ(o.certain + o.undecided, 1'953'125U);
  EXPECT_EQ(o.wrong, 0U);
  EXPECT_GT(o.certain, 1000U);
  EXPECT_GT(o.undecided, 1000U);
}

TEST(ToyFloats, AConstantTooSmallGivesWrongVolumes) {
  EXPECT_GT(enumerate_volumes<6>({-63, -41, 0, 47, 53}, 16).wrong, 0U);
}

/// The shipped test itself, on segments and triangles whose coordinates take two values an axis: all 2¹⁵ of them, for
/// many pairs of values, against exact volumes. Returns certain answers that are wrong.
template <int bits>
Outcome enumerate_hits(double divisor, int rounds) {
  const auto c = toy_filter<bits>(168, 18, 12, divisor);
  Outcome outcome;
  for (int round = 0; round < rounds; ++round) {
    const int full = 1 << bits, seed = 7919 * round + 1;
    const auto value = [&](int k) { return static_cast<double>((seed * (2 * k + 3) * 31 + k * k * 17) % full); };
    for (int pattern = 0; pattern < 1 << 15; ++pattern) {
      Point3 v[5];
      for (int i = 0; i < 15; ++i) v[i / 3][i % 3] = value(2 * (i % 5) + (pattern >> i & 1));
      const Segment s{v[0], v[1]};
      const Triangle t{v[2], v[3], v[4]};
      const std::optional<bool> hit = filter_hits(s, t, c);
      hit ? ++outcome.certain : ++outcome.undecided;
      outcome.wrong += hit && *hit != hits_exactly(s, t);
    }
  }
  return outcome;
}

TEST(ToyFloats, NoCertainHitIsWrong) {
  const Outcome o = enumerate_hits<10>(1, 20);
  EXPECT_EQ(o.wrong, 0U);
  EXPECT_GT(o.certain, 1000U);
  EXPECT_GT(o.undecided, 1000U);
}

TEST(ToyFloats, AConstantTooSmallGivesWrongHits) { EXPECT_GT(enumerate_hits<10>(256, 20).wrong, 0U); }

}  // namespace
}  // namespace tribunal
