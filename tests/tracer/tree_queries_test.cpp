// Any hit and every hit, alone and in batches, are those of exact arithmetic on every triangle, on every target.
#include <algorithm>
#include <stdexcept>

#include "core/segura_feito.h"
#include "exact/filtered/rounded_parameter.h"
#include "exact/kernels/rational_kernel.h"
#include "tests/exact/exact_parameter.h"
#include "tests/exact/scaled_rays.h"
#include "tests/tracer/nasty_scenes.h"
#include "tests/tracer/tree_support.h"

namespace tribunal {
namespace {

using testing::nasty_scene;
using testing::Random;

std::vector<Triangle> triangles_of(const Scene& scene) {
  std::vector<Triangle> triangles;
  for (const Solid& s : scene.solids) {
    for (std::size_t i = 0; i < s.mesh.triangles.size(); ++i) triangles.push_back(s.mesh.triangle(i));
  }
  return triangles;
}

/// Whether the probe hits the triangle by rational arithmetic, in the tracer's reading.
template <class P>
bool is_hit(const P& probe, const Triangle& t) {
  const Answer a = segura_feito(probe, t, RationalKernel{});
  return a.hit && a.contact != Contact::coplanar;
}

template <class P>
std::vector<std::uint32_t> hit_by(const P& probe, const std::vector<Triangle>& triangles) {
  std::vector<std::uint32_t> ids;
  for (std::uint32_t i = 0; i < triangles.size(); ++i) {
    if (is_hit(probe, triangles[i])) ids.push_back(i);
  }
  return ids;
}

/// The triangles that the ray hits, sorted by exact parameter; a stable sort leaves the ids of equal ones ascending.
std::vector<std::uint32_t> in_order(const Ray& ray, const std::vector<Triangle>& triangles) {
  std::vector<std::uint32_t> ids = hit_by(ray, triangles);
  std::stable_sort(ids.begin(), ids.end(), [&](std::uint32_t a, std::uint32_t b) {
    return RationalKernel{}.compare_hits(ray, triangles[a], triangles[b]) == Sign::negative;
  });
  return ids;
}

std::vector<std::uint32_t> ids_of(const std::vector<Nearest>& hits) {
  std::vector<std::uint32_t> ids;
  for (const Nearest& hit : hits) ids.push_back(hit.id);
  return ids;
}

class TreeQueries : public testing::OnEveryTarget {};

INSTANTIATE_TEST_SUITE_P(Targets, TreeQueries, ::testing::ValuesIn(batch_targets()), testing::target_name);

/// Rays and segments at the weak points of a nasty scene, and what hits each.
struct NastyQuestions {
  explicit NastyQuestions(std::uint64_t seed) : triangles(triangles_of(nasty_scene(seed))) {
    Random random(seed + 700);
    for (int i = 0; i < 120; ++i) {
      const Ray ray = testing::aimed(random, triangles, 1);
      rays.push_back(ray);
      ways.push_back({ray.o, i % 2 == 0 ? ray.o + ray.d.v : ray.o + 0.5 * ray.d.v});
    }
    rays.push_back({{0, 0, std::nan("")}, {{0, 0, 1}}});
    rays.push_back({triangles[0].a, {{0, 0, 0}}});
    ways.push_back({{0, 0, 0}, {0, 0, std::numeric_limits<double>::infinity()}});
    ways.push_back({triangles[0].a, triangles[0].a});
  }

