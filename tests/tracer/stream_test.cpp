// Rays in a batch: the answers are those of exact arithmetic for each ray alone, whatever the other rays of the batch,
// on every instruction set.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>

#include "tests/tracer/tree_support.h"
#include "tracer/accel/wide/traversal.h"

namespace tribunal {

namespace {

using testing::aimed;
using testing::brute_force;
using testing::Random;
using testing::soup;

class RayBatch : public testing::OnEveryTarget {};

INSTANTIATE_TEST_SUITE_P(Targets, RayBatch, ::testing::ValuesIn(batch_targets()), testing::target_name);

std::vector<std::optional<Nearest>> batch(const TriangleTree& tree, std::span<const Ray> rays) {
  std::vector<std::optional<Nearest>> hits(rays.size(), Nearest{~0U, -1});
  tree.closest(rays, hits);
  return hits;
}

bool are_equal(const std::optional<Nearest>& a, const std::optional<Nearest>& b) {
  return a.has_value() == b.has_value() && (!a || (a->id == b->id && a->t == b->t));
}

/// A ray that is not finite, has no direction, or is out of the range of the boxes.
Ray odd(Random& random, const Ray& ray) {
  const double infinity = std::numeric_limits<double>::infinity(), nan = std::nan("");
  switch (random.below(6)) {
    case 0:
      return {ray.o, {{0, -0.0, 0}}};
    case 1:
      return {{nan, 0, 0}, ray.d};
    case 2:
      return {ray.o, {{0, infinity, 1}}};
    case 3:
      return {ray.o, {{1, 0, nan}}};
    case 4:
      return {{0, -infinity, 0}, ray.d};
    default:
      return {{0x1p1020, 1, 1}, {0x1p-1070 * ray.d.v}};
  }
}

std::vector<Ray> mixed(Random& random, const std::vector<Triangle>& triangles, double scale, std::size_t count) {
  std::vector<Ray> rays;
  while (rays.size() < count) {
    const Ray ray = aimed(random, triangles, scale);
    rays.push_back(random.below(7) == 0 ? odd(random, ray) : ray);
  }
  return rays;
}

/// Through vertices and edges, in planes, odd ones between; triangles twice, without area, slivers; from afar.
TEST_P(RayBatch, HasTheAnswersOfExactArithmetic) {
  const struct {
    double offset, scale;
  } places[] = {{0, 1}, {0x1p40, 1}, {0x1p50, 1}, {0, 0x1p-1072}, {0, 0x1p900}, {0x1p900, 0x1p860}};
  int hits = 0;
  for (const auto& place : places) {
    Random random(31);
    const auto triangles = soup(random, Point3(place.offset, -place.offset, place.offset), place.scale, 80);
    const TriangleTree tree(triangles);
    const std::vector<Ray> rays = mixed(random, triangles, place.scale, 200);
    const auto found = batch(tree, rays);
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const auto expected = brute_force(triangles, rays[i]);
      ASSERT_EQ(expected.has_value(), found[i].has_value()) << place.offset << " " << place.scale << " ray " << i;
      if (!expected) continue;
      ++hits;
      ASSERT_EQ(*expected, found[i]->id) << place.offset << " " << place.scale << " ray " << i;
    }
  }
  EXPECT_GT(hits, 300);
}

/// Batches of every length around the number of walkers: the answer to a ray does not depend on the others.
TEST_P(RayBatch, DoesNotDependOnWhoTravelsBeside) {
  Random random(32);
  std::vector<Triangle> triangles;
  for (int i = 0; i < 1500; ++i) {
    const Point3 a = random.point(4);
    const Point3 b = a + random.point(0.5);
    triangles.push_back({a, b, a + random.point(0.5)});
  }
  const TriangleTree tree(triangles);
  const std::vector<Ray> rays = mixed(random, triangles, 1, 1000);
  std::vector<std::optional<Nearest>> alone;
  for (const Ray& ray : rays) alone.push_back(tree.closest(ray));
  EXPECT_GT(std::count_if(alone.begin(), alone.end(), [](const auto& hit) { return hit.has_value(); }), 300);
  for (const std::size_t count : {0, 1, 7, 8, 9, 63, 64, 65, 255, 256, 257, 1000}) {
    for (std::size_t from = 0; from + count <= rays.size(); from += 333) {
      const auto hits = batch(tree, std::span(rays).subspan(from, count));
      for (std::size_t i = 0; i < count; ++i) {
        ASSERT_TRUE(are_equal(hits[i], alone[from + i])) << count << " rays from " << from << ", ray " << i;
      }
    }
  }
}

/// Triangles one behind the other around the ray: whatever the order of the walk, and however many boxes wait, the
/// first is found. Long overlapping boxes make more wait than a walker holds.
TEST_P(RayBatch, SurvivesManyBoxesThatWait) {
  std::vector<Triangle> triangles;
  for (int i = 0; i < 1500; ++i) {
    const double z = 1 + i % 750, x = i * 0x1p-12;
    triangles.push_back({{-40 + x, -40, z}, {40, -40 + x, z + 60}, {0, 50, -z}});
  }
  const TriangleTree tree(triangles);
  std::vector<Ray> rays;
  Random random(33);
  for (int i = 0; i < 60; ++i) rays.push_back({10.0 * random.point(1), {random.point(1)}});
  for (int i = 0; i < 20; ++i) rays.push_back({{0x1p800, 1, 1}, {Point3(-0x1p800, 0, 0) + random.point(1)}});
  const auto found = batch(tree, rays);
  int hits = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const auto expected = brute_force(triangles, rays[i]);
    ASSERT_EQ(expected.has_value(), found[i].has_value()) << "ray " << i;
    ASSERT_TRUE(!expected || *expected == found[i]->id) << "ray " << i;
    hits += expected.has_value();
  }
  EXPECT_GT(hits, 20);
}

