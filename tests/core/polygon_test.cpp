// The polygon test on cases that a person can draw, and what the covering knows of a polygon.
#include <gtest/gtest.h>

#include <limits>

#include "core/polygon_rivals.h"
#include "core/segura_feito_polygon.h"

namespace tribunal {
namespace {

const FormulaKernel<double> k;

/// A 9 × 9 square with a 2 × 2 hole.
const PolygonData frame = PolygonData{}
                              .add(std::vector<Point3>{{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {0, 9, 0}})
                              .add(std::vector<Point3>{{4, 4, 0}, {6, 4, 0}, {6, 6, 0}, {4, 6, 0}});

const PolygonData dart = PolygonData{}.add(std::vector<Point3>{{0, 0, 0}, {12, 6, 0}, {0, 12, 0}, {4, 6, 0}});

/// The answer of the prepared polygon, which must equal that of the unprepared one.
template <class P>
Answer ask(const P& probe, const Polygon& polygon) {
  const Answer prepared = segura_feito(probe, cover(polygon, k), k);
  Answer on_the_fly = segura_feito(probe, polygon, k);
  on_the_fly.planar = prepared.planar;  // the decision without preparation does not use it
  EXPECT_EQ(on_the_fly, prepared);
  return prepared;
}

/// The answer to a segment straight down through (x, y, 0).
Answer down(double x, double y, const Polygon& polygon) {
  const Answer a = ask(Segment{{x, y, 1}, {x, y, -1}}, polygon);
  EXPECT_TRUE(a.planar);
  return a;
}

TEST(PolygonTest, Contacts) {
  EXPECT_EQ(down(2, 1, frame), hit_at(Contact::interior, At::between));
  EXPECT_EQ(down(2, 2, frame), hit_at(Contact::interior, At::between)) << "on a spoke";
  EXPECT_EQ(down(5, 5, frame), miss()) << "in the hole, on a spoke";
  EXPECT_EQ(down(5, 4.5, frame), miss()) << "in the hole";
  EXPECT_EQ(down(5, 4, frame), hit_at(Contact::edge, At::between)) << "on the hole's edge";
  EXPECT_EQ(down(4, 4, frame), hit_at(Contact::vertex, At::between)) << "at the hole's corner";
  EXPECT_EQ(down(0, 0, frame), hit_at(Contact::vertex, At::between)) << "at the first vertex";
  EXPECT_EQ(down(0, 5, frame), hit_at(Contact::edge, At::between)) << "on an edge of the first vertex";
  EXPECT_EQ(down(10, 5, frame), miss());
  EXPECT_EQ(down(10, 0, frame), miss()) << "in line with an edge";
  EXPECT_EQ(down(3, 6, dart), miss()) << "in the notch, where triangles cancel";
  EXPECT_EQ(down(2, 3, dart), hit_at(Contact::edge, At::between));
  EXPECT_EQ(down(6, 6, dart), hit_at(Contact::interior, At::between));
}

TEST(PolygonTest, EndsOfTheProbe) {
  EXPECT_EQ(ask(Segment{{2, 1, 0}, {2, 1, 5}}, frame), hit_at(Contact::interior, At::source));
  EXPECT_EQ(ask(Segment{{2, 1, 5}, {2, 1, 0}}, frame), hit_at(Contact::interior, At::target));
  EXPECT_EQ(ask(Segment{{2, 1, 5}, {2, 1, 1}}, frame), miss());
  EXPECT_EQ(ask(Ray{{2, 1, 5}, {{0, 0, -1}}}, frame), hit_at(Contact::interior, At::between));
  EXPECT_EQ(ask(Ray{{2, 1, 5}, {{0, 0, 1}}}, frame), miss());
  EXPECT_EQ(ask(Ray{{4, 5, 5}, {{0, 0, -1}}}, frame), hit_at(Contact::edge, At::between));
}

TEST(PolygonTest, ProbesInThePlane) {
  const Answer hit = hit_at(Contact::coplanar);
  EXPECT_EQ(ask(Segment{{1, 1, 0}, {2, 1, 0}}, frame), hit) << "inside as a whole";
  EXPECT_EQ(ask(Segment{{4.5, 5, 0}, {5.5, 5, 0}}, frame), miss()) << "in the hole as a whole";
  EXPECT_EQ(ask(Segment{{5, 5, 0}, {7, 5, 0}}, frame), hit) << "out of the hole";
  EXPECT_EQ(ask(Segment{{9, 9, 0}, {12, 9, 0}}, frame), hit) << "from a corner";
  EXPECT_EQ(ask(Segment{{10, 9, 0}, {12, 9, 0}}, frame), miss());
  EXPECT_EQ(ask(Segment{{1, 1, 0}, {1, 1, 0}}, frame), hit) << "a point";
  EXPECT_EQ(ask(Ray{{5, 5, 0}, {{1, 0, 0}}}, frame), hit);
  EXPECT_EQ(ask(Ray{{-1, 5, 0}, {{-1, 0, 0}}}, frame), miss());
}

TEST(PolygonTest, RingsWithoutArea) {
  const auto ring = [](const std::vector<Point3>& v) { return PolygonData{}.add(v); };
  const PolygonData point = ring({{1, 2, 3}}), line = ring({{0, 0, 0}, {8, 8, 8}, {4, 4, 4}});
  EXPECT_TRUE(ask(Segment{{1, 2, 0}, {1, 2, 9}}, point).hit);
  EXPECT_FALSE(ask(Segment{{1, 2, 4}, {1, 2, 9}}, point).hit);
  EXPECT_EQ(ask(Segment{{6, 6, 0}, {6, 6, 9}}, line), hit_at(Contact::coplanar));
  EXPECT_FALSE(ask(Segment{{9, 9, 0}, {9, 9, 9}}, line).hit);
  const PolygonData cross = ring({{0, 0, 0}, {4, 0, 0}, {0, 0, 0}, {0, 4, 0}});
  EXPECT_TRUE(cover(cross, k).plane) << "two spikes span a plane";
  EXPECT_TRUE(down(3, 0, cross).hit);
  EXPECT_FALSE(down(1, 1, cross).hit);
  EXPECT_EQ(ask(Segment{{1, -1, 0}, {1, 1, 0}}, cross), hit_at(Contact::coplanar));
}

/// A quadrilateral folded along the spoke from (0,0,0) to (9,9,0); the two other corners are off the plane z = 0.
TEST(PolygonTest, NotPlanar) {
  const PolygonData fold = PolygonData{}.add(std::vector<Point3>{{0, 0, 0}, {9, 0, 3}, {9, 9, 0}, {0, 9, 3}});
  const Answer through = ask(Segment{{6, 3, 9}, {6, 3, -9}}, fold);
  EXPECT_FALSE(through.planar);
  EXPECT_EQ(through.contact, Contact::interior);
  EXPECT_EQ(through.at, At::between);
  EXPECT_TRUE(ask(Segment{{4, 4, 9}, {4, 4, -9}}, fold).hit) << "through the fold: two halves";
  EXPECT_FALSE(ask(Segment{{0, 8, 0}, {8, 0, 0}}, fold).hit) << "touches the fold from below: the halves cancel";
  EXPECT_FALSE(ask(Segment{{0, 8, 1}, {8, 0, 1}}, fold).hit) << "in and out again";
  EXPECT_EQ(ask(Segment{{9, 0, 3}, {12, 0, 9}}, fold).contact, Contact::vertex);
}

/// A spiral stair of three turns around the first vertex. The probe starts on the first step and goes up through the
/// others, so that no single place of contact can be named.
TEST(PolygonTest, SeveralPlacesAreNoOnePlace) {
  const PolygonData stair = PolygonData{}.add(std::vector<Point3>{
      {0, 0, 0}, {4, -4, 2}, {4, 4, 2}, {-8, 0, 0}, {4, -4, 4}, {4, 4, 4}, {-8, 0, 0}, {4, -4, 6}, {4, 4, 6}});
  EXPECT_EQ(ask(Segment{{2, 0, 1}, {2, 0, 5}}, stair).contact, Contact::interior) << "three steps";
  EXPECT_EQ(ask(Segment{{2, 0, 1}, {2, 0, 2.5}}, stair).contact, Contact::none) << "two";
  EXPECT_EQ(ask(Segment{{2, 0, 1}, {2, 0, 1.5}}, stair).at, At::source) << "one";
}

TEST(Covering, KnowsThePolygon) {
  EXPECT_FALSE(cover(frame, k).disjoint) << "two rings";
  EXPECT_FALSE(cover(dart, k).disjoint) << "the first vertex does not see all";
  const PolygonData from_notch = PolygonData{}.add(std::vector<Point3>{{4, 6, 0}, {0, 0, 0}, {12, 6, 0}, {0, 12, 0}});
  EXPECT_TRUE(cover(PolygonData{}.add(Polygon(frame).ring(0)), k).disjoint);
  EXPECT_FALSE(cover(from_notch, k).disjoint) << "seen whole, but over more than half a turn";
  EXPECT_TRUE(cover(frame, k).planar);
  for (const double height : {-1.0, 1.0}) {
    EXPECT_FALSE(
        cover(PolygonData{}.add(std::vector<Point3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, height}}), k).planar);
  }
  EXPECT_TRUE(cover(PolygonData{}, k).planar);
  EXPECT_FALSE(segura_feito(Segment{}, PolygonData{}, k).hit) << "nothing there";
}

TEST(PolygonRivals, AnswerAwayFromTheBoundary) {
  for (const Method& m : {haines_float(), haines_double(), feito_float(), feito_double()}) {
    const auto hit = [&](double x, double y) { return m.ask(Query{Segment{{x, y, 1}, {x, y, -1}}, frame}).hit; };
    EXPECT_TRUE(hit(2, 1)) << m.name;
    EXPECT_TRUE(hit(2, 2)) << m.name;
    EXPECT_FALSE(hit(5, 5)) << m.name;
    EXPECT_FALSE(hit(10, 1)) << m.name;
    EXPECT_FALSE(m.ask(Query{Segment{{1, 1, 0}, {2, 1, 0}}, frame}).hit) << "in the plane: " << m.name;
    EXPECT_TRUE(m.ask(Query{Ray{{1, 1, 5}, {{0, 0, -1}}}, frame}).hit) << m.name;
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(m.ask(Query{Segment{{nan, 1, 0}, {2, 1, 0}}, frame}).status, Status::nonfinite) << m.name;
    EXPECT_EQ(m.ask(Query{Segment{}, PolygonData{}}).status, Status::unsupported) << "no vertex: " << m.name;
  }
}

}  // namespace
}  // namespace tribunal
