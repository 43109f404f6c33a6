// The filtered polygon test against the covering test on exact numbers, and which stage decided.
#include "exact/filtered/filtered_polygon.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <memory>

#include "exact/cases/families/draw.h"
#include "exact/cases/family_table.h"
#include "exact/certificate/polygon_scope.h"
#include "exact/kernels/rational_kernel.h"

namespace tribunal {

namespace {

template <class P>
void compare(const P& probe, const Polygon& polygon, std::map<Stage, int>& stages) {
  const FilteredPolygon filtered(polygon);
  const RationalKernel k;
  Answer answer = filtered.meet(probe);
  ++stages[answer.stage];
  if (const std::optional<bool> certain = filtered.filter_hits(probe)) {
    EXPECT_EQ(*certain, answer.hit);
  }
  answer.stage = Stage::none;
  EXPECT_EQ(answer, segura_feito(probe, cover(polygon, k), k));
}

TEST(FilteredPolygon, IsTheCoveringTestOnExactNumbers) {
  std::map<Stage, int> stages;
  for (const Family& family : families_of(Operands::polygons)) {
    for (const Format format : {Format::binary64, Format::binary32}) {
      for (std::uint64_t k = 0; k < 1'500; ++k) {
        const Trial trial = family.make(format, 13, k);
        std::visit([&](const auto& probe) { compare(probe, trial.query.polygon(), stages); }, trial.query.probe);
      }
    }
  }
  EXPECT_GT(stages[Stage::filter], 1'000);
  EXPECT_GT(stages[Stage::integers], 1'000);
  EXPECT_GT(stages[Stage::exact], 10);
  EXPECT_EQ(stages[Stage::none], 0);
}

/// The small scope, asked as benchmarks and renderers do.
TEST(FilteredPolygon, AllRingsOfFiveOnTheGrid) {
  const auto filtered = [](const Polygon& polygon) {
    return [p = std::make_shared<const FilteredPolygon>(polygon)](const Segment& s) { return p->hits(s); };
  };
  const PolygonScope scope = exhaust_rings(filtered, {.most_vertices = 5});
  EXPECT_GT(scope.queries, 1'000'000U);
  EXPECT_EQ(scope.different, 0U);
}

/// In general position the filter must answer by itself.
TEST(FilteredPolygon, GeneralPositionIsTheFilters) {
  const PolygonData polygon = PolygonData{}.add(std::vector<Point3>{{0, 0, 1}, {9, 0, 2}, {9, 9, 5}, {0, 9, 4}});
  const FilteredPolygon filtered(polygon);
  EXPECT_EQ(filtered.filter_hits(Segment{{2.125, 3.25, 9}, {2.25, 3.5, -9}}), true);
  EXPECT_EQ(filtered.filter_hits(Ray{{2.125, 3.25, 9}, {{0.125, 0.25, -9}}}), true);
  EXPECT_EQ(filtered.filter_hits(Ray{{2.125, 3.25, 9}, {{0.125, 0.25, 9}}}), false);
  EXPECT_EQ(filtered.filter_hits(Segment{{12.125, 3.25, 9}, {12.25, 3.5, -9}}), false);
  EXPECT_EQ(filtered.filter_hits(Segment{{9, 0, 9}, {9, 0, -9}}), std::nullopt) << "at a vertex";
}

TEST(FilteredPolygon, NonfiniteProbesMeetNothing) {
  const PolygonData polygon = PolygonData{}.add(std::vector<Point3>{{0, 0, 1}, {9, 0, 2}, {9, 9, 5}, {0, 9, 4}});
  const FilteredPolygon filtered(polygon);
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    for (int axis = 0; axis < 3; ++axis) {
      Segment s{{2.125, 3.25, 9}, {2.25, 3.5, -9}};
      s.q[axis] = bad;
      EXPECT_EQ(filtered.filter_hits(s), std::nullopt);
      EXPECT_EQ(filtered.filter_hits(Ray{s.p, {s.q}}), std::nullopt);
      EXPECT_FALSE(filtered.hits(s));
      EXPECT_FALSE(filtered.hits(Ray{s.q, {s.p}}));
      EXPECT_EQ(filtered.meet(s).status, Status::nonfinite);
    }
  }
}

/// Sizes on both sides of what overflows and underflows: the filter decides in between, and is right everywhere.
TEST(FilteredPolygon, ScaleWalksFromUnderflowToOverflow) {
  std::map<Stage, int> stages;
  for (int e = -1070; e <= 1015; e += 5) {
    const auto at = [e](double x, double y, double z) {
      return Point3{std::ldexp(x, e), std::ldexp(y, e), std::ldexp(z, e)};
    };
    const PolygonData polygon =
        PolygonData{}.add(std::vector<Point3>{at(0, 0, 1), at(9, 0, 2), at(9, 9, 5), at(0, 9, 4)});
    for (const double x : {2.125, 9.5}) {
      compare(Segment{at(x, 3.25, 9), at(2.25, 3.5, -9)}, polygon, stages);
      compare(Ray{at(x, 3.25, 9), {at(2.25, 3.5, -9)}}, polygon, stages);
      compare(Segment{at(x, 3.25, 9), {2, 3, -0x1p1020}}, polygon, stages);
    }
  }
  EXPECT_GT(stages[Stage::filter], 300);
  EXPECT_GT(stages[Stage::integers] + stages[Stage::exact], 300);
}

/// The bounds grow with the distance of the eye, not with its cube.
TEST(FilteredPolygon, AFarEyeIsTheFilters) {
  const PolygonData polygon = PolygonData{}.add(std::vector<Point3>{{0, 0, 1}, {9, 0, 2}, {9, 9, 5}, {0, 9, 4}});
  const FilteredPolygon filtered(polygon);
  for (int e = 0; e <= 30; ++e) {
    const Point3 eye{std::ldexp(0.3, e), std::ldexp(-0.7, e), std::ldexp(1, e) + 9};
    for (const double x : {2.125, 8.875, 9.125}) {
      const Point3 aim{x, 3.25, 1 + x / 9 + 3 * 3.25 / 9};  // in the plane
      EXPECT_EQ(filtered.filter_hits(Ray{eye, {aim - eye}}), x < 9) << e;
      EXPECT_EQ(filtered.filter_hits(Segment{eye, aim + (aim - eye)}), x < 9) << e;
    }
  }
}

/// Polygons are prepared and asked in a foreign environment; the expected answers come from the default one.
class ForeignPolygonEnvironment : public testing::TestWithParam<unsigned> {
 protected:
  static constexpr unsigned all_bits = 0xe040;  // rounding mode, flush to zero, denormals are zero
  static void enter(unsigned bits) { __builtin_ia32_ldmxcsr((__builtin_ia32_stmxcsr() & ~all_bits) | bits); }
};

TEST_P(ForeignPolygonEnvironment, ChangesNoAnswer) {
  std::map<Stage, int> stages;
  const RationalKernel k;
  for (const Family& family : families_of(Operands::polygons)) {
    for (std::uint64_t i = 0; i < 300; ++i) {
      const Query query = family.make(Format::binary64, 17, i).query;
      std::visit(
          [&](const auto& probe) {
            const Answer expected = segura_feito(probe, cover(Polygon(query.polygon()), k), k);
            enter(GetParam());
            Answer answer = FilteredPolygon(query.polygon()).meet(probe);
            enter(0);
            ++stages[answer.stage];
            answer.stage = Stage::none;
            ASSERT_EQ(answer, expected) << family.name << i;
          },
          query.probe);
    }
  }
  EXPECT_GT(stages[Stage::filter], 100);
}

INSTANTIATE_TEST_SUITE_P(Registers, ForeignPolygonEnvironment,
                         testing::Values(0x2000U, 0x4000U, 0x6000U, 0x8040U, 0xe040U));

Point3 nearly(const Point3& p, double size, Draw& draw) {
  const auto step = [&] { return size * (std::ldexp(static_cast<double>(draw.next() >> 11), -52) - 1); };
  const double x = step(), y = step(), z = step();
  return p + Point3(x, y, z);
}

/// Short segments that cross the plane, with ends within some roundings of it: the certain answers of filter_between
/// are right.
TEST(FilteredPolygon, TellsOfShortSegmentsThroughThePlane) {
  const RationalKernel exact;
  std::size_t told = 0, crossing = 0;
  for (const Family& family : families_of(Operands::polygons)) {
    for (std::uint64_t k = 0; k < 1'500; ++k) {
      Draw draw(911, 41, k);
      const Trial trial = family.make(Format::binary64, 43, k);
      const std::vector<Point3>& v = trial.query.polygon().vertices;
      const FilteredPolygon filtered(trial.query.polygon());
      const auto any = [&] { return v[draw.below(v.size())]; };
      const auto share = [&] { return std::ldexp(static_cast<double>(draw.next() >> 11), -53); };
      const Point3 a = any(), at = a + share() * (any() - a) + share() * (any() - a);
      const double size = 0x1p-48 * (std::fabs(at.x) + std::fabs(at.y) + std::fabs(at.z));
      const Segment s{nearly(at, size, draw), nearly(at, size, draw)};
      const auto covering = cover(trial.query.polygon(), exact);
      if (!is_finite(s) || !covering.plane) continue;
      const Triangle& t = covering.plane->triangle;
      const Sign from = exact.orient3d(t.a, t.b, t.c, s.p), to = exact.orient3d(t.a, t.b, t.c, s.q);
      if (from == Sign::zero || from != -to) continue;
      ++crossing;
      const auto certain = filtered.filter_between(s);
      told += certain.has_value();
      if (certain) {
        ASSERT_EQ(*certain, segura_feito(s, covering, exact).hit) << family.name << " " << k;
      }
    }
  }
  EXPECT_GT(crossing, 500u);
  EXPECT_GT(told, crossing / 4);
}

}  // namespace
}  // namespace tribunal
