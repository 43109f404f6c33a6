// The closest hit of a million rays a format, over the whole range of scales of direction and geometry, alone and in
// batches, on every target, in every rounding mode, with and without flushing: none may be wrong.
#include "tests/exact/scaled_rays.h"

#include <cstdlib>

#include "tests/tracer/tree_support.h"

namespace tribunal {

namespace {

using testing::environments;
using testing::InEnvironment;
using testing::scaled_scene;
using testing::ScaledScene;

constexpr std::uint64_t scenes = 43'000, parts = 4;  ///< of 24 rays each; a part is one test, for two cores

std::uint64_t wrong(const ScaledScene& scene, const std::vector<std::optional<Nearest>>& found) {
  std::uint64_t count = 0;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const auto& expected = scene.closest[i];
    count += found[i].has_value() != expected.has_value() || (expected && found[i]->id != *expected);
  }
  return count;
}

std::vector<std::optional<Nearest>> one_by_one(const TriangleTree& tree, const ScaledScene& scene) {
  std::vector<std::optional<Nearest>> found;
  for (const Ray& ray : scene.rays) found.push_back(tree.closest(ray));
  return found;
}

std::vector<std::optional<Nearest>> together(const TriangleTree& tree, const ScaledScene& scene) {
  std::vector<std::optional<Nearest>> found(scene.rays.size());
  tree.closest(scene.rays, found);
  return found;
}

class ScaledTree : public ::testing::TestWithParam<std::tuple<Format, std::uint64_t>> {
 protected:
  void TearDown() override { force_batch_target({}); }
};

TEST_P(ScaledTree, FindsTheClosestHitEverywhere) {
  const auto [format, part] = GetParam();
  std::uint64_t hit = 0, rays = 0;
  for (std::uint64_t k = part; k < scenes; k += parts) {
    const ScaledScene scene = scaled_scene(format, k);
    for (std::size_t e = 0; e < std::size(environments); ++e) {
      // Each scene in two of the sixteen environments; in all where TRIBUNAL_LONG is set.
      if (k / parts % 8 != e % 8 && std::getenv("TRIBUNAL_LONG") == nullptr) continue;
      const InEnvironment foreign(environments[e]);
      const TriangleTree tree(scene.triangles);
      for (const std::string_view target : batch_targets()) {
        force_batch_target(target);
        ASSERT_EQ(wrong(scene, one_by_one(tree, scene)), 0U) << target << " scene " << k << " environment " << e;
        ASSERT_EQ(wrong(scene, together(tree, scene)), 0U) << target << " scene " << k << " environment " << e;
      }
    }
    for (const auto& c : scene.closest) hit += c.has_value();
    rays += scene.rays.size();
  }
  EXPECT_GT(hit * 4, rays) << "too few hits to lose";
}

INSTANTIATE_TEST_SUITE_P(Formats, ScaledTree,
                         ::testing::Combine(::testing::Values(Format::binary32, Format::binary64),
                                            ::testing::Range(std::uint64_t{0}, parts)));

}  // namespace
}  // namespace tribunal
