// Boxes of the tree: none that a probe exactly meets is lost, on any instruction set.
#include <gmpxx.h>

#include <cmath>
#include <set>

#include "tests/tracer/box_support.h"
#include "tests/tracer/tree_support.h"

namespace tribunal {

namespace {

using testing::box_between;
using testing::offered;
using testing::Random;
using testing::tree_over;

class WideBoxes : public testing::OnEveryTarget {};

INSTANTIATE_TEST_SUITE_P(Targets, WideBoxes, ::testing::ValuesIn(batch_targets()), testing::target_name);

/// Whether o + t·d is in the closed box for some 0 ≤ t ≤ end, exactly; `first` is the least such t.
struct ExactMeeting {
  bool meets = true;
  mpq_class first = 0, last;
  bool bounded = false;
};

ExactMeeting exact_meeting(const Point3& o, const std::array<mpq_class, 3>& d, bool segment, const Box& b) {
  ExactMeeting m;
  if (segment) m.bounded = true, m.last = 1;
  for (int i = 0; i < 3; ++i) {
    const mpq_class& along = d[static_cast<std::size_t>(i)];
    const mpq_class from(o[i]), lo(b.lo[i]), hi(b.hi[i]);
    if (along == 0) {
      m.meets &= lo <= from && from <= hi;
      continue;
    }
    mpq_class in = (lo - from) / along, out = (hi - from) / along;
    if (in > out) std::swap(in, out);
    if (in > m.first) m.first = in;
    if (!m.bounded || out < m.last) m.last = out;
    m.bounded = true;
  }
  m.meets &= !m.bounded || m.first <= m.last;
  return m;
}

ExactMeeting exact_meeting(const Ray& r, const Box& b) {
  return exact_meeting(r.o, {mpq_class(r.d.v.x), mpq_class(r.d.v.y), mpq_class(r.d.v.z)}, false, b);
}

ExactMeeting exact_meeting(const Segment& s, const Box& b) {
  const auto d = [&](int i) { return mpq_class(mpq_class(s.q[i]) - mpq_class(s.p[i])); };
  return exact_meeting(s.p, {d(0), d(1), d(2)}, true, b);
}

struct BoxScore {
  int met = 0, lost = 0, offered = 0, asked = 0;
};

/// Counts boxes that the probe exactly meets but the walk does not enter: without a limit, and for rays also with the
/// limit at the first t in the box. `spoil` may change the probe.
template <class P, class Spoil>
void score(const std::vector<Box>& boxes, const WideTree& tree, const P& probe, const Spoil& spoil, BoxScore& s) {
  WideProbe wide(probe, tree.frame());
  spoil(wide);
  const float end = std::is_same_v<P, Segment> ? wide.limit_at(1) : WideProbe::far_away;
  const std::set<std::uint32_t> all = offered(tree, wide, end);
  s.offered += static_cast<int>(all.size());
  s.asked += static_cast<int>(boxes.size());
  for (std::uint32_t i = 0; i < boxes.size(); ++i) {
    const ExactMeeting m = exact_meeting(probe, boxes[i]);
    if (!m.meets) continue;
    ++s.met;
    s.lost += all.count(i) == 0;
    const double t = above(m.first.get_d());
    if (std::is_same_v<P, Ray>) s.lost += offered(tree, wide, wide.limit_at(t)).count(i) == 0;
  }
}

const auto unspoilt = [](WideProbe&) {};

const double nasty[] = {0.0,
                        -0.0,
                        1.0,
                        -1.0,
                        0x1p-1074,
                        -0x1p-1074,
                        0x1p-1022,
                        -0x1p-1022,
                        1.0 / 3,
                        0x1p40,
                        -0x1p40,
                        0x1p1023,
                        -0x1p1023,
                        0x1.fffffffffffffp1023,
                        -0x1.fffffffffffffp1023,
                        0.1,
                        0x1p-600,
                        0x1p600,
                        7,
                        -5.5,
                        0x1.0000000000001p0};

Point3 nasty_point(Random& random, int most) {
  Point3 p;
  for (int i = 0; i < 3; ++i) p[i] = nasty[random.below(static_cast<std::size_t>(most))];
  return p;
}

template <class P>
void nasty_boxes(std::uint64_t seed, BoxScore& s) {
  Random random(seed);
  for (int round = 0; round < 60; ++round) {
    const int most = round % 2 == 0 ? 21 : 10;  // with and without the ends of the range
    std::vector<Box> boxes;
    for (int i = 0; i < 24; ++i) {
      const Point3 a = nasty_point(random, most);
      boxes.push_back(box_between(a, nasty_point(random, most)));
    }
    const WideTree tree = tree_over(boxes);
    for (int i = 0; i < 20; ++i) {
      const Point3 o = nasty_point(random, 21);
      const Point3 d = nasty_point(random, 21);
      if constexpr (std::is_same_v<P, Ray>) score(boxes, tree, Ray{o, {d}}, unspoilt, s);
      if constexpr (std::is_same_v<P, Segment>) score(boxes, tree, Segment{o, d}, unspoilt, s);
    }
  }
}

TEST_P(WideBoxes, LosesNoNastyBox) {
  BoxScore rays, segments;
  nasty_boxes<Ray>(1, rays);
  nasty_boxes<Segment>(2, segments);
  EXPECT_EQ(rays.lost, 0);
  EXPECT_EQ(segments.lost, 0);
  EXPECT_GT(rays.met, 1500);
  EXPECT_GT(segments.met, 1000);
}

/// Cells of a lattice, and rays that touch many of them in exactly one corner, start there or run in their faces.
template <class Spoil>
BoxScore lattice_score(std::uint64_t seed, const Point3& offset, double scale, const Spoil& spoil) {
  Random random(seed);
  const auto at = [&](double x, double y, double z) { return offset + scale * Point3(x, y, z); };
  BoxScore s;
  for (int round = 0; round < 10; ++round) {
    std::vector<Box> boxes;
    for (int i = 0; i < 60; ++i) {
      const int x = random.within(0, 12), y = random.within(0, 12), z = random.within(0, 12);
      const int w = random.within(0, 2);
      boxes.push_back(box_between(at(x, y, z), at(x + w, y + 1, z + 1)));
    }
    const WideTree tree = tree_over(boxes);
    for (int i = 0; i < 40; ++i) {
      const Box& target = boxes[random.below(boxes.size())];
      const int x = random.within(-12, 24), y = random.within(-12, 24), z = random.within(-12, 24);
      const Point3 corner(random.below(2) == 0 ? target.lo.x : target.hi.x, target.lo.y, target.hi.z);
      const Point3 inside = at(x, y, z), steep = corner + scale * Point3((x % 2) * 0x1p-12, y, z);
      const Ray rays[] = {{inside, {corner - inside}}, {corner, {inside - corner}}, {steep, {corner - steep}}};
      score(boxes, tree, rays[i % 3], spoil, s);
    }
  }
  return s;
}

TEST_P(WideBoxes, LosesNoBoxTouchedInACorner) {
  const double scales[] = {1, 0x1p-1074, 0x1p-1060, 0x1p-500, 0x1p900, 0x1p1013};
  for (const double scale : scales) {
    const BoxScore s = lattice_score(3, Point3(0), scale, unspoilt);
    EXPECT_EQ(s.lost, 0) << "scale " << scale;
    EXPECT_GT(s.met, 400);
  }
  for (const double offset : {1.0, 0x1p20, 0x1p40, 0x1p48}) {
    const BoxScore s = lattice_score(4, Point3(offset, -offset, offset), 1, unspoilt);
    EXPECT_EQ(s.lost, 0) << "offset " << offset;
    EXPECT_LT(s.offered, s.asked / 3) << "boxes are not sharp at offset " << offset;
  }
}

/// Planted bug: the corpus above would not let it pass.
TEST_P(WideBoxes, TheCornersCatchAProbeThatIsNotWidened) {
  const auto narrow = [](WideProbe& p) {
    for (auto& a : p.axes) a.near_c = a.far_c = 0.5F * (a.near_c + a.far_c);
  };
  EXPECT_GT(lattice_score(3, Point3(0), 1, narrow).lost, 0);
}

/// The errors of near and far (probe.h) against the exact τ at which a ray passes a plane, in units of the widening
/// |r|·E.
struct PlaneErrors {
  double near = -1e9, far = -1e9;  ///< the greatest of near − τ and τ − far: the claim is that both are negative
};

PlaneErrors plane_errors(const std::function<void(WideProbe::Axis&)>& spoil) {
  Random random(21);
  PlaneErrors worst;
  for (int i = 0; i < 20000; ++i) {
    const Frame frame{Point3(0), 1, 1};
    const Point3 o = random.point(std::ldexp(1.0, random.within(-3, 6)));
    Point3 d = random.point(1);
    d.x = std::ldexp(d.x, -random.within(0, 20));
    const WideProbe probe(Ray{o, {d}}, frame);
    WideProbe::Axis a = probe.axes[0];
    const double e = 0.5 * (double{a.near_c} - double{a.far_c});
    spoil(a);
    const auto plane = static_cast<float>(2 * random.unit() - 1);
    int exponent = 0;
    std::frexp(std::max({std::fabs(d.x), std::fabs(d.y), std::fabs(d.z)}), &exponent);
    const double delta = std::ldexp(d.x, 1 - exponent);
    const mpq_class exact = (mpq_class(double{plane}) - mpq_class(o.x)) / mpq_class(delta);
    const volatile float product = plane * a.r;
    for (const float near : {std::fmaf(plane, a.r, -a.near_c), product - a.near_c}) {
      worst.near = std::max(worst.near, mpq_class(mpq_class(double{near}) - exact).get_d() / e);
    }
    for (const float far : {std::fmaf(plane, a.r, -a.far_c), product - a.far_c}) {
      worst.far = std::max(worst.far, mpq_class(exact - mpq_class(double{far})).get_d() / e);
    }
  }
  return worst;
}

TEST(WideProbe, PassesEachPlaneWithinItsBounds) {
  const PlaneErrors worst = plane_errors([](WideProbe::Axis&) {});
  EXPECT_LT(worst.near, -0.5) << "half of the widening is for other rounding modes";
  EXPECT_LT(worst.far, -0.5);
  EXPECT_GT(worst.near, -0.95) << "the widening is more than 20 times the errors";
}

/// Planted bugs: only one side widened, and a widening that is 16 times too small.
TEST(WideProbe, TheBoundsCatchAMissingOrASmallWidening) {
  const auto middle = [](const WideProbe::Axis& a) { return static_cast<float>(0.5 * (double{a.near_c} + a.far_c)); };
  EXPECT_GT(plane_errors([&](WideProbe::Axis& a) { a.near_c = middle(a); }).near, 0);
  EXPECT_GT(plane_errors([&](WideProbe::Axis& a) { a.far_c = middle(a); }).far, 0);
  const PlaneErrors small = plane_errors([&](WideProbe::Axis& a) {
    const float m = middle(a);
    a.near_c = m + (a.near_c - m) / 16;
    a.far_c = m - (m - a.far_c) / 16;
  });
  EXPECT_GT(small.near, 0);
  EXPECT_GT(small.far, 0);
}

}  // namespace
}  // namespace tribunal
