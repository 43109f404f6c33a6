// Closest hits by the tree are those of exact arithmetic, on every instruction set.
#include <cmath>

#include "tests/tracer/tree_support.h"

namespace tribunal {
namespace {

using testing::aimed;
using testing::brute_force;
using testing::Random;
using testing::soup;

class ClosestHit : public testing::OnEveryTarget {};

INSTANTIATE_TEST_SUITE_P(Targets, ClosestHit, ::testing::ValuesIn(batch_targets()), testing::target_name);

struct Place3 {
  double offset, scale;
};

TEST_P(ClosestHit, IsThatOfExactArithmetic) {
  const Place3 places[] = {{0, 1},       {0x1p40, 1},   {0x1p50, 1},       {0, 0x1p-1072}, {0, 0x1p-300},
                           {0, 0x1p900}, {0, 0x1p1015}, {0x1p20, 0x1p-20}, {-3, 1},        {0x1p900, 0x1p860}};
  int hits = 0;
  for (const Place3& place : places) {
    Random random(11);
    const std::vector<Triangle> triangles =
        soup(random, Point3(place.offset, -place.offset, place.offset), place.scale, 60);
    const TriangleTree tree(triangles);
    for (int i = 0; i < 120; ++i) {
      const Ray ray = aimed(random, triangles, place.scale);
      const auto expected = brute_force(triangles, ray);
      const auto found = tree.closest(ray);
      ASSERT_EQ(expected.has_value(), found.has_value()) << place.offset << " " << place.scale << " ray " << i;
      if (!expected) continue;
      ++hits;
      ASSERT_EQ(*expected, found->id) << "offset " << place.offset << " scale " << place.scale << " ray " << i;
      ASSERT_GE(found->t, 0);
    }
  }
  EXPECT_GT(hits, 400);
}

/// Rays whose direction is far longer or shorter than the scene is large.
TEST_P(ClosestHit, TheLengthOfADirectionDoesNotMatter) {
  Random random(12);
  const std::vector<Triangle> triangles = soup(random, Point3(0), 1, 60);
  const TriangleTree tree(triangles);
  for (int i = 0; i < 200; ++i) {
    const Ray ray = aimed(random, triangles, 1);
    const auto expected = tree.closest(ray);
    for (const double factor : {0x1p-900, 0x1p-30, 0x1p30, 0x1p1000}) {
      const auto found = tree.closest({ray.o, {factor * ray.d.v}});
      ASSERT_EQ(expected.has_value(), found.has_value());
      ASSERT_TRUE(!expected || expected->id == found->id);
    }
  }
}

/// t lies within proved bounds of the exact parameter.
TEST_P(ClosestHit, ParametersAreAccurate) {
  Random random(13);
  const std::vector<Triangle> triangles = soup(random, Point3(0), 1, 100);
  const TriangleTree tree(triangles);
  int compared = 0;
  for (int i = 0; i < 500; ++i) {
    const Point3 o = random.point(8);
    const Ray ray{o, {Point3(2) + random.point(2) - o}};
    const auto found = tree.closest(ray);
    if (!found) continue;
    const HitParameter<double> p = hit_parameter<double>(ray, triangles[found->id]);
    EXPECT_NEAR(found->t, p.num / p.den, 1e-9 * std::fabs(found->t));
    ++compared;
  }
  EXPECT_GT(compared, 50);
}

TEST(TriangleTree, OfNothingIsNeverHit) {
  EXPECT_FALSE(TriangleTree({}).closest({{0, 0, 0}, {{1, 0, 0}}}).has_value());
  const Triangle one[] = {{{0, 0, 1}, {1, 0, 1}, {0, 1, 1}}};
  const TriangleTree tree(one);
  EXPECT_EQ(tree.closest({{0.25, 0.25, 0}, {{0, 0, 2}}})->t, 0.5);
  EXPECT_FALSE(tree.closest({{0.25, 0.25, 0}, {{0, 0, 0}}}).has_value()) << "a ray without direction";
  EXPECT_FALSE(tree.closest({{0.25, 0.25, 0}, {{0, 0, std::nan("")}}}).has_value());
}

}  // namespace
}  // namespace tribunal
