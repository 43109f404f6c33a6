// Carathéodory against Segura–Feito and the class table.
#include <gtest/gtest.h>

#include "core/segura_feito.h"
#include "exact/classes/class_table.h"
#include "exact/oracles/caratheodory.h"

namespace tribunal {
namespace {

std::vector<Point3> lattice(int side) {
  std::vector<Point3> points;
  for (int i = 0; i < side * side * side; ++i) points.emplace_back(i / side / side, i / side % side, i % side);
  return points;
}

/// All unordered tuples of {0,1,2}³, by three ways.
TEST(Caratheodory, AgreesWithTheTableAndTheTestOnTheSmallLattice) {
  const std::vector<Point3> v = lattice(3);
  const FormulaKernel<std::int64_t> k;
  std::uint64_t cases = 0, hits = 0;
  for (std::size_t a = 0; a < v.size(); ++a) {
    for (std::size_t b = a; b < v.size(); ++b) {
      for (std::size_t c = b; c < v.size(); ++c) {
        for (std::size_t p = 0; p < v.size(); ++p) {
          for (std::size_t q = p; q < v.size(); ++q) {
            const Segment s{v[p], v[q]};
            const Triangle t{v[a], v[b], v[c]};
            const bool meets = meets_by_caratheodory<std::int64_t>(s, t);
            ASSERT_EQ(meets, segura_feito(s, t, k).hit);
            ASSERT_EQ(meets, class_row(class_of(chirotope(s, t, k))).hit());
            ++cases;
            hits += meets;
          }
        }
      }
    }
  }
  EXPECT_EQ(cases, 1'381'212U);
  EXPECT_EQ(hits, 421'256U);
}

TEST(Caratheodory, AgreesOnRays) {
  const std::vector<Point3> v = lattice(3);
  const FormulaKernel<std::int64_t> k;
  std::uint64_t hits = 0;
  for (std::size_t i = 0; i < v.size() * v.size() * v.size(); ++i) {
    const Triangle t{v[i / 729], v[i / 27 % 27], v[i % 27]};
    for (std::size_t o = i % 2; o < v.size(); o += 4) {
      for (const Point3& d : v) {
        const Ray r{v[o], {d - Point3(1.0)}};
        const bool meets = meets_by_caratheodory<std::int64_t>(r, t);
        ASSERT_EQ(meets, segura_feito(r, t, k).hit);
        hits += meets;
      }
    }
  }
  EXPECT_GT(hits, 100'000U);
}

}  // namespace
}  // namespace tribunal
