// The polygon test on a small scope, exhausted, and bugs planted to see that the scope finds them.
#include <gtest/gtest.h>

#include "core/segura_feito_polygon.h"
#include "exact/certificate/polygon_scope.h"
#include "exact/trial/judge.h"

namespace tribunal {
namespace {

using namespace detail;

using IntegerKernel = FormulaKernel<std::int64_t>;
constexpr IntegerKernel k;
constexpr RingScope few{.most_vertices = 4};

/// Asks the prepared form, and expects that it finds every polygon of the scope planar.
constexpr auto prepared = [](const Polygon& polygon) {
  const Covering c = cover(polygon, k);
  EXPECT_TRUE(c.planar);
  return [c](const Segment& s) { return segura_feito(s, c, k).hit; };
};

constexpr auto on_the_fly = [](const Polygon& polygon) {
  return [polygon](const Segment& s) { return segura_feito(s, polygon, k).hit; };
};

TEST(PolygonSmallScope, AllRingsOnTheGrid) {
  const PolygonScope scope = exhaust_rings(prepared);
  EXPECT_EQ(scope.polygons, 138'468U);
  EXPECT_EQ(scope.queries, 138'468U * (49 + 45));
  EXPECT_EQ(scope.different, 0U);
  EXPECT_EQ(scope.contradictions, 0U);
}

/// What the grid's integers say of contact and boundary is what the oracles say.
TEST(PolygonSmallScope, KnowsContactAndBoundary) {
  small_scope_detail::Scope scope(1);
  std::uint64_t rings = 0, coplanar_on_boundary = 0, coplanar_inside = 0;
  const auto ask = [&](const small_scope_detail::Cells& ring) {
    if (++rings % 211 != 0) return;
    const PolygonData& polygon = scope.place({ring});
    scope.visit_cases({ring}, rings, [&](const Segment& s, Contact due, bool boundary) {
      const Truth truth = exact_truth(Query{s, polygon});
      EXPECT_EQ(truth.contact, due);
      EXPECT_EQ(truth.boundary, boundary);
      if (due == Contact::coplanar) ++(boundary ? coplanar_on_boundary : coplanar_inside);
    });
  };
  for (int n = 3; n <= 5; ++n) small_scope_detail::for_each_ring(n, Start::lowest, ask);
  EXPECT_GT(coplanar_on_boundary, 500U);
  EXPECT_GT(coplanar_inside, 0U);
}

TEST(PolygonSmallScope, AllQuadrilateralsWithTriangularHoles) {
  const PolygonScope scope = exhaust_holes(prepared);
  EXPECT_EQ(scope.polygons, 170'100U);
  EXPECT_EQ(scope.queries, 170'100U * (49 + 45));
  EXPECT_EQ(scope.different, 0U);
  EXPECT_EQ(scope.contradictions, 0U);
}

/// From the centre the covering may turn more than once around its first vertex, and overlap within a third of a step.
TEST(PolygonSmallScope, RingsFromTheCentre) {
  const PolygonScope scope = exhaust_rings(prepared, {.most_vertices = 5, .start = Start::centre, .refinement = 3});
  EXPECT_EQ(scope.polygons, 81U + 729U + 6'561U);
  EXPECT_EQ(scope.queries, scope.polygons * (19 * 19 + 45));
  EXPECT_EQ(scope.different, 0U);
  EXPECT_EQ(scope.contradictions, 0U);
}

TEST(PolygonSmallScope, OnTheFly) { EXPECT_EQ(exhaust_rings(on_the_fly, {.most_vertices = 5}).different, 0U); }

/// The test of the paper's figure 1 with another weight for each triangle that is hit; probes that meet the boundary
/// or lie in the plane get the right answer.
template <class Weight>
auto weighed(const Weight& weight) {
  return [weight](const Polygon& polygon) {
    return [c = cover(polygon, k), weight](const Segment& s) {
      const Answer right = segura_feito(s, c, k);
      if (!c.plane || (right.hit && right.contact != Contact::interior)) return right.hit;
      const PlaneSides sides = sides_of(c.plane->triangle, s, k);
      if (sides.in_plane() || !reaches(sides.source, sides.target, s.q)) return right.hit;
      int sum = 0;
      const auto side = [&](const Point3& a, const Point3& b) { return k.orient3d(s.p, a, b, s.q); };
      visit_passed(c.polygon, side, [&](const Point3&, const Point3&, const Passage& passage) {
        sum += weight(passage);
        return false;
      });
      return is_odd(sum);
    };
  };
}

TEST(PolygonPlantedBugs, TheRightWeightIsRight) {
  const auto subject = weighed([](const Passage& p) { return halves(p.location(), p.direction()); });
  EXPECT_EQ(exhaust_rings(subject, few).different, 0U);
}

TEST(PolygonPlantedBugs, InternalEdgesCountedWhole) {
  const auto subject = weighed([](const Passage& p) { return 2 * value(p.direction()); });
  EXPECT_GT(exhaust_rings(subject, few).different, 0U);
}

TEST(PolygonPlantedBugs, InternalEdgesNotCounted) {
  const auto subject =
      weighed([](const Passage& p) { return p.location() == Location::internal_edge ? 0 : 2 * value(p.direction()); });
  EXPECT_GT(exhaust_rings(subject, few).different, 0U);
}

TEST(PolygonPlantedBugs, DirectionForgotten) {
  const auto subject = weighed([](const Passage& p) { return std::abs(halves(p.location(), p.direction())); });
  EXPECT_GT(exhaust_rings(subject, few).different, 0U);
}

/// A repeated or flat vertex makes a triangle without area; it must not count.
TEST(PolygonPlantedBugs, FlatTrianglesCounted) {
  const auto subject = weighed([](const Passage& p) { return p.edge_on() ? 1 : halves(p.location(), p.direction()); });
  EXPECT_GT(exhaust_rings(subject, few).different, 0U);
}

/// A probe that meets a hole's edge, and not the outer ring, taken for a miss.
TEST(PolygonPlantedBugs, HoleEdgesExcluded) {
  const auto subject = [](const Polygon& polygon) {
    return [polygon](const Segment& s) {
      const Answer right = segura_feito(s, polygon, k);
      const std::size_t size = polygon.ring(0).size();
      const Answer outer = segura_feito(s, Polygon{polygon.ring(0), {&size, 1}}, k);
      const bool at_hole = right.contact == Contact::edge || right.contact == Contact::vertex;
      return right.hit && !(at_hole && outer.contact != Contact::edge && outer.contact != Contact::vertex);
    };
  };
  EXPECT_GT(exhaust_holes(subject, 2'000).different, 0U);
}

TEST(PolygonPlantedBugs, ProbesInThePlaneMissed) {
  const auto subject = [](const Polygon& polygon) {
    return [c = cover(polygon, k)](const Segment& s) {
      return c.plane && !sides_of(c.plane->triangle, s, k).in_plane() && segura_feito(s, c, k).hit;
    };
  };
  EXPECT_GT(exhaust_rings(subject, few).different, 0U);
}

}  // namespace
}  // namespace tribunal
