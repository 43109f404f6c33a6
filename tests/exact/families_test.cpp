// What the families of triangle cases draw: each case anew, segments and rays, to the ends of the range.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "exact/cases/families/pair_vectors.h"
#include "exact/cases/families/shapes.h"
#include "exact/cases/family_table.h"
#include "exact/methods/methods.h"
#include "exact/trial/fuzz.h"

namespace tribunal {
namespace {

constexpr std::uint64_t seed = 21;
constexpr Format formats[] = {Format::binary64, Format::binary32};

std::vector<Trial> trials_of(const Family& family, Format format, std::uint64_t n) {
  std::vector<Trial> trials;
  for (std::uint64_t k = 0; k < n; ++k) trials.push_back(family.make(format, seed, k));
  return trials;
}

const Ray* ray_of(const Trial& trial) { return std::get_if<Ray>(&trial.query.probe); }

Answer answer_to(const Trial& trial) { return find_method("sf-epick")->ask(trial.query); }

std::vector<double> numbers_of(std::span<Point3* const> vectors) {
  std::vector<double> numbers;
  for (const Point3* v : vectors) {
    for (int axis = 0; axis < 3; ++axis) numbers.push_back((*v)[axis]);
  }
  return numbers;
}

/// Chance repeats remain where a class leaves few numbers to draw: all five points in one, say.
TEST(FamilyDraws, NoFamilyRepeatsItselfOrSharesADrawAmongCases) {
  constexpr std::size_t n = 4'800;
  for (const Stream& s : streams_of(Operands::triangles)) {
    std::set<std::vector<double>> cases, probes, triangles;
    for (Trial& trial : trials_of(*s.family, s.format, n)) {
      const PairVectors q = vectors_of(trial.query);
      const std::span<Point3* const> all = q.v;
      cases.insert(numbers_of(all));
      triangles.insert(numbers_of(all.first(3)));
      probes.insert(numbers_of(all.last(2)));
    }
    EXPECT_GE(cases.size(), n * 98 / 100) << name_of(s);
    EXPECT_GE(probes.size(), n * 80 / 100) << name_of(s);
    EXPECT_GE(triangles.size(), n * 80 / 100) << name_of(s);
  }
}

/// Both kinds of probe, at every level, and both answers of each.
TEST(FamilyDraws, EveryFamilyAsksSegmentsAndRaysAtEveryLevel) {
  for (const Stream& s : streams_of(Operands::triangles)) {
    const std::size_t levels = s.family->levels(s.format).size();
    std::vector<int> asked[2] = {std::vector<int>(levels), std::vector<int>(levels)};
    int hits[2] = {}, all[2] = {};
    for (const Trial& trial : trials_of(*s.family, s.format, 6'000)) {
      const bool ray = ray_of(trial) != nullptr;
      ++asked[ray][trial.level];
      ++all[ray];
      hits[ray] += answer_to(trial).hit;
    }
    for (const int ray : {0, 1}) {
      if (ray == 0 && s.family->name == "bounds") continue;  // segments have none
      EXPECT_GT(std::ranges::min(asked[ray]), 50) << name_of(s) << (ray ? " rays" : " segments");
      EXPECT_GT(hits[ray], 100) << name_of(s) << (ray ? " rays" : " segments");
      EXPECT_GT(all[ray] - hits[ray], 100) << name_of(s) << (ray ? " rays" : " segments");
    }
  }
}

/// The binary exponent of the largest coordinate.
int exponent_of(const Point3& p) { return std::ilogb(std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)})); }

TEST(FamilyReach, DirectionsHaveEverySizeAndNone) {
  for (const Format format : formats) {
    const int step = format == Format::binary32 ? 8 : 64;
    std::set<int> sizes;
    int nowhere = 0;
    for (const Family& family : families_of(Operands::triangles)) {
      for (const Trial& trial : trials_of(family, format, 3'000)) {
        const Ray* const ray = ray_of(trial);
        if (ray == nullptr) continue;
        if (ray->d.v == Point3(0)) {
          ++nowhere;
        } else {
          sizes.insert((exponent_of(ray->d.v) - least_exponent(format)) / step);
        }
      }
    }
    EXPECT_EQ(sizes.size(), static_cast<std::size_t>((largest_exponent(format) - least_exponent(format)) / step + 1));
    EXPECT_GT(nowhere, 100);
  }
}

/// The difference as it is rounded in this format.
double difference_in(Format format, double x, double y) {
  if (format == Format::binary64) return x - y;
  return static_cast<double>(static_cast<float>(x) - static_cast<float>(y));
}

int overflowing_axes(Trial trial) {
  const PairVectors q = vectors_of(trial.query);
  int axes = 0;
  for (int axis = 0; axis < 3; ++axis) {
    bool overflows = false;
    for (std::size_t i = 0; i < static_cast<std::size_t>(q.points); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        overflows |= std::isinf(difference_in(trial.format, (*q.v[i])[axis], (*q.v[j])[axis]));
      }
    }
    axes += overflows;
  }
  return axes;
}

