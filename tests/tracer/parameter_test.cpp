// The parameter that the tree hands out is within its stated bound of the exact one: alone and in batches, in packets
// and in streams, on every target, in every floating-point environment.
#include <cmath>

#include "exact/filtered/rounded_parameter.h"
#include "tests/exact/exact_parameter.h"
#include "tests/exact/scaled_rays.h"
#include "tests/tracer/tree_support.h"

namespace tribunal {
namespace {

using testing::environments;
using testing::ExactParameter;
using testing::InEnvironment;
using testing::scaled_scene;
using testing::ScaledScene;

/// Whether t keeps what the header states: a relative error below 2⁻²⁰, or correct rounding.
bool keeps_bound(double t, const ExactParameter& exact) {
  if (t == exact.rounded()) return true;
  if (!std::isfinite(t)) return false;
  return abs(mpq_class(mpq_class(t) - exact.value)) < mpq_class(0x1p-20) * exact.value;
}

struct Judged {
  std::uint64_t hits = 0, rounded = 0, broken = 0;

  void operator()(const std::vector<Triangle>& triangles, const std::vector<Ray>& rays,
                  const std::vector<std::optional<Nearest>>& found, std::vector<std::optional<ExactParameter>>& known) {
    known.resize(rays.size());
    for (std::size_t i = 0; i < rays.size(); ++i) {
      if (!found[i]) continue;
      if (!known[i]) known[i].emplace(rays[i], triangles[found[i]->id]);
      ++hits;
      rounded += found[i]->t == known[i]->rounded();
      broken += !keeps_bound(found[i]->t, *known[i]);
    }
  }
};

/// Checks t by all entries of the tree, on one instruction set in one floating-point environment.
void ask(const TriangleTree& tree, const std::vector<Triangle>& triangles, const std::vector<Ray>& rays,
         unsigned environment, std::vector<std::optional<ExactParameter>>& known, Judged& judged) {
  std::vector<std::optional<Nearest>> alone, together(rays.size());
  {
    const InEnvironment foreign(environment);
    for (const Ray& r : rays) alone.push_back(tree.closest(r));
    tree.closest(rays, together);
  }
  judged(triangles, rays, alone, known);
  judged(triangles, rays, together, known);
}

class Parameter : public testing::OnEveryTarget {};

INSTANTIATE_TEST_SUITE_P(Targets, Parameter, ::testing::ValuesIn(batch_targets()), testing::target_name);

/// 100,000 rays and more a target, over the whole range of each format.
TEST_P(Parameter, IsWithinItsBoundAtEveryScale) {
  Judged judged;
  for (const Format format : {Format::binary32, Format::binary64}) {
    for (std::uint64_t k = 0; k < 2'200; ++k) {
      const ScaledScene scene = scaled_scene(format, k);
      const TriangleTree tree(scene.triangles);
      std::vector<std::optional<ExactParameter>> known;
      ask(tree, scene.triangles, scene.rays, environments[k % std::size(environments)], known, judged);
    }
  }
  EXPECT_EQ(judged.broken, 0U) << "of " << judged.hits;
  EXPECT_GT(judged.hits, 50'000U);
}

/// Rays that start next to the surface or run almost along it, similar ones (for packets) and unrelated ones (for
/// streams).
TEST_P(Parameter, IsWithinItsBoundFromNextToTheSurface) {
  Judged judged;
  testing::Random random(41);
  std::vector<Triangle> triangles;
  for (int i = 0; i < 300; ++i) {
    const Point3 a = random.point(4);
    const Point3 b = a + random.point(1);
    const Point3 c = a + random.point(1);
    triangles.push_back({a, b, c});
  }
  const TriangleTree tree(triangles);
  std::vector<Ray> rays;
  while (rays.size() < 6'000) {
    const Triangle& t = triangles[random.below(triangles.size())];
    const double s = 0.5 * random.unit();
    const double away = std::ldexp(random.unit(), -static_cast<int>(random.below(60)));
    const Point3 start = t.a + s * (t.b - t.a) + 0.25 * (t.c - t.a) + away * random.point(1);
    const Point3 across = t.b - t.c;
    const bool grazing = random.below(2) == 0;
    const Point3 d = grazing ? across + away * random.point(1) : random.point(1);
    const std::size_t alike = rays.size() % 1024 < 512 ? 1 : 8;
    for (std::size_t i = 0; i < alike; ++i) rays.push_back({start, {d + (0x1p-40 * static_cast<double>(i)) * across}});
  }
  std::vector<std::optional<ExactParameter>> known;
  for (const unsigned environment : environments) ask(tree, triangles, rays, environment, known, judged);
  EXPECT_EQ(judged.broken, 0U) << "of " << judged.hits;
  EXPECT_GT(judged.hits, 30'000U);
  EXPECT_GT(judged.rounded, judged.hits / 20);
}

/// Ordinary numbers of which t = n/d in double had no right digit.
TEST_P(Parameter, HasRightDigitsWhereDoublesHaveNone) {
  const Triangle plane{{0.1, 0.2, 0.3}, {1.3, 0.1, 0.7}, {0.2, 1.1, 0.6}};
  const TriangleTree tree(std::span(&plane, 1));
  testing::Random random(42);
  int hits = 0, wrong_in_double = 0;
  for (int i = 0; i < 2'000; ++i) {
    const double s = 0.4 * random.unit();
    const double r = 0.4 * random.unit();
    const Ray ray{plane.a + s * (plane.b - plane.a) + r * (plane.c - plane.a), {random.point(1)}};
    const auto found = tree.closest(ray);
    if (!found) continue;
    ++hits;
    const ExactParameter exact(ray, plane);
    const HitParameter<double> naive = hit_parameter<double>(ray, plane);
    wrong_in_double += std::fabs(naive.num / naive.den - exact.rounded()) > 0.5 * exact.rounded();
    EXPECT_EQ(found->t, exact.rounded());
    EXPECT_EQ(found->t, rounded_parameter(ray, plane));
  }
  EXPECT_GT(hits, 500);
  EXPECT_GT(wrong_in_double, 100);
}

}  // namespace
}  // namespace tribunal
