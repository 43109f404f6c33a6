// The benchmark's polygons: what their integers say is what the exact methods and CGAL's triangulation say.
#include <gtest/gtest.h>

#include "exact/filtered/filtered_polygon.h"
#include "exact/kernels/rational_kernel.h"
#include "tests/bench/polygon/polygon_peers.h"
#include "tests/bench/polygon/polygons.h"

namespace tribunal::bench {
namespace {

using Shape = std::pair<Outline, int>;

std::vector<Shape> all_shapes() {
  std::vector<Shape> shapes;
  for (const Outline outline : all_outlines) {
    for (const int n : {3, 4, 6, 8, 16, 63, 64, 256}) {
      if (n >= least_vertices(outline)) shapes.emplace_back(outline, n);
    }
  }
  return shapes;
}

class Populations : public testing::TestWithParam<Shape> {
 protected:
  static constexpr std::size_t polygons = 8, probes = 2000;

  void SetUp() override {
    const auto [outline, n] = GetParam();
    population_ = draw_population(outline, n, Mix::hits_50, polygons, probes);
  }

  Population population_;
};

TEST_P(Populations, TheFilterAloneTells) {
  std::vector<FilteredPolygon> prepared;
  for (const PolygonData& p : population_.polygons) prepared.emplace_back(p);
  for (const PolygonProbe& p : population_.probes) {
    ASSERT_EQ(prepared[p.polygon].filter_hits(p.segment), p.hit);
    ASSERT_EQ(prepared[p.polygon].hits(Segment{p.segment.q, p.segment.p}), p.hit);
  }
}

TEST_P(Populations, CgalsTriangulationAgrees) {
  std::vector<TriangulatedPolygon> prepared;
  for (const PolygonData& p : population_.polygons) {
    prepared.emplace_back(p);
    EXPECT_EQ(prepared.back().triangles(), p.vertices.size() + 2 * (p.ends.size() - 1) - 2);
  }
  for (std::size_t i = 0; i < 400; ++i) {
    const PolygonProbe& p = population_.probes[i];
    ASSERT_EQ(prepared[p.polygon].meets(p.segment), p.hit);
  }
}

/// Rays as well: those that start at the segment's source and reach beyond its target may hit where it does not.
TEST_P(Populations, TheReferenceAgrees) {
  const RationalKernel k;
  std::vector<Covering> coverings;
  for (const PolygonData& p : population_.polygons) coverings.push_back(cover(Polygon(p), k));
  for (std::size_t i = 0; i < 30; ++i) {
    const PolygonProbe& p = population_.probes[i];
    const Covering& c = coverings[p.polygon];
    EXPECT_TRUE(c.planar);
    ASSERT_EQ(segura_feito(p.segment, c, k).hit, p.hit);
    const Ray ray{p.segment.p, {p.segment.q - p.segment.p}};
    ASSERT_EQ(FilteredPolygon(c.polygon).filter_hits(ray), segura_feito(ray, c, k).hit);
  }
}

INSTANTIATE_TEST_SUITE_P(Shapes, Populations, testing::ValuesIn(all_shapes()));

}  // namespace
}  // namespace tribunal::bench