TEST(FamilyReach, DifferencesOverflowOnOneTwoAndThreeAxes) {
  const Family& family = *find_family("overflow");
  for (const Format format : formats) {
    int as_promised = 0;
    for (const Trial& trial : trials_of(family, format, 3'000)) {
      as_promised += overflowing_axes(trial) == family.levels(format)[trial.level];
    }
    EXPECT_GT(as_promised, 2'800) << "all but those in which points coincide";
  }
}

/// The quotient of the largest and the least number on an axis, in binades; the greatest of the three axes.
int spread_of(Trial trial) {
  int spread = 0;
  const PairVectors q = vectors_of(trial.query);
  for (int axis = 0; axis < 3; ++axis) {
    int lo = 2000, hi = -2000;
    for (std::size_t i = 0; i < static_cast<std::size_t>(q.points); ++i) {
      const double x = (*q.v[i])[axis];
      if (x == 0) continue;
      lo = std::min(lo, std::ilogb(x));
      hi = std::max(hi, std::ilogb(x));
    }
    spread = std::max(spread, hi - lo);
  }
  return spread;
}

TEST(FamilyReach, NumbersOnOneAxisLieFarApart) {
  for (const char* name : {"spread", "tilt"}) {
    int beyond_300 = 0, largest = 0;
    for (const Trial& trial : trials_of(*find_family(name), Format::binary64, 6'000)) {
      beyond_300 += spread_of(trial) > 300;
      largest = std::max(largest, spread_of(trial));
    }
    EXPECT_GT(beyond_300, 1'000) << name;
    EXPECT_GE(largest, 2'040) << name;
  }
}

int significant_bits(double x) {
  int bits = 0, e = 0;
  for (double rest = std::frexp(std::fabs(x), &e); rest != 0; ++bits) rest = 2 * rest - std::floor(2 * rest);
  return bits;
}

TEST(FamilyReach, FullMantissasAtTheEndsAndSubnormalsBesideNormals) {
  for (const Format format : formats) {
    const double least_normal = std::ldexp(1.0, least_exponent(format) + digits_of(format) - 1);
    int beside = 0, small = 0, large = 0;
    for (Trial& trial : trials_of(*find_family("extreme"), format, 4'000)) {
      bool subnormal = false, normal = false;
      for (const double x : numbers_of(vectors_of(trial.query).v)) {
        const bool full = significant_bits(x) > digits_of(format) - 8;
        subnormal |= x != 0 && std::fabs(x) < least_normal;
        normal |= std::fabs(x) >= least_normal && std::fabs(x) < 4 * least_normal;
        small += full && std::fabs(x) < 0x1p40 * least_normal;
        large += full && std::ilogb(x) > largest_exponent(format) - 16;
      }
      beside += subnormal && normal;
    }
    EXPECT_GT(beside, 50);
    EXPECT_GT(small, 100);
    EXPECT_GT(large, 100);
  }
}

TEST(FamilyReach, ProbesAreFarLongerAndShorterThanTheTriangleAndMeetIt) {
  for (const Format format : formats) {
    const int far = format == Format::binary32 ? 90 : 900;
    int longer = 0, shorter = 0;
    for (const Trial& trial : trials_of(*find_family("distance"), format, 4'000)) {
      const auto* s = std::get_if<Segment>(&trial.query.probe);
      if (s == nullptr || !answer_to(trial).hit) continue;
      const Triangle& t = trial.query.triangle();
      const int over_size = exponent_of(s->q - s->p) - exponent_of(t.b - t.a);
      longer += over_size > far;
      shorter += over_size < -far;
    }
    EXPECT_GT(longer, 50);
    EXPECT_GT(shorter, 50);
  }
}

/// The binary exponent of t, from those of the volumes of the source and of the direction.
int exponent_of_t(const Ray& r, const Triangle& t) {
  const double span = static_cast<double>(exponent_of(r.o - t.a)) - exponent_of(r.d.v);
  return static_cast<int>(span);
}

TEST(FamilyReach, RaysStartOnTheTriangleAndHitFarOut) {
  int on_triangle = 0, far_out = 0;
  for (const Family& family : families_of(Operands::triangles)) {
    for (const Trial& trial : trials_of(family, Format::binary64, 3'000)) {
      const Ray* const ray = ray_of(trial);
      if (ray == nullptr) continue;
      const Answer answer = answer_to(trial);
      on_triangle += answer.hit && answer.at == At::source;
      const bool apart = ray->d.v != Point3(0) && ray->o != trial.query.triangle().a;
      far_out += answer.hit && apart && exponent_of_t(*ray, trial.query.triangle()) > 500;
    }
  }
  EXPECT_GT(on_triangle, 300);
  EXPECT_GT(far_out, 300);
}

}  // namespace
}  // namespace tribunal
