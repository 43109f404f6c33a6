// The decision on small integer operands, where double is exact: one readable example per kind of contact.
#include "core/segura_feito.h"

#include <gtest/gtest.h>

#include "core/rivals/adapter.h"
#include "core/rivals/moeller_trumbore.h"

namespace tribunal {
namespace {

const FormulaKernel<double> k;
const Triangle t{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};

Answer segment(const Point3& p, const Point3& q, const Triangle& triangle = t) {
  return segura_feito(Segment{p, q}, triangle, k);
}

Answer ray(const Point3& o, const Point3& d, const Triangle& triangle = t) {
  return segura_feito(Ray{o, {d}}, triangle, k);
}

/// A hit that crosses the triangle from this side.
Answer crossing(Contact contact, At at, Facing facing) {
  Answer answer = hit_at(contact, at);
  answer.facing = facing;
  return answer;
}

TEST(SegmentTriangle, CrossingContacts) {
  EXPECT_EQ(segment({1, 1, 1}, {1, 1, -1}), crossing(Contact::interior, At::between, Facing::front));
  EXPECT_EQ(segment({1, 1, -1}, {1, 1, 1}), crossing(Contact::interior, At::between, Facing::back));
  EXPECT_EQ(segment({2, 0, 1}, {2, 0, -1}), crossing(Contact::edge, At::between, Facing::front));
  EXPECT_EQ(segment({2, 2, 1}, {2, 2, -1}), crossing(Contact::edge, At::between, Facing::front));
  EXPECT_EQ(segment({4, 0, 1}, {4, 0, -1}), crossing(Contact::vertex, At::between, Facing::front));
  EXPECT_EQ(segment({1, 1, 0}, {1, 1, 1}), crossing(Contact::interior, At::source, Facing::back));
  EXPECT_EQ(segment({1, 1, 1}, {1, 1, 0}), crossing(Contact::interior, At::target, Facing::front));
  EXPECT_EQ(segment({0, 0, -3}, {0, 0, 0}), crossing(Contact::vertex, At::target, Facing::back));
}

TEST(SegmentTriangle, Misses) {
  EXPECT_FALSE(segment({3, 3, 1}, {3, 3, -1}).hit) << "beside";
  EXPECT_FALSE(segment({1, 1, 1}, {1, 1, 2}).hit) << "above";
  EXPECT_FALSE(segment({-1, 0, 1}, {-1, 0, -1}).hit) << "on the line of an edge, outside it";
}

TEST(SegmentTriangle, Coplanar) {
  EXPECT_EQ(segment({1, 1, 0}, {2, 1, 0}), hit_at(Contact::coplanar)) << "inside";
  EXPECT_EQ(segment({-1, 1, 0}, {9, 1, 0}), hit_at(Contact::coplanar)) << "across";
  EXPECT_EQ(segment({-1, 4, 0}, {9, 4, 0}), hit_at(Contact::coplanar)) << "through a vertex";
  EXPECT_EQ(segment({1, 0, 0}, {9, 0, 0}), hit_at(Contact::coplanar)) << "along an edge";
  EXPECT_FALSE(segment({5, 0, 0}, {9, 0, 0}).hit) << "on the line of an edge, beyond it";
  EXPECT_FALSE(segment({3, 3, 0}, {9, 3, 0}).hit) << "beside";
}

TEST(SegmentTriangle, DegenerateOperands) {
  const Triangle line{{0, 0, 0}, {4, 4, 4}, {2, 2, 2}}, point{{1, 2, 3}, {1, 2, 3}, {1, 2, 3}};
  EXPECT_TRUE(segment({1, 1, 0}, {1, 1, 0}).hit) << "a point inside";
  EXPECT_FALSE(segment({1, 1, 1}, {1, 1, 1}).hit) << "a point above";
  EXPECT_FALSE(segment({5, 5, 0}, {5, 5, 0}).hit) << "a point beside";
  EXPECT_TRUE(segment({3, 3, 0}, {3, 3, 9}, line).hit);
  EXPECT_FALSE(segment({5, 5, 0}, {5, 5, 9}, line).hit) << "meets the line beyond the vertices";
  EXPECT_FALSE(segment({3, 2, 0}, {3, 2, 9}, line).hit) << "skew";
  EXPECT_TRUE(segment({-1, -1, -1}, {0, 0, 0}, line).hit) << "end to end";
  EXPECT_FALSE(segment({-2, -2, -2}, {-1, -1, -1}, line).hit) << "in line, apart";
  EXPECT_TRUE(segment({1, 2, 3}, {1, 2, 3}, point).hit);
  EXPECT_TRUE(segment({0, 2, 3}, {2, 2, 3}, point).hit);
  EXPECT_FALSE(segment({2, 2, 3}, {3, 2, 3}, point).hit);
}

TEST(RayTriangle, ReachesForwardOnly) {
  EXPECT_EQ(ray({1, 1, 5}, {0, 0, -1}), crossing(Contact::interior, At::between, Facing::front));
  EXPECT_FALSE(ray({1, 1, 5}, {0, 0, 1}).hit) << "behind";
  EXPECT_FALSE(ray({1, 1, 5}, {1, 0, 0}).hit) << "parallel";
  EXPECT_EQ(ray({1, 1, 0}, {0, 0, 1}), crossing(Contact::interior, At::source, Facing::back));
  EXPECT_EQ(ray({4, 0, 5}, {0, 0, -1}), crossing(Contact::vertex, At::between, Facing::front));
}

TEST(RayTriangle, InThePlane) {
  EXPECT_TRUE(ray({-1, 1, 0}, {1, 0, 0}).hit);
  EXPECT_FALSE(ray({-1, 1, 0}, {-1, 0, 0}).hit);
  EXPECT_TRUE(ray({9, 0, 0}, {-1, 0, 0}).hit) << "along an edge";
  EXPECT_FALSE(ray({9, 0, 0}, {1, 0, 0}).hit);
  EXPECT_FALSE(ray({-1, 5, 0}, {1, 0, 0}).hit);
  EXPECT_TRUE(ray({1, 1, 0}, {0, 0, 0}).hit) << "no direction: a point inside";
  EXPECT_FALSE(ray({1, 1, 1}, {0, 0, 0}).hit);
}

TEST(RayTriangle, DegenerateTriangles) {
  const Triangle line{{0, 0, 0}, {4, 4, 4}, {2, 2, 2}}, point{{1, 2, 3}, {1, 2, 3}, {1, 2, 3}};
  EXPECT_TRUE(ray({-1, -1, -1}, {1, 1, 1}, line).hit);
  EXPECT_FALSE(ray({-1, -1, -1}, {-1, -1, -1}, line).hit);
  EXPECT_TRUE(ray({3, 3, 0}, {0, 0, 1}, line).hit);
  EXPECT_FALSE(ray({3, 3, 4}, {0, 0, 1}, line).hit) << "the line lies behind";
  EXPECT_TRUE(ray({0, 2, 3}, {1, 0, 0}, point).hit);
  EXPECT_FALSE(ray({0, 2, 3}, {1, 1, 0}, point).hit);
  EXPECT_FALSE(ray({2, 2, 3}, {1, 0, 0}, point).hit);
}

TEST(HitOrder, ComparesParameters) {
  const Triangle nearer{{0, 0, 1}, {4, 0, 1}, {0, 4, 1}}, farther{{0, 0, 3}, {0, 4, 3}, {4, 0, 3}};
  const Ray up{{1, 1, 0}, {{0, 0, 2}}};
  EXPECT_EQ(k.compare_hits(up, nearer, farther), Sign::negative);
  EXPECT_EQ(k.compare_hits(up, farther, nearer), Sign::positive);
  EXPECT_EQ(k.compare_hits(up, nearer, nearer), Sign::zero);
}

TEST(MoellerTrumbore, AgreesOnTransversalContacts) {
  EXPECT_EQ(published::meet<published::MoellerTrumbore<double>>(Segment{{1, 1, 1}, {1, 1, -1}}, t)->t, 0.5);
  EXPECT_EQ(published::meet<published::MoellerTrumbore<float>>(Ray{{1, 1, 5}, {{0, 0, -1}}}, t)->t, 5.0F);
  EXPECT_TRUE(published::meet<published::MoellerTrumbore<double>>(Segment{{4, 0, 1}, {4, 0, -1}}, t))
      << "closed at the boundary";
  EXPECT_FALSE(published::meet<published::MoellerTrumbore<double>>(Segment{{1, 1, 0}, {2, 1, 0}}, t))
      << "coplanar is a miss";
  EXPECT_FALSE(published::meet<published::MoellerTrumbore<double>>(Segment{{1, 1, 3}, {1, 1, 1}}, t)) << "stops short";
  EXPECT_FALSE(published::meet<published::MoellerTrumbore<double>>(Ray{{1, 1, -1}, {{0, 0, -1}}}, t)) << "behind";
}

}  // namespace
}  // namespace tribunal
