// The hit that a rival computes: its t and its weights, on one triangle with three different sides.
#include <gtest/gtest.h>

#include <limits>

#include "core/rivals/adapter.h"
#include "core/rivals/chirkov.h"
#include "core/rivals/jimenez.h"
#include "core/rivals/simulation_of_simplicity.h"
#include "core/rivals/woop.h"

namespace tribunal {
namespace {

using namespace published;

const Triangle t{{0, 0, 0}, {8, 0, 0}, {0, 4, 0}};

/// A segment that meets the triangle at t = 1/4, in the point with weight 1/4 of b and 1/2 of c.
const Segment through{{3, 0, 1}, {-1, 8, -3}};

TEST(Rivals, OfSegmentsTellWhereTheyAreMet) {
  const auto hit = meet<Jimenez<double>>(through, t);
  ASSERT_TRUE(hit && hit->weights);
  EXPECT_EQ(hit->t, 0.25);
  EXPECT_EQ(hit->weights->b, 0.25);
  EXPECT_EQ(hit->weights->c, 0.5);
  EXPECT_EQ(meet<ChirkovUnprepared<double>>(through, t)->t, 0.25);
  EXPECT_EQ(meet<ChirkovPrepared<float>>(through, t)->t, 0.25F);
  EXPECT_EQ(meet<SimulationOfSimplicity<double>>(through, t)->t, 0.25);
}

/// The theorem's condition: the ends are swapped if the first lies in the plane.
TEST(Jimenez, SwapsTheEndsIfTheFirstIsInThePlane) {
  for (const double z : {5.0, -5.0}) {
    const auto from = meet<Jimenez<double>>(Segment{{2, 2, 0}, {1, 1, z}}, t);
    ASSERT_TRUE(from && from->weights) << "the branch that ports get wrong";
    EXPECT_EQ(from->t, 0);
    EXPECT_EQ(from->weights->b, 0.25);
    EXPECT_EQ(from->weights->c, 0.5);
    const auto to = meet<Jimenez<double>>(Segment{{1, 1, z}, {2, 2, 0}}, t);
    ASSERT_TRUE(to);
    EXPECT_EQ(to->t, 1);
    EXPECT_FALSE(meet<Jimenez<double>>(Segment{{7, 3, 0}, {1, 1, z}}, t)) << "beside the third edge";
    EXPECT_FALSE(meet<Jimenez<double>>(Segment{{-1, 2, 0}, {1, 1, z}}, t));
    EXPECT_FALSE(meet<Jimenez<double>>(Segment{{2, -1, 0}, {1, 1, z}}, t));
  }
}

TEST(Rivals, RefuseTheProbesThatTheyDoNotTake) {
  EXPECT_EQ(answer_of<Jimenez<double>>(Ray{{2, 2, 1}, {{0, 0, -1}}}, t).status, Status::unsupported);
  EXPECT_EQ(answer_to<ChirkovPrepared<float>>({Ray{{2, 2, 1}, {{0, 0, -1}}}, t}).status, Status::unsupported);
  EXPECT_EQ(answer_to<Woop<double>>({Ray{{2, 2, 1}, {{0, 0, -1}}}, PolygonData{}}).status, Status::unsupported);
  EXPECT_EQ(answer_to<Woop<double>>({Ray{{2, 2, 1}, {{0, 0, std::numeric_limits<double>::infinity()}}}, t}).status,
            Status::nonfinite);
  EXPECT_EQ(answer_to<Woop<double>>({Ray{{2, 1, 1}, {{0, 0, -1}}}, t}), hit_at(Contact::unsaid));
}

}  // namespace
}  // namespace tribunal
