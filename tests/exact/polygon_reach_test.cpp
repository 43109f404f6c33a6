// What the families of polygon cases draw: each case anew, segments and rays in equal share, to the ends of the range.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "exact/cases/families/shapes.h"
#include "exact/cases/family_table.h"
#include "exact/cases/polygon_families/vectors.h"
#include "exact/methods/methods.h"
#include "exact/trial/fuzz.h"

namespace tribunal {
namespace {

constexpr std::uint64_t seed = 21;
constexpr Format formats[] = {Format::binary64, Format::binary32};

/// Visits n cases of the family, keeping one at a time, since some are large.
template <class Visit>
void visit_trials(const Family& family, Format format, std::uint64_t n, const Visit& visit) {
  for (std::uint64_t k = 0; k < n; ++k) visit(family.make(format, seed, k));
}

template <class Visit>
void visit_trials(const char* family, Format format, std::uint64_t n, const Visit& visit) {
  visit_trials(*find_family(family), format, n, visit);
}

const Ray* ray_of(const Trial& trial) { return std::get_if<Ray>(&trial.query.probe); }
const Segment* segment_of(const Trial& trial) { return std::get_if<Segment>(&trial.query.probe); }

Answer answer_to(const Trial& trial) { return find_method("sf-epick")->ask(trial.query); }

/// The vertices, then the source and, for a segment, the target of the probe.
std::vector<Point3> points_of(const Trial& trial) {
  std::vector<Point3> points = trial.query.polygon().vertices;
  if (const Segment* s = segment_of(trial)) points.insert(points.end(), {s->p, s->q});
  if (const Ray* r = ray_of(trial)) points.push_back(r->o);
  return points;
}

std::vector<double> numbers_of(const std::vector<Point3>& points) {
  std::vector<double> numbers;
  for (const Point3& p : points) numbers.insert(numbers.end(), {p.x, p.y, p.z});
  return numbers;
}

/// Chance repeats remain where a family leaves few numbers to draw.
TEST(PolygonDraws, NoFamilyRepeatsItself) {
  constexpr std::uint64_t n = 3'432;
  for (const Stream& s : streams_of(Operands::polygons)) {
    std::set<std::vector<double>> cases;
    visit_trials(*s.family, s.format, n, [&](Trial trial) {
      std::vector<double> numbers = numbers_of(trial.query.polygon().vertices);
      for (const Point3* v : vectors_of(trial.query.probe)) numbers.insert(numbers.end(), {v->x, v->y, v->z});
      cases.insert(numbers);
    });
    EXPECT_GE(cases.size(), n * 98 / 100) << name_of(s);
  }
}

/// Checked within every thousand cases or so, and at every level.
TEST(PolygonDraws, EveryFamilyAsksSegmentsAndRaysInEqualShareAtEveryLevel) {
  constexpr std::uint64_t pairs = shape_count * place_count;
  for (const Stream& s : streams_of(Operands::polygons)) {
    const std::size_t levels = s.family->levels(s.format).size();
    std::vector<int> asked[2] = {std::vector<int>(levels), std::vector<int>(levels)};
    int all[2] = {};
    std::uint64_t k = 0;
    visit_trials(*s.family, s.format, levels * pairs, [&](const Trial& trial) {
      const bool ray = ray_of(trial) != nullptr;
      ++asked[ray][trial.level];
      ++all[ray];
      if (++k % pairs == 0) {
        EXPECT_EQ(all[0], all[1]) << name_of(s) << " after " << k;
      }
    });
    for (const int ray : {0, 1}) EXPECT_GE(std::ranges::min(asked[ray]), 5) << name_of(s) << (ray ? " rays" : "");
  }
}

TEST(PolygonDraws, EveryFamilyHasHitsAndMissesOfEitherProbe) {
  for (const Stream& s : streams_of(Operands::polygons)) {
    int hits[2] = {}, all[2] = {};
    visit_trials(*s.family, s.format, 1'200, [&](const Trial& trial) {
      const bool ray = ray_of(trial) != nullptr;
      ++all[ray];
      hits[ray] += answer_to(trial).hit;
    });
    for (const int ray : {0, 1}) {
      EXPECT_GT(hits[ray], 50) << name_of(s) << (ray ? " rays" : " segments");
      EXPECT_GT(all[ray] - hits[ray], 50) << name_of(s) << (ray ? " rays" : " segments");
    }
  }
}

/// The binary exponent of the largest coordinate.
int exponent_of(const Point3& p) { return std::ilogb(std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)})); }

