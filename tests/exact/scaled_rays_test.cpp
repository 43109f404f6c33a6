// A million rays a format, over the whole range of scales of direction and geometry, in every entry of the certified
// test, on every target, in every rounding mode, with and without flushing: none may be wrong.
#include "tests/exact/scaled_rays.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "exact/filtered/batch.h"
#include "exact/filtered/filtered.h"
#include "exact/filtered/filtered_polygon.h"

namespace tribunal {

namespace {

using testing::environments;
using testing::InEnvironment;
using testing::scaled_scene;
using testing::ScaledScene;

constexpr std::uint64_t scenes = 43'000, parts = 4;  ///< of 24 rays each; a part is one test, for two cores

/// Points by columns.
struct Columns {
  std::vector<double> x, y, z;

  void add(const Point3& p) {
    x.push_back(p.x);
    y.push_back(p.y);
    z.push_back(p.z);
  }
  PointColumns view() const { return {x, y, z}; }
};

/// The columns for a batch: every ray of a scene with every triangle.
struct Pairs {
  Columns o, d, a, b, c;
  std::vector<TrianglePair> queries;

  explicit Pairs(const ScaledScene& scene) {
    for (const Ray& r : scene.rays) {
      for (const Triangle& t : scene.triangles) {
        o.add(r.o), d.add(r.d.v), a.add(t.a), b.add(t.b), c.add(t.c);
        queries.push_back({r, t});
      }
    }
  }
};

/// Wrong answers by entry.
struct Wrong {
  std::uint64_t hits = 0, intersect = 0, batch = 0, one_against_many = 0, queries = 0, polygon = 0;

  std::uint64_t sum() const { return hits + intersect + batch + one_against_many + queries + polygon; }
};

void ask_singly(const ScaledScene& scene, const Pairs& pairs, Wrong& wrong) {
  for (std::size_t i = 0; i < pairs.queries.size(); ++i) {
    const Ray& r = std::get<Ray>(pairs.queries[i].probe);
    wrong.hits += hits(r, pairs.queries[i].triangle) != (scene.hit[i] != 0);
    wrong.intersect += intersect(r, pairs.queries[i].triangle).hit != (scene.hit[i] != 0);
  }
}

void ask_batches(const ScaledScene& scene, const Pairs& pairs, Wrong& wrong) {
  const std::size_t n = pairs.queries.size(), m = scene.triangles.size();
  std::vector<std::uint8_t> hit(n);
  const TriangleColumns triangles{pairs.a.view(), pairs.b.view(), pairs.c.view()};
  hits(RayColumns{pairs.o.view(), pairs.d.view()}, triangles, hit);
  for (std::size_t i = 0; i < n; ++i) wrong.batch += hit[i] != scene.hit[i];
  hits(scene.rays[0], triangles, hit);  // every triangle, again and again
  for (std::size_t i = 0; i < n; ++i) wrong.one_against_many += hit[i] != scene.hit[i % m];
  std::vector<Answer> answers(n);
  intersect(pairs.queries, answers);
  for (std::size_t i = 0; i < n; ++i) wrong.queries += answers[i].hit != (scene.hit[i] != 0);
}

void ask_polygons(const ScaledScene& scene, Wrong& wrong) {
  constexpr std::size_t one_ring[] = {3};
  for (std::size_t t = 0; t < scene.triangles.size(); ++t) {
    const Triangle& u = scene.triangles[t];
    const Point3 ring[] = {u.a, u.b, u.c};
    const FilteredPolygon polygon{Polygon{ring, one_ring}};
    for (std::size_t r = 0; r < scene.rays.size(); ++r) {
      wrong.polygon += polygon.meet(scene.rays[r]).hit != scene.hits(r, t);
    }
  }
}

/// Each scene in two of the sixteen environments; in all where TRIBUNAL_LONG is set.
bool is_due(std::uint64_t k, std::size_t environment) {
  return k / parts % 8 == environment % 8 || std::getenv("TRIBUNAL_LONG") != nullptr;
}

class ScaledRays : public ::testing::TestWithParam<std::tuple<Format, std::uint64_t>> {
 protected:
  void TearDown() override { force_batch_target({}); }
};

TEST_P(ScaledRays, AreAnsweredRightEverywhere) {
  const auto [format, part] = GetParam();
  Wrong wrong;
  std::uint64_t hit = 0, asked = 0;
  for (std::uint64_t k = part; k < scenes; k += parts) {
    const ScaledScene scene = scaled_scene(format, k);
    const Pairs pairs(scene);
    for (std::size_t e = 0; e < std::size(environments); ++e) {
      if (!is_due(k, e)) continue;
      const InEnvironment foreign(environments[e]);
      ask_singly(scene, pairs, wrong);
      for (const std::string_view target : batch_targets()) {
        force_batch_target(target);
        ask_batches(scene, pairs, wrong);
      }
      if (k / parts % 32 < 4) ask_polygons(scene, wrong);
    }
    for (const std::uint8_t h : scene.hit) hit += h;
    asked += scene.hit.size();
    ASSERT_EQ(wrong.sum(), 0U) << "scene " << k << ": hits " << wrong.hits << ", intersect " << wrong.intersect
                               << ", batch " << wrong.batch << ", one against many " << wrong.one_against_many
                               << ", queries " << wrong.queries << ", polygon " << wrong.polygon;
  }
  EXPECT_GT(hit * 10, asked) << "too few hits to lose";
}

INSTANTIATE_TEST_SUITE_P(Formats, ScaledRays,
                         ::testing::Combine(::testing::Values(Format::binary32, Format::binary64),
                                            ::testing::Range(std::uint64_t{0}, parts)));

}  // namespace
}  // namespace tribunal
