// The parts of a chart that trace: each cause of a differing pixel, planted and counted, and leaks as the trial counts
// them.
#include "exact/mesh/read_mesh.h"
#include "exact/mesh/triangulate.h"
#include "tests/tracer/support.h"
#include "tracer/chart/leaks.h"
#include "tracer/chart/pictures.h"
#include "tracer/leak/trial.h"

namespace tribunal {
namespace {

using testing::method;

constexpr int width = 16, height = 12;
constexpr std::uint64_t pixels = width * height;

Solid solid(std::vector<Point3> corners) {
  Solid s;
  s.mesh.vertices = std::move(corners);
  s.mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return s;
}

/// A square in the plane z = 0, facing the eye, that fills the picture; no light, so that all rays are primary ones.
Scene wall() {
  Scene scene;
  scene.camera = {
      .eye = {0, 0, 5}, .look_at = {0, 0, 0}, .up = {0, 1, 0}, .view_height = 1, .width = width, .height = height};
  scene.solids = {solid({{-40, -40, 0}, {40, -40, 0}, {40, 40, 0}, {-40, 40, 0}})};
  scene.depth = 1;
  return scene;
}

/// Exact, but blind on the right half of the wall's picture.
Method half_blind() {
  Method planted = method("sf-epeck");
  planted.name = "half-blind";
  planted.on_tree_lanes = false;
  planted.prepare_ray = {};
  planted.prepare_triangle = {};
  planted.ray = [exact = method("sf-epeck").ray](const Ray& r, const Triangle& t) {
    Answer answer = exact(r, t);
    return r.d.v.x > 0 && answer.hit ? Answer{} : answer;
  };
  return planted;
}

PicturePlan plan_of(const Scene& scene, std::vector<Method> methods, unsigned threads = 2) {
  return {.methods = std::move(methods), .scenes = {scene}, .repetitions = 1, .threads = threads};
}

std::uint64_t count(const PictureRow& row, PixelCause cause) { return row.differing[static_cast<std::size_t>(cause)]; }

TEST(Pictures, AMethodThatIsWrongHasWrongPixels) {
  const std::vector<PictureRow> rows = measure_pictures(plan_of(wall(), {half_blind(), method("sf-filtered")}));
  ASSERT_EQ(rows.size(), 4u);  // each in either format
  for (const PictureRow& row : rows) {
    EXPECT_EQ(row.pixels, pixels);
    EXPECT_EQ(row.rays, pixels) << "primary rays alone";
    EXPECT_EQ(row.wrong(), row.method == 0 ? pixels / 2 : 0);
    EXPECT_EQ(count(row, PixelCause::start) + count(row, PixelCause::not_owed), 0u);
    EXPECT_EQ(row.repetitions, 1);
    EXPECT_GT(row.rays_per_second.value, 0);
  }
}

/// The same answers about a wall that looks away, of a method that says that it passes over such faces.
TEST(Pictures, WhatTheContractDoesNotOweIsNotWrong) {
  Scene scene = wall();
  scene.solids[0].mesh.triangles = {{0, 2, 1}, {0, 3, 2}};
  Method culling = half_blind();
  culling.contract.culling = Culling::back_faces;
  for (const PictureRow& row : measure_pictures(plan_of(scene, {culling}))) {
    EXPECT_EQ(count(row, PixelCause::not_owed), pixels / 2);
    EXPECT_EQ(row.wrong() + count(row, PixelCause::start), 0u);
  }
}

/// A mirror on the ground, and behind it a low wall. A step along the normal that is wider than the wall is high starts
/// reflected rays above it.
TEST(Pictures, ARayThatStartsElsewhereIsNotWrong) {
  Scene scene;
  scene.camera = {.eye = {-10, 0, 3},
                  .look_at = {0, 0, 0},
                  .up = {0, 0, 1},
                  .view_height = 0.125,
                  .width = width,
                  .height = height};
  scene.solids = {solid({{-40, -40, 0}, {40, -40, 0}, {40, 40, 0}, {-40, 40, 0}}),
                  solid({{20, -40, 0}, {20, -40, 9}, {20, 40, 9}, {20, 40, 0}})};
  scene.solids[0].material.reflection = 1;
  scene.depth = 2;
  scene.bias = 0.25;  // of 40
  Method customary = method("sf-epeck");
  customary.contract.exact = false;
  for (const PictureRow& row : measure_pictures(plan_of(scene, {customary, method("sf-epeck")}))) {
    EXPECT_EQ(row.rays, 2 * pixels);
    EXPECT_EQ(count(row, PixelCause::start), row.method == 0 ? pixels : 0);
    EXPECT_EQ(row.wrong() + count(row, PixelCause::not_owed), 0u);
  }
}

TEST(Pictures, CountsAreTheSameForAnyNumberOfThreads) {
  const std::vector<Method> methods = {half_blind(), method("mt-float"), method("mt-double")};
  const std::vector<PictureRow> one = measure_pictures(plan_of(wall(), methods, 1));
  const std::vector<PictureRow> three = measure_pictures(plan_of(wall(), methods, 3));
  ASSERT_EQ(one.size(), three.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].method, three[i].method);
    EXPECT_EQ(one[i].format, three[i].format);
    EXPECT_EQ(one[i].pixels, three[i].pixels);
    EXPECT_EQ(one[i].rays, three[i].rays);
    EXPECT_EQ(one[i].differing, three[i].differing);
  }
}

TEST(Leaks, AreThoseOfTheTrial) {
  const std::string file = "data/meshes/cow.off";
  const Mesh mesh = triangulated(read_mesh(file), file);
  LeakChartPlan plan{.methods = {method("haines-double"), method("mt-double"), method("sf-filtered"), half_blind()},
                     .mesh = file,
                     .seed = 3,
                     .rays = 600,
                     .threads = 1};
  const std::vector<leak::Surface> surfaces = surfaces_of(mesh, file);
  const std::vector<LeakRow> one = measure_leaks(plan, surfaces);
  plan.threads = 3;
  const std::vector<LeakRow> three = measure_leaks(plan, surfaces);
  ASSERT_EQ(one.size(), 6u) << "not of the method that takes polygons alone";
  ASSERT_EQ(three.size(), 6u);
  for (std::size_t i = 0; i < one.size(); ++i) {
    const leak::Surface& surface = surfaces[i / 3];
    EXPECT_EQ(one[i].format, surface.format());
    EXPECT_EQ(one[i].method, 1 + i % 3);
    const leak::LeakReport report = leak::run_leak_trial(
        surface, {leak::subject_of(plan.methods[one[i].method], surface)}, {.seed = 3, .rays = 600, .threads = 2});
    const leak::AimTally all = report.subjects[0].tally.all();
    for (const LeakRow* row : {&one[i], &three[i]}) {
      EXPECT_EQ(row->rays, all.rays);
      EXPECT_EQ(row->leaks, all[leak::Outcome::leak]);
    }
    if (one[i].method == 2) {
      EXPECT_EQ(one[i].leaks, 0u);
    }
    if (one[i].method == 3) {
      EXPECT_GT(one[i].leaks, 0u);
    }
  }
}

}  // namespace
}  // namespace tribunal