  std::vector<Triangle> triangles;
  std::vector<Ray> rays;
  std::vector<Segment> ways;
};

TEST_P(TreeQueries, AreThoseOfBruteForceOnNastyScenes) {
  std::uint64_t hits = 0, ties = 0, met_ways = 0, missed_ways = 0;
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    const NastyQuestions q(seed);
    const TriangleTree tree(q.triangles);
    std::vector<std::vector<Nearest>> all(q.rays.size());
    std::vector<std::uint8_t> any(q.rays.size(), 7), met(q.ways.size(), 7);
    tree.all(q.rays, all);
    tree.any(q.rays, any);
    tree.any(q.ways, met);
    for (std::size_t i = 0; i < q.rays.size(); ++i) {
      const Ray& ray = q.rays[i];
      const std::vector<std::uint32_t> expected = is_finite(ray) ? in_order(ray, q.triangles) : hit_by(ray, {});
      ASSERT_EQ(ids_of(tree.all(ray)), expected) << "seed " << seed << " ray " << i;
      ASSERT_EQ(ids_of(all[i]), expected);
      ASSERT_EQ(tree.any(ray), !expected.empty());
      ASSERT_EQ(any[i], !expected.empty());
      hits += expected.size();
      for (std::size_t k = 1; k < expected.size(); ++k) {
        ties +=
            RationalKernel{}.compare_hits(ray, q.triangles[expected[k - 1]], q.triangles[expected[k]]) == Sign::zero;
        ASSERT_LE(all[i][k - 1].t, all[i][k].t * (1 + 0x1p-18));
      }
    }
    for (std::size_t i = 0; i < q.ways.size(); ++i) {
      const Segment& way = q.ways[i];
      const bool expected = is_finite(way) && !hit_by(way, q.triangles).empty();
      ASSERT_EQ(tree.any(way), expected) << "seed " << seed << " segment " << i;
      ASSERT_EQ(met[i], expected) << "seed " << seed << " segment " << i;
      (expected ? met_ways : missed_ways) += 1;
    }
  }
  EXPECT_GT(hits, 4'000U);
  EXPECT_GT(ties, 1'000U);
  EXPECT_GT(met_ways, 300U);
  EXPECT_GT(missed_ways, 40U);
}

std::pair<std::vector<Nearest>, bool> ask(const TriangleTree& tree, const Ray& ray, unsigned environment) {
  const testing::InEnvironment foreign(environment);
  return {tree.all(ray), tree.any(ray)};
}

/// Over all scales, in all floating-point environments, where integers know what is hit.
TEST_P(TreeQueries, AreExactAtEveryScale) {
  std::uint64_t hits = 0;
  for (const Format format : {Format::binary32, Format::binary64}) {
    for (std::uint64_t k = 0; k < 1'000; ++k) {
      const testing::ScaledScene scene = testing::scaled_scene(format, k);
      const TriangleTree tree(scene.triangles);
      for (std::size_t r = 0; r < scene.rays.size(); ++r) {
        const auto [all, any] = ask(tree, scene.rays[r], testing::environments[k % std::size(testing::environments)]);
        ASSERT_EQ(any, !all.empty());
        ASSERT_EQ(any, scene.closest[r].has_value()) << "scene " << k << " ray " << r;
        ASSERT_TRUE(all.empty() || all[0].id == *scene.closest[r]) << "scene " << k << " ray " << r;
        std::size_t expected = 0;
        for (std::size_t t = 0; t < scene.triangles.size(); ++t) {
          expected += scene.hits(r, t) && !testing::ExactParameter(scene.rays[r], scene.triangles[t]).parallel;
        }
        ASSERT_EQ(all.size(), expected) << "scene " << k << " ray " << r;
        hits += all.size();
      }
    }
  }
  EXPECT_GT(hits, 15'000U);
}

TEST(TreeQueries, ListsOfDifferentLengthsAreRefused) {
  const TriangleTree tree({});
  const Ray ray{{0, 0, 0}, {{1, 0, 0}}};
  const Segment way{{0, 0, 0}, {1, 0, 0}};
  std::vector<std::uint8_t> none;
  EXPECT_THROW(tree.any(std::span(&ray, 1), none), std::invalid_argument);
  EXPECT_THROW(tree.any(std::span(&way, 1), none), std::invalid_argument);
  EXPECT_FALSE(tree.any(ray));
  EXPECT_FALSE(tree.any(way));
  EXPECT_TRUE(tree.all(ray).empty());
}

}  // namespace
}  // namespace tribunal