TEST(PolygonReach, DirectionsHaveEverySizeAndNone) {
  for (const Format format : formats) {
    const int step = format == Format::binary32 ? 8 : 64;
    std::set<int> sizes;
    int nowhere = 0;
    for (const Family& family : families_of(Operands::polygons)) {
      visit_trials(family, format, 1'200, [&](const Trial& trial) {
        const Ray* const ray = ray_of(trial);
        if (ray == nullptr) return;
        const bool is_none = ray->d.v == Point3(0);
        nowhere += is_none;
        if (!is_none) sizes.insert((exponent_of(ray->d.v) - least_exponent(format)) / step);
      });
    }
    EXPECT_EQ(sizes.size(), static_cast<std::size_t>((largest_exponent(format) - least_exponent(format)) / step + 1));
    EXPECT_GT(nowhere, 300);
  }
}

/// The difference as it is rounded in this format.
double difference_in(Format format, double x, double y) {
  if (format == Format::binary64) return x - y;
  return static_cast<double>(static_cast<float>(x) - static_cast<float>(y));
}

int overflowing_axes(const Trial& trial) {
  const std::vector<Point3> points = points_of(trial);
  int axes = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const auto [least, most] = std::ranges::minmax(points, {}, [&](const Point3& p) { return p[axis]; });
    axes += std::isinf(difference_in(trial.format, most[axis], least[axis]));
  }
  return axes;
}

