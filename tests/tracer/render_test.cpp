// Whitted's rays where the answer is known, and pictures that must not depend on how they were made.
#include "tracer/render/render.h"

#include <sys/resource.h>

#include <cmath>
#include <future>
#include <glm/geometric.hpp>
#include <thread>

#include "tests/tracer/support.h"
#include "tracer/render/compare.h"
#include "tracer/scene/read_scene.h"
#include "tracer/shading/camera_rays.h"

namespace tribunal {
namespace {

using testing::method;

/// A square of side 2·half in the plane z, facing +z.
Solid square(double z, double half, const Colour& glow) {
  Solid s;
  s.mesh.vertices = {{-half, -half, z}, {half, -half, z}, {half, half, z}, {-half, half, z}};
  s.mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  s.material = {.colour = glow, .ambient = 1, .diffuse = 0, .specular = 0};
  return s;
}

Colour traced(const Scene& scene, const Ray& ray, int depth, RayTally* counts = nullptr) {
  const World world = make_world(scene, Format::binary64, Accel::bvh);
  RayTally tally;
  const Colour c = WhittedTracer(world, method("sf-epeck"), tally).trace(ray, depth).colour;
  if (counts) *counts = tally;
  return c;
}

TEST(Whitted, MirrorShowsWhatIsBehindTheViewer) {
  Scene scene;
  scene.background = {0.1, 0.1, 0.1};
  scene.solids = {square(0, 4, {0, 0, 0}), square(10, 40, {0, 0.5, 0})};
  scene.solids[0].material.reflection = 0.5;
  const Ray ray{{0.1, 0.2, 5}, {{0, 0, -1}}};
  EXPECT_EQ(traced(scene, ray, 2).g, 0.25);
  EXPECT_EQ(traced(scene, ray, 1).g, 0.0) << "depth 1 casts no reflected ray";
}

TEST(Whitted, FacingMirrorsStopAtTheDepth) {
  Scene scene;
  scene.solids = {square(0, 4, {0, 0, 0}), square(10, 4, {0, 0, 0})};
  for (Solid& s : scene.solids) s.material.reflection = 1;
  for (const int depth : {1, 2, 5, 16}) {
    RayTally tally;
    traced(scene, {{0.1, 0.2, 5}, {{0, 0, -1}}}, depth, &tally);
    EXPECT_EQ(tally.rays[static_cast<int>(RayKind::reflection)], static_cast<std::uint64_t>(depth - 1));
  }
}

TEST(Whitted, AnOccluderThrowsAShadow) {
  Scene scene;
  scene.solids = {square(0, 4, {1, 1, 1})};
  scene.solids[0].material = {.colour = {1, 1, 1}, .ambient = 0, .diffuse = 1, .specular = 0};
  scene.lights = {{{0.1, 0.2, 10}, {1, 1, 1}}};
  const Ray ray{{3, 0.2, 5}, {{-2.9, 0, -5}}};
  EXPECT_NEAR(traced(scene, ray, 1).g, 1, 1e-9);
  scene.solids.push_back(square(8, 1, {0, 0, 0}));
  EXPECT_EQ(traced(scene, ray, 1).g, 0);
  scene.solids.back() = square(11, 1, {0, 0, 0});
  EXPECT_NEAR(traced(scene, ray, 1).g, 1, 1e-9) << "what is behind the light throws no shadow";
  scene.solids.back() = square(10, 1, {0, 0, 0});
  EXPECT_NEAR(traced(scene, ray, 1).g, 1, 1e-9) << "a surface through the light does not block it";
}

TEST(Refract, ObeysSnellAndReflectsTotally) {
  const Point3 normal(0, 0, 1);
  const double angle = 0.5, index = 1.5;
  const Point3 view(std::sin(angle), 0, std::cos(angle));
  const auto down = refract(view, normal, 1 / index);
  ASSERT_TRUE(down);
  EXPECT_NEAR(-down->x, std::sin(angle) / index, 1e-15);
  EXPECT_NEAR(glm::length(*down), 1, 1e-15);
  const double critical = std::asin(1 / index);
  const auto at = [](double a) { return Point3(std::sin(a), 0, std::cos(a)); };
  EXPECT_TRUE(refract(at(critical - 1e-9), normal, index));
  EXPECT_FALSE(refract(at(critical + 1e-9), normal, index));
}

/// From inside glass at 45°, beyond the critical angle 41.8°, all light is reflected.
TEST(Whitted, TotalInternalReflectionKeepsTheShare) {
  Scene scene;
  scene.background = {1, 0, 0};
  scene.solids = {square(0, 100, {0, 0, 0}), square(-5, 100, {0, 0, 1})};
  scene.solids[0].material.transparency = 1;
  scene.solids[0].material.refractive_index = 1.5;
  RayTally tally;
  const Colour c = traced(scene, {{0.1, 0.2, -1}, {{1, 0, 1}}}, 3, &tally);
  EXPECT_EQ(c.b, 1) << "sees the glowing square below, reflected";
  EXPECT_EQ(c.r, 0);
  EXPECT_EQ(tally.rays[static_cast<int>(RayKind::refraction)], 0u);
  EXPECT_EQ(traced(scene, {{0.1, 0.2, -1}, {{0.5, 0, 1}}}, 3).r, 1) << "below the critical angle it leaves";
}

TEST(Whitted, FacesSeenEdgeOnOrWithoutAreaAreInvisible) {
  Scene scene;
  scene.background = {1, 0, 0};
  scene.solids = {square(0, 4, {0, 1, 0})};
  EXPECT_EQ(traced(scene, {{-9, 0, 0}, {{1, 0, 0}}}, 1).r, 1) << "edge-on";
  scene.solids[0].mesh.vertices = {{-4, 0, 0}, {0, 0, 0}, {4, 0, 0}, {2, 0, 0}};
  EXPECT_EQ(traced(scene, {{1, 0, 5}, {{0, 0, -1}}}, 1).r, 1) << "without area";
}

Scene small_scene() {
  Scene scene = read_scene("data/scenes/mirror-and-prism.json");
  scene.camera.width = 40;
  scene.camera.height = 30;
  return scene;
}

Rendering rendered(const Scene& scene, const char* name, Accel accel, unsigned threads) {
  return render(make_world(scene, Format::binary64, accel), method(name), {scene.depth, threads});
}

TEST(Render, SameBytesForAnyNumberOfThreads) {
  const Scene scene = small_scene();
  for (const char* name : {"sf-double", "sf-filtered"}) {
    const Rendering one = rendered(scene, name, Accel::bvh, 1);
    std::uint64_t tests = 0;
    for (const Cost& c : one.costs) tests += c.tests;
    EXPECT_EQ(tests, one.tally.tests() + one.tally.start_tests) << "each test is some pixel's";
    for (const unsigned threads : {2u, 7u}) {
      const Rendering many = rendered(scene, name, Accel::bvh, threads);
      EXPECT_EQ(to_png(one.image), to_png(many.image));
      EXPECT_EQ(one.decisions, many.decisions);
      EXPECT_TRUE(
          std::equal(one.costs.begin(), one.costs.end(), many.costs.begin(), many.costs.end(),
                     [](const Cost& a, const Cost& b) { return a.tests == b.tests && a.deepest == b.deepest; }));
      EXPECT_EQ(one.tally.box_tests, many.tally.box_tests);
      EXPECT_EQ(one.tally.triangle_tests, many.tally.triangle_tests);
      EXPECT_EQ(one.tally.rays, many.tally.rays);
    }
  }
}

/// Glass within glass sends on two rays at each hit; memory must not follow their number.
TEST(Render, DepthCostsNoMemory) {
  Scene scene = small_scene();
  scene.camera.width = scene.camera.height = 16;
  for (double half = 1; half <= 6; ++half) {
    for (const double z : {-half, half}) {
      Solid s = square(z, 8, {0, 0, 0});
      s.material.reflection = s.material.transparency = 0.5;
      s.material.refractive_index = 1;
      scene.solids.push_back(s);
    }
  }
  scene.depth = 12;
  struct rusage before {
  }, after{};
  ::getrusage(RUSAGE_SELF, &before);
  const Rendering r = render(make_world(scene, Format::binary64, Accel::bvh), method("sf-filtered"), {12, 1});
  ::getrusage(RUSAGE_SELF, &after);
  EXPECT_GT(r.tally.all_rays(), 100'000u);
  EXPECT_LT(after.ru_maxrss - before.ru_maxrss, 64 * 1024) << "KB";
}

/// Planted: equal t decided by the thread that asks. Two coincident squares of different colours; the sound method
/// gives one picture on every thread, the planted one does not, so that pictures of several threads would differ.
TEST(Render, SeesTiesThatDependOnTheThread) {
  Scene scene = small_scene();
  scene.camera = {
      .eye = {0.1, 0.2, 5}, .look_at = {0, 0, 0}, .up = {0, 1, 0}, .view_height = 2, .width = 8, .height = 8};
  scene.solids = {square(0, 4, {1, 0, 0}), square(0, 4, {0, 1, 0})};
  const Method sound = method("sf-epick");
  Method planted = sound;
  planted.compare_hits = [sound, first = std::this_thread::get_id()](const Ray& r, const Triangle& s,
                                                                     const Triangle& t) {
    const Sign order = sound.compare_hits(r, s, t);
    return order == Sign::zero && std::this_thread::get_id() != first ? Sign::negative : order;
  };
  const auto here = [&](const Method& m) {
    return render(make_world(scene, Format::binary64, Accel::bvh), m, {1, 1}).image;
  };
  const auto elsewhere = [&](const Method& m) { return std::async(std::launch::async, here, m).get(); };
  EXPECT_TRUE(here(sound) == elsewhere(sound));
  EXPECT_FALSE(here(planted) == elsewhere(planted));
}

TEST(Render, SameBytesForEveryAccelerationAndEveryExactMethod) {
  const Scene scene = small_scene();
  const Rendering expected = rendered(scene, "sf-rational", Accel::bvh, 2);
  for (const Accel accel : {Accel::none, Accel::boxes, Accel::bvh}) {
    for (const char* name : {"sf-epick", "sf-epeck", "sf-filtered"}) {
      const Rendering other = rendered(scene, name, accel, 2);
      EXPECT_EQ(expected.decisions, other.decisions) << name << " " << name_of(accel);
      EXPECT_TRUE(expected.image == other.image);
    }
  }
}

/// With scene, camera and lights times 2^k, every construction scales and every decision stays, so the picture is the
/// same.
TEST(Render, PowersOfTwoChangeNothing) {
  const Scene scene = small_scene();
  const Rendering expected = rendered(scene, "sf-double", Accel::bvh, 2);
  for (const int exponent : {-40, 7, 60}) {
    const double k = std::ldexp(1.0, exponent);
    Scene scaled = scene;
    scaled.camera.eye *= k;
    scaled.camera.look_at *= k;
    for (Light& light : scaled.lights) light.position *= k;
    for (Solid& s : scaled.solids) {
      for (Point3& v : s.mesh.vertices) v *= k;
    }
    EXPECT_TRUE(expected.image == rendered(scaled, "sf-double", Accel::bvh, 2).image) << "2^" << exponent;
  }
}

TEST(World, RoundsToBinary32OrRefuses) {
  EXPECT_EQ(in_format({0.1, 0.2, 0.3}, Format::binary32), Point3(0.1f, 0.2f, 0.3f));
  EXPECT_EQ(in_format({0.1, 0.2, 0.3}, Format::binary64), Point3(0.1, 0.2, 0.3));
  Scene scene;
  scene.file = "big.json";
  scene.solids = {square(1e300, 1, {})};
  EXPECT_NE(testing::refusal_of([&] { make_world(scene, Format::binary32, Accel::bvh); }).find("binary32"),
            std::string::npos);
}

/// Every exported case is one on which the two methods really differ, in the format that both were given.
TEST(Compare, CasesShowTheDifference) {
  const Scene scene = read_scene("data/scenes/cube-grid.json");
  const World world = make_world(scene, Format::binary32, Accel::bvh, Faces::triangulated);
  const Method &naive = method("mt-float"), &exact = method("sf-rational");
  const Rendering a = render(world, naive, {1, 2}), b = render(world, exact, {1, 2});
  const std::vector<DifferingPixel> pixels = differing_pixels(a, b);
  ASSERT_GT(pixels.size(), 100u) << "corners and edges under pixel rays must show";
  int cases = 0;
  for (std::size_t i = 0; i < 60; ++i) {
    const auto parting = parting_at(world, naive, exact, pixels[i], 1);
    ASSERT_TRUE(parting);
    if (!parting->face) continue;
    const Case c = to_case(world, naive, exact, pixels[i], *parting);
    EXPECT_NE(naive.ask(c.query).hit, exact.ask(c.query).hit) << c.id;
    EXPECT_EQ(to_case(from_case(c), Where{"test"}).id, c.id) << "the reader accepts it, binary32 coordinates and all";
    ++cases;
  }
  EXPECT_GT(cases, 20);
}

TEST(Compare, AMethodDoesNotDifferFromItself) {
  const Rendering a = rendered(small_scene(), "sf-double", Accel::bvh, 2);
  EXPECT_TRUE(differing_pixels(a, a).empty());
}

/// The cubes are closed and their faces point outward: whatever a ray meets first, it enters there, or grazes an edge
/// or a corner. Meeting the inside of a face from behind means that the face before it was lost.
int cracks(const World& world, const Method& m) {
  const Camera& c = world.scene->camera;
  const CameraRays camera(c);
  RayTally tally;
  Visibility eye(world, m, tally);
  int seen = 0;
  for (int i = 0; i < c.width * c.height; ++i) {
    const Ray ray = camera.through(i % c.width, i / c.width);
    const auto id = eye.first_hit(ray);
    if (!id) continue;
    const Triangle& t = world.triangles[*id];
    const bool from_behind = glm::dot(glm::cross(t.b - t.a, t.c - t.a), ray.d.v) > 0;
    seen += from_behind && method("sf-rational").ray(ray, t).contact == Contact::interior;
  }
  return seen;
}

TEST(Render, ExactMethodsLeaveNoCracks) {
  const Scene scene = read_scene("data/scenes/cube-grid.json");
  const World world = make_world(scene, Format::binary32, Accel::bvh, Faces::triangulated);
  EXPECT_EQ(cracks(world, method("sf-epeck")), 0);
  EXPECT_GT(cracks(world, method("mt-float")), 0) << "the scene has no teeth";
}

}  // namespace
}  // namespace tribunal
