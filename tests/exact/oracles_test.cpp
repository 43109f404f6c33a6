// Carathéodory against Segura–Feito and the class table, and the relations that need no oracle.
#include <gtest/gtest.h>

#include "core/segura_feito.h"
#include "exact/classes/class_table.h"
#include "exact/kernels/rational_kernel.h"
#include "exact/methods.h"
#include "exact/oracles/caratheodory.h"
#include "exact/relations/relation.h"

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

FuzzPlan plan_for(std::vector<Method> methods, std::uint64_t cases) {
  FuzzPlan plan;
  plan.methods = std::move(methods);
  plan.streams = all_streams();
  plan.cases = cases;
  return plan;
}

TEST(Relations, HoldForExactMethodsOnEveryFamily) {
  const FuzzPlan plan =
      plan_for({*find_method("sf-rational"), *find_method("sf-epick"), *find_method("cgal-epeck")}, 7'800);
  for (const RelationCount& c : check_relations(plan)) {
    const std::string where = plan.methods[c.method].name + " " + std::string(all_relations()[c.relation].name);
    EXPECT_EQ(c.broken, 0U) << where;
    if (plan.methods[c.method].name != "cgal-epeck") {
      EXPECT_GT(c.asked, 100U) << where << ": the relation has no cases";
    }
  }
}

TEST(Relations, AreBrokenByNaiveArithmetic) {
  std::uint64_t broken = 0;
  for (const RelationCount& c : check_relations(plan_for({*find_method("sf-double")}, 7'800))) {
    broken += c.broken;
    EXPECT_EQ(c.witness.has_value(), c.broken > 0);
  }
  EXPECT_GT(broken, 100U);
}

/// A method that treats the third vertex differently is caught by the vertex order alone.
TEST(Relations, CatchAnAsymmetricMethod) {
  Method bad = *find_method("sf-rational");
  bad.segment = [](const Segment& s, const Triangle& t) {
    return s.q == t.c ? miss() : reference_method().segment(s, t);
  };
  const FuzzPlan plan = plan_for({bad}, 7'800);
  const auto counts = check_relations(plan);
  EXPECT_EQ(all_relations()[0].name, "vertex-order");
  EXPECT_GT(counts[0].broken, 0U);
}

TEST(Relations, ThreadsDoNotShow) {
  FuzzPlan plan = plan_for({*find_method("sf-float")}, 3'000);
  const auto one = check_relations(plan);
  plan.threads = 5;
  const auto five = check_relations(plan);
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].asked, five[i].asked);
    EXPECT_EQ(one[i].broken, five[i].broken);
  }
}

}  // namespace
}  // namespace tribunal