TEST(PolygonReach, DifferencesOverflowOnOneTwoAndThreeAxes) {
  for (const Format format : formats) {
    int as_promised = 0, hits = 0;
    visit_trials("polygon-overflow", format, 3'432, [&](const Trial& trial) {
      as_promised += overflowing_axes(trial) == static_cast<int>(trial.level) + 1;
      hits += answer_to(trial).hit;
    });
    EXPECT_GT(as_promised, 3'300);
    EXPECT_GT(hits, 1'000);
  }
}

/// The quotient of the largest and the least number on an axis, in binades; the greatest of the three axes.
int spread_of(const Trial& trial) {
  int spread = 0;
  const std::vector<Point3> points = points_of(trial);
  for (int axis = 0; axis < 3; ++axis) {
    int lo = 2000, hi = -2000;
    for (const Point3& p : points) {
      if (p[axis] == 0) continue;
      lo = std::min(lo, std::ilogb(p[axis]));
      hi = std::max(hi, std::ilogb(p[axis]));
    }
    spread = std::max(spread, hi - lo);
  }
  return spread;
}

TEST(PolygonReach, NumbersOnOneAxisLieFarApart) {
  int beyond_300 = 0, hits_beyond_300 = 0, largest = 0;
  std::set<int> spreads;
  visit_trials("polygon-spread", Format::binary64, 6'000, [&](const Trial& trial) {
    const int spread = spread_of(trial);
    beyond_300 += spread > 300;
    hits_beyond_300 += spread > 300 && answer_to(trial).hit;
    largest = std::max(largest, spread);
    spreads.insert(spread);
  });
  EXPECT_GT(beyond_300, 2'000);
  EXPECT_GT(hits_beyond_300, 200);
  EXPECT_GE(largest, 2'040);
  EXPECT_GT(spreads.size(), 1'000U) << "no constant is safe between levels";
}

int significant_bits(double x) {
  int bits = 0, e = 0;
  for (double rest = std::frexp(std::fabs(x), &e); rest != 0; ++bits) rest = 2 * rest - std::floor(2 * rest);
  return bits;
}

TEST(PolygonReach, FullMantissasAtTheEndsAndSubnormalsBesideNormals) {
  for (const Format format : formats) {
    const double least_normal = std::ldexp(1.0, least_exponent(format) + digits_of(format) - 1);
    int beside = 0, small = 0, large = 0;
    visit_trials("polygon-extreme", format, 3'432, [&](const Trial& trial) {
      bool subnormal = false, normal = false;
      for (const double x : numbers_of(points_of(trial))) {
        const bool full = significant_bits(x) > digits_of(format) - 8;
        subnormal |= x != 0 && std::fabs(x) < least_normal;
        normal |= std::fabs(x) >= least_normal && std::fabs(x) < 4 * least_normal;
        small += full && std::fabs(x) < 0x1p40 * least_normal;
        large += full && std::ilogb(x) > largest_exponent(format) - 16;
      }
      beside += subnormal && normal;
    });
    EXPECT_GT(beside, 50);
    EXPECT_GT(small, 100);
    EXPECT_GT(large, 100);
  }
}

/// The binary exponent of the polygon's largest extent along an axis.
int exponent_of_size(const PolygonData& polygon) {
  Point3 size(0);
  for (const Point3& v : polygon.vertices) {
    for (int axis = 0; axis < 3; ++axis) {
      size[axis] = std::max(size[axis], std::fabs(v[axis] / 2 - polygon.vertices[0][axis] / 2));
    }
  }
  return exponent_of(size) + 1;
}

TEST(PolygonReach, ProbesAreFarLongerThanThePolygonOrHardlyLeaveItsPlaneAndMeetIt) {
  for (const Format format : formats) {
    const int far = format == Format::binary32 ? 90 : 900;
    int longer = 0, grazing = 0;
    visit_trials("polygon-distance", format, 10'296, [&](const Trial& trial) {
      const Segment* const s = segment_of(trial);
      if (s == nullptr || !answer_to(trial).hit) return;
      const int size = exponent_of_size(trial.query.polygon());
      longer += exponent_of(s->q / 2.0 - s->p / 2.0) - size > far;
      grazing += trial.level == 0 && s->p != s->q;
    });
    EXPECT_GT(longer, 50);
    EXPECT_GT(grazing, 50);
  }
}

TEST(PolygonReach, RaysStartOnThePolygonAndHitFarOut) {
  int on_polygon = 0, far_out = 0;
  for (const Family& family : families_of(Operands::polygons)) {
    visit_trials(family, Format::binary64, 1'144, [&](const Trial& trial) {
      const Ray* const ray = ray_of(trial);
      if (ray == nullptr || ray->d.v == Point3(0)) return;
      const Answer answer = answer_to(trial);
      on_polygon += answer.hit && answer.at == At::source;
      const Point3 span = ray->o / 2.0 - trial.query.polygon().vertices[0] / 2.0;
      far_out += answer.hit && answer.at == At::between && span != Point3(0) &&
                 exponent_of(span) - exponent_of(ray->d.v) > 500;
    });
  }
  EXPECT_GT(on_polygon, 300);
  EXPECT_GT(far_out, 300);
}

TEST(PolygonReach, PointsAreMetAndMissedByBothProbes) {
  int hits[2] = {}, misses[2] = {};
  visit_trials("polygon-point", Format::binary64, 1'144, [&](const Trial& trial) {
    const Segment* const s = segment_of(trial);
    ASSERT_TRUE(s != nullptr ? s->p == s->q : ray_of(trial)->d.v == Point3(0));
    ++(answer_to(trial).hit ? hits : misses)[s == nullptr];
  });
  for (const int ray : {0, 1}) {
    EXPECT_GT(hits[ray], 100);
    EXPECT_GT(misses[ray], 100);
  }
}

TEST(PolygonReach, RingsHaveThousandsOfVerticesAndThereAreHundreds) {
  std::size_t vertices = 0, rings = 0;
  int long_rings = 0;
  visit_trials("polygon-many", Format::binary64, 2'000, [&](const Trial& trial) {
    const Polygon polygon = trial.query.polygon();
    rings = std::max(rings, polygon.rings());
    for (std::size_t r = 0; r < polygon.rings(); ++r) vertices = std::max(vertices, polygon.ring(r).size());
    long_rings += polygon.vertices.size() > 100;
  });
  EXPECT_GT(vertices, 3'000U);
  EXPECT_GT(rings, 500U);
  EXPECT_GT(long_rings, 200);
}

}  // namespace
}  // namespace tribunal
