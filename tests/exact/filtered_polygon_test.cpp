// The filtered polygon test against the covering test on exact numbers, and which stage told.
#include "exact/filtered/filtered_polygon.h"

#include <gtest/gtest.h>

#include <map>

#include "exact/kernels/rational_kernel.h"
#include "exact/polygon/family.h"

namespace tribunal {
namespace {

template <class P>
void compare(const P& probe, const Polygon& polygon, std::map<Stage, int>& stages) {
  const FilteredPolygon filtered(polygon);
  const RationalKernel k;
  PolygonAnswer answer = filtered.meet(probe);
  ++stages[answer.answer.stage];
  if (const std::optional<bool> certain = filtered.filter_hits(probe)) {
    EXPECT_EQ(*certain, answer.answer.hit);
  }
  answer.answer.stage = Stage::none;
  EXPECT_EQ(answer, segura_feito(probe, cover(polygon, k), k));
}

TEST(FilteredPolygon, IsTheCoveringTestOnExactNumbers) {
  std::map<Stage, int> stages;
  for (const PolygonFamily& family : all_polygon_families()) {
    for (const Format format : {Format::binary64, Format::binary32}) {
      for (std::uint64_t k = 0; k < 1'500; ++k) {
        const PolygonTrial trial = family.make(format, 13, k);
        std::visit([&](const auto& probe) { compare(probe, trial.query.polygon, stages); }, trial.query.probe);
      }
    }
  }
  EXPECT_GT(stages[Stage::filter], 1'000);
  EXPECT_GT(stages[Stage::expansion], 1'000);
  EXPECT_GT(stages[Stage::exact], 10);
  EXPECT_EQ(stages[Stage::none], 0);
}

/// In general position the filter alone must tell.
TEST(FilteredPolygon, GeneralPositionIsTheFilters) {
  const PolygonData polygon = PolygonData{}.add(std::vector<Point3>{{0, 0, 1}, {9, 0, 2}, {9, 9, 5}, {0, 9, 4}});
  const FilteredPolygon filtered(polygon);
  EXPECT_EQ(filtered.filter_hits(Segment{{2.125, 3.25, 9}, {2.25, 3.5, -9}}), true);
  EXPECT_EQ(filtered.filter_hits(Ray{{2.125, 3.25, 9}, {{0.125, 0.25, -9}}}), true);
  EXPECT_EQ(filtered.filter_hits(Ray{{2.125, 3.25, 9}, {{0.125, 0.25, 9}}}), false);
  EXPECT_EQ(filtered.filter_hits(Segment{{12.125, 3.25, 9}, {12.25, 3.5, -9}}), false);
  EXPECT_EQ(filtered.filter_hits(Segment{{9, 0, 9}, {9, 0, -9}}), std::nullopt) << "at a vertex";
}

}  // namespace
}  // namespace tribunal