/// Probes made many at once are those made one by one, bit for bit; also of rays far away, or with directions that are
/// long, short, along an axis or none at all.
TEST_P(RayBatch, HasTheProbesOfSingleRays) {
  Random random(34);
  const double sizes[] = {1, 0x1p-40, 0x1p29, 0x1p30, 0x1p31, 0x1p-880, 0x1p890, 0x1p-1000, 0x1p1000};
  std::vector<Ray> rays;
  for (int i = 0; i < 2000; ++i) {
    Ray ray{sizes[random.below(5)] * random.point(1), {sizes[random.below(9)] * random.point(1)}};
    if (i % 3 == 0) ray.d.v[static_cast<int>(random.below(3))] = random.below(2) == 0 ? 0.0 : -0.0;
    if (i % 50 == 0) ray.d.v = {0, -0.0, 0};
    rays.push_back(ray);
  }
  for (const Frame& frame :
       {Frame{Point3(0), 1, 1}, Frame{{3, -7, 0.1}, 0x1p-20, 0.75}, Frame{Point3(1), 0x1p990, 1}}) {
    for (const std::size_t count : {1999, 8, 7, 1}) {
      std::vector<WideProbe> probes(count);
      tree_target().make_probes(std::span(rays).first(count), frame, probes.data());
      for (std::size_t i = 0; i < count; ++i) {
        const WideProbe expected(rays[i], frame);
        ASSERT_EQ(probes[i].scale, expected.scale) << "ray " << i;
        ASSERT_EQ(std::memcmp(&probes[i].axes, &expected.axes, sizeof expected.axes), 0) << "ray " << i;
      }
    }
  }
}

/// A tie among as many copies as fill leaves of many nodes: the lowest id, in every ray of a batch.
TEST_P(RayBatch, GivesTheLowestIdOfEqualTriangles) {
  const std::vector<Triangle> triangles(500, Triangle{{0, 0, 1}, {1, 0, 1}, {0, 1, 1}});
  const TriangleTree tree(triangles);
  const std::vector<Ray> rays(40, Ray{{0.25, 0.25, 0}, {{0, 0, 1}}});
  for (const auto& hit : batch(tree, rays)) EXPECT_TRUE(are_equal(hit, Nearest{0, 1}));
}

TEST_P(RayBatch, ServesSmallTrees) {
  const std::vector<Ray> rays(9, Ray{{0.25, 0.25, 0}, {{0, 0, 2}}});
  for (const auto& hit : batch(TriangleTree({}), rays)) EXPECT_FALSE(hit.has_value());
  const Triangle one[] = {{{0, 0, 1}, {1, 0, 1}, {0, 1, 1}}};
  for (const auto& hit : batch(TriangleTree(one), rays)) EXPECT_TRUE(are_equal(hit, Nearest{0, 0.5}));
}

TEST(RayBatchSizes, MustBeEqual) {
  const Ray rays[2] = {};
  std::optional<Nearest> hits[3];
  EXPECT_THROW(TriangleTree({}).closest(rays, hits), std::invalid_argument);
}

}  // namespace
}  // namespace tribunal
