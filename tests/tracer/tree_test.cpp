// No boxes, object boxes and the tree give the same answers on the nastiest scenes we know.
#include <cmath>

#include "exact/filtered/batch.h"
#include "tests/tracer/nasty_scenes.h"
#include "tracer/scene/read_scene.h"
#include "tracer/shading/visibility.h"

namespace tribunal {

namespace {

using testing::aimed;
using testing::method;
using testing::nasty_scene;
using testing::octahedron;
using testing::Random;
using testing::Worlds;

TEST(BoxedFaces, FirstHitIsThatOfBruteForce) {
  const Method& m = method("sf-epeck");
  RayTally tally;
  int hits = 0;
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    const Scene scene = nasty_scene(seed);
    const Worlds w(scene);
    Visibility brute(w.none, m, tally), boxed(w.boxes, m, tally), tree(w.bvh, m, tally);
    Random random(seed + 100);
    for (int i = 0; i < 400; ++i) {
      const Ray ray = aimed(random, w.none.triangles);
      const auto expected = brute.first_hit(ray);
      hits += expected.has_value();
      ASSERT_EQ(expected, boxed.first_hit(ray)) << "seed " << seed << " ray " << i;
      ASSERT_EQ(expected, tree.first_hit(ray)) << "seed " << seed << " ray " << i;
    }
  }
  EXPECT_GT(hits, 1500);
}

TEST(BoxedFaces, ShadowsAreThoseOfBruteForce) {
  const Method& m = method("sf-epeck");
  RayTally tally;
  int blocked = 0;
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    const Scene scene = nasty_scene(seed);
    const Worlds w(scene);
    Visibility brute(w.none, m, tally), boxed(w.boxes, m, tally), tree(w.bvh, m, tally);
    Random random(seed + 200);
    for (int i = 0; i < 400; ++i) {
      const Ray ray = aimed(random, w.none.triangles);
      const Segment way{ray.o, ray.o + 2.0 * ray.d.v};
      const bool expected = brute.is_blocked(way);
      blocked += expected;
      ASSERT_EQ(expected, boxed.is_blocked(way)) << "seed " << seed << " segment " << i;
      ASSERT_EQ(expected, tree.is_blocked(way)) << "seed " << seed << " segment " << i;
    }
  }
  EXPECT_GT(blocked, 500);
}

/// sf-filtered on the tree's lanes against another exact method that asks every face, on every target.
TEST(BoxedFaces, LanesSeeWhatBruteForceSees) {
  for (const std::string_view target : batch_targets()) {
    force_batch_target(target);
    RayTally tally, uncounted;
    for (std::uint64_t seed = 0; seed < 8; ++seed) {
      const Scene scene = nasty_scene(seed);
      const Worlds w(scene);
      Visibility brute(w.none, method("sf-epeck"), uncounted), lanes(w.bvh, method("sf-filtered"), tally);
      Random random(seed + 300);
      for (int i = 0; i < 150; ++i) {
        const Ray ray = aimed(random, w.none.triangles);
        ASSERT_EQ(brute.first_hit(ray), lanes.first_hit(ray)) << target << " seed " << seed << " ray " << i;
        const Segment way{ray.o, ray.o + 2.0 * ray.d.v};
        ASSERT_EQ(brute.is_blocked(way), lanes.is_blocked(way)) << target << " seed " << seed << " segment " << i;
        const auto face = static_cast<std::uint32_t>(random.below(w.none.triangles.size()));
        ASSERT_EQ(brute.meets_any(way, {face, no_face}), lanes.meets_any(way, {face, no_face}))
            << target << " " << seed << " " << i;
      }
    }
    std::uint64_t staged = 0;
    for (const Stage s : deciding_stages) staged += tally.by_stage[std::size_t(s)];
    EXPECT_EQ(staged, tally.tests()) << "every test has a stage";
    EXPECT_GT(tally.by_stage[static_cast<std::size_t>(Stage::integers)], 1000u);
  }
  force_batch_target({});
}

/// Polygons are leaf primitives too, which the lanes know nothing of.
TEST(BoxedFaces, LanesLeavePolygonsToTheMethod) {
  const Scene scene = read_scene("data/scenes/paper-2a.json");
  const Worlds w(scene);
  ASSERT_GT(w.bvh.polygons.size(), 30u);
  const Method& m = method("sf-filtered");
  RayTally tally;
  Visibility brute(w.none, m, tally), tree(w.bvh, m, tally);
  Random random(17);
  int hits = 0;
  for (int i = 0; i < 2000; ++i) {
    const Ray ray = aimed(random, w.none.triangles);
    const auto expected = brute.first_hit(ray);
    hits += expected.has_value();
    ASSERT_EQ(expected, tree.first_hit(ray));
    const Segment way{ray.o, ray.o + 2.0 * ray.d.v};
    ASSERT_EQ(brute.is_blocked(way), tree.is_blocked(way));
  }
  EXPECT_GT(hits, 500);
  for (std::uint32_t id = 0; id < w.none.triangles.size(); ++id) {
    EXPECT_EQ(w.none.triangles[id].a, w.bvh.triangles[id].a) << "the plane of a polygon is kept";
  }
}

TEST(BoxedFaces, OffersEveryTriangleOnceAtMost) {
  const Scene scene = nasty_scene(1);
  const World w = make_world(scene, Format::binary64, Accel::bvh);
  Random random(7);
  for (int i = 0; i < 100; ++i) {
    const std::vector<std::uint32_t> ids = candidates(w, aimed(random, w.triangles));
    EXPECT_EQ(std::adjacent_find(ids.begin(), ids.end()), ids.end());
  }
}

TEST(BoxedFaces, HandlesManyEqualBoxesAndHugeOnes) {
  Scene scene;
  Solid s = octahedron(Point3(0), 1);
  const double big = 0x1.8p1023;
  s.mesh.vertices.insert(s.mesh.vertices.end(), {{-big, -big, 5}, {big, -big, 5}, {0, big, 5}});
  for (int i = 0; i < 500; ++i) s.mesh.triangles.push_back({6, 7, 8});
  scene.solids = {s};
  const Worlds w(scene);
  RayTally tally;
  const Ray ray{{0, 0.25, 9}, {{0, 0, -1}}};
  EXPECT_EQ(Visibility(w.bvh, method("sf-rational"), tally).first_hit(ray), 8u) << "lowest id of the equal ones";
  EXPECT_EQ(Visibility(w.none, method("sf-rational"), tally).first_hit(ray), 8u);
}

/// A triangle twice, and the primitive order reversed: the same surface is hit at the same place.
TEST(BoxedFaces, PrimitiveOrderDoesNotMove) {
  Scene scene = nasty_scene(4);
  Scene reversed = scene;
  for (Solid& s : reversed.solids) std::reverse(s.mesh.triangles.begin(), s.mesh.triangles.end());
  const World w = make_world(scene, Format::binary64, Accel::bvh);
  const World v = make_world(reversed, Format::binary64, Accel::bvh);
  const Method& m = method("sf-epeck");
  RayTally tally;
  Visibility forward(w, m, tally), backward(v, m, tally);
  Random random(5);
  for (int i = 0; i < 400; ++i) {
    const Ray ray = aimed(random, w.triangles);
    const auto a = forward.first_hit(ray), b = backward.first_hit(ray);
    ASSERT_EQ(a.has_value(), b.has_value());
    if (!a) continue;
    EXPECT_EQ(m.compare_hits(ray, w.triangles[*a], v.triangles[*b]), Sign::zero);
  }
}

}  // namespace
}  // namespace tribunal
