// The stress axis of a mesh seen from afar: rays are where they are said to be, and a sweep counts what a leak trial
// does.
#include "tracer/sweep/afar.h"

#include <gtest/gtest.h>

#include <cmath>

#include "exact/mesh/topology.h"
#include "exact/mesh/torus.h"
#include "exact/methods/methods.h"
#include "exact/sweep/record.h"
#include "tests/tracer/support.h"
#include "tracer/leak/trial.h"

namespace tribunal {
namespace {

using leak::AimedRay;
using leak::Surface;
using testing::method;

constexpr Format formats[] = {Format::binary32, Format::binary64};

SweepPlan plan_of(std::vector<Method> methods, std::uint64_t rays, unsigned threads = 2) {
  const MeshAxis axis = afar_axis_of_file("");
  return {.methods = std::move(methods),
          .axes = {axis.axis.get()},
          .seed = 3,
          .cases = rays,
          .threads = threads,
          .of_mesh = axis};
}

TEST(Torus, IsClosedAndFacesOutward) {
  const Surface surface(torus(8, 4), Format::binary64, "torus");
  EXPECT_TRUE(surface.topology().closed());
  EXPECT_EQ(surface.face_count(), 2u * 32 * 16);
  EXPECT_EQ(surface.tree().inside({0, 0, 0}), Side::outside);
  double volume = 0;  // six times
  for (const Triangle& t : surface.triangles()) {
    volume += t.a.x * (t.b.y * t.c.z - t.b.z * t.c.y) - t.a.y * (t.b.x * t.c.z - t.b.z * t.c.x) +
              t.a.z * (t.b.x * t.c.y - t.b.y * t.c.x);
  }
  EXPECT_NEAR(volume / 6, 2 * M_PI * M_PI * 0.16, 0.2) << "of a torus with the radii 1 and 0.4, but for its corners";
}

TEST(Torus, HasFullMantissas) {
  int full = 0, all = 0;
  for (const Point3& p : torus(8, 4).vertices) {
    for (int i = 0; i < 3; ++i, ++all) full += std::remainder(p[i], 0x1p-44) != 0;
  }
  EXPECT_GT(full, all * 9 / 10);
}

TEST(RaysFromAfar, StartThatFarAwayAndMeetTheirMark) {
  for (const Format format : formats) {
    const Surface surface(torus(8, 4), format, "torus");
    const Box& box = surface.bounds();
    const Point3 middle = box.lo / 2.0 + box.hi / 2.0, extent = box.hi - box.lo;
    const double size = std::max({extent.x, extent.y, extent.z});
    for (const int distance : {0, 5, 10}) {
      int hits = 0;
      for (std::uint64_t k = 0; k < 300; ++k) {
        const auto aimed = aimed_ray_from_afar(surface, distance, 1, k);
        ASSERT_TRUE(aimed);
        const Point3 from = aimed->ray.o - middle;
        const double away = std::max({std::abs(from.x), std::abs(from.y), std::abs(from.z)});
        EXPECT_NEAR(std::log2(away / size), distance, 0.01);
        EXPECT_TRUE(is_exact_in(aimed->ray.o, format) && is_exact_in(aimed->ray.d.v, format));
        hits += surface.tree().closest(aimed->ray).has_value();
      }
      EXPECT_GT(hits, 240) << "at vertices and edges of the outline rounding takes some past";
    }
  }
}

TEST(RaysFromAfar, AreAPureFunctionOfSeedDistanceAndNumber) {
  const Surface surface(torus(8, 4), Format::binary64, "torus");
  const auto source = [&](int distance, std::uint64_t seed, std::uint64_t k) {
    return aimed_ray_from_afar(surface, distance, seed, k)->ray.o;
  };
  EXPECT_EQ(source(4, 1, 7), source(4, 1, 7));
  EXPECT_NE(source(4, 1, 7), source(4, 2, 7));
  EXPECT_NE(source(4, 1, 7), source(4, 1, 8));
  EXPECT_NE(source(4, 1, 7) / 2.0, source(3, 1, 7)) << "each distance has draws of its own";
}

TEST(Afar, CountsWhatALeakTrialOfTheSameRaysCounts) {
  constexpr std::uint64_t rays = 600;
  const SweepPlan plan = plan_of({method("mt-double"), method("woop-double")}, rays);
  const Sweep result = sweep(plan);
  const Surface surface(torus(8, 4), Format::binary64, "torus");
  std::vector<leak::Subject> subjects;
  for (const Method& m : plan.methods) subjects.push_back(subject_of(m, surface));
  std::uint64_t leaks = 0;
  for (const int distance : {0, 8, 20}) {
    std::vector<AimedRay> given;
    for (std::uint64_t k = 0; k < rays; ++k) given.push_back(*aimed_ray_from_afar(surface, distance, plan.seed, k));
    const leak::LeakReport report =
        run_leak_trial(surface, subjects, {.given = given, .threads = 2, .every_face = true});
    for (std::size_t m = 0; m < plan.methods.size(); ++m) {
      const leak::AimTally all = report.subjects[m].tally.all();
      const SweepCount& c = result.counts.at({m, 0, Format::binary64, distance, ProbeKind::ray});
      EXPECT_EQ(c.chances(SweptOutcome::leak), report.rays);
      EXPECT_EQ(c.failures(SweptOutcome::leak), all[leak::Outcome::leak]) << distance;
      EXPECT_EQ(c.failures(SweptOutcome::double_hit), all[leak::Outcome::double_hit]) << distance;
      EXPECT_EQ(c.failures(SweptOutcome::false_hit), all[leak::Outcome::false_hit]) << distance;
      EXPECT_EQ(c.failures(SweptOutcome::parity), all[leak::Outcome::parity]) << distance;
      EXPECT_EQ(c.chances(SweptOutcome::parity), all.parity_judged) << distance;
      EXPECT_EQ(c.chances(SweptOutcome::false_miss), 0u);
      leaks += all[leak::Outcome::leak];
    }
  }
  EXPECT_GT(leaks, 0u);
}

/// The reference, which loses every hit of a ray from beyond 2^15.
Method blind_from_afar() {
  const Method& right = reference_method();
  Method m{.name = "planted-blind", .contract = right.contract};
  m.contract.polygons = Polygons::none;
  m.segment = right.segment;
  m.ray = [&right](const Ray& r, const Triangle& t) {
    Answer a = right.ray(r, t);
    const double far = std::max({std::abs(r.o.x), std::abs(r.o.y), std::abs(r.o.z)});
    if (far > 0x1p15) a.hit = false;
    return a;
  };
  return m;
}

TEST(Afar, ATestThatIsBlindFromAKnownDistanceLeaksFromThereOn) {
  const SweepPlan plan = plan_of({blind_from_afar(), method("sf-filtered")}, 90);
  const Sweep result = sweep(plan);
  const std::vector<Threshold> rows = thresholds_of(plan, result);
  std::size_t leaks = 0;
  for (const Threshold& t : rows) {
    EXPECT_EQ(t.method, 0u) << "an exact test is right at every distance";
    if (t.outcome != SweptOutcome::leak) continue;
    ++leaks;
    ASSERT_TRUE(t.before);
    EXPECT_LE(t.before->value, 12);  // the torus is about 2.7 wide: 2^13.6 times that is 2^15
    EXPECT_EQ(t.first.value, 14);
    EXPECT_EQ(t.first.chances, 90u);
  }
  EXPECT_EQ(leaks, 2u) << "in either format";
  for (const WitnessedThreshold& w : with_witnesses(plan, result, rows)) {
    EXPECT_EQ(w.witness.finding["origin"]["value"], 14);
    EXPECT_EQ(w.witness.finding["outcome"], name_of(w.threshold.outcome));
  }
}

TEST(Afar, TheRecordDoesNotDependOnThreads) {
  const auto text_with = [](unsigned threads) {
    const SweepPlan plan = plan_of({method("sf-float"), method("mt-double")}, 300, threads);
    const Sweep result = sweep(plan);
    return to_json_text(plan, result, with_witnesses(plan, result, thresholds_of(plan, result))) + to_csv(plan, result);
  };
  EXPECT_EQ(text_with(1), text_with(3));
}

TEST(Afar, AMeshWithoutAnInsideIsRefused) {
  Mesh open = torus(8, 4);
  open.triangles.pop_back();
  EXPECT_THROW(afar_axis(open, "open.off"), Failure);
  Mesh huge = torus(8, 4);
  for (Point3& v : huge.vertices) v *= 0x1p120;
  EXPECT_THROW(afar_axis(huge, "huge.off"), Failure);
}

}  // namespace
}  // namespace tribunal
