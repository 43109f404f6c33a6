// sf-filtered against the reference, on every family, scale and stage.
#include "exact/filtered/filtered_kernel.h"

#include <gtest/gtest.h>

#include <cfenv>
#include <cmath>
#include <limits>

#include "exact/cases/families/draw.h"
#include "exact/cases/family_table.h"
#include "exact/filtered/filtered.h"
#include "exact/filtered/stages/exact_stages.h"
#include "exact/filtered/term_filter.h"
#include "exact/kernels/rational_kernel.h"
#include "exact/methods/methods.h"

namespace tribunal {

using namespace detail;

namespace {

const Method& filtered() { return *find_method("sf-filtered"); }

/// A ray from p towards q. Its direction is rounded, so it is another query than the segment.
Ray ray_of(const Segment& s) {
  const Point3 d = s.q - s.p;
  return {s.p, {is_finite(d) ? d : 0.5 * s.q - 0.5 * s.p}};
}

/// The segment itself; for a ray, the segment from its origin to the point with the coordinates of its direction.
Segment segment_of(const Probe& probe) {
  if (const auto* r = std::get_if<Ray>(&probe)) return {r->o, r->d.v};
  return std::get<Segment>(probe);
}

Ray ray_of(const Probe& probe) {
  if (const auto* r = std::get_if<Ray>(&probe)) return *r;
  return ray_of(std::get<Segment>(probe));
}

/// The answer without its stage, which the reference does not report.
Answer plain(Answer a) {
  a.stage = Stage::none;
  return a;
}

/// Asks both methods; counts the stage.
template <class P>
void expect_reference(const P& probe, const Triangle& t, Tally& tally, const char* what) {
  const Answer answer = filtered().ask({probe, t});
  ++tally[answer.stage];
  ASSERT_EQ(plain(answer), reference_method().ask({probe, t})) << what;
  if (is_finite(probe)) {
    ASSERT_EQ(hits(probe, t), answer.hit) << what;
  }
}

TEST(Filtered, AnswersEveryFamilyAsTheReferenceDoes) {
  for (const Family& family : families_of(Operands::triangles)) {
    Tally tally;
    for (const Format format : {Format::binary32, Format::binary64}) {
      for (std::uint64_t k = 0; k < 2500; ++k) {
        const Trial trial = family.make(format, 11, k);
        const Probe& probe = trial.query.probe;
        expect_reference(segment_of(probe), trial.query.triangle(), tally, family.name.data());
        expect_reference(ray_of(probe), trial.query.triangle(), tally, family.name.data());
      }
    }
    // Everyday scenes are what the filter is for; every other family must go past it.
    const bool everyday = family.name == "plain";
    EXPECT_EQ(tally[Stage::integers] == 0, everyday) << family.name;
  }
}

TEST(Filtered, NamesTheClassAndTheDeepestStage) {
  const Family& affine = *find_family("affine");
  Tally tally;
  for (std::uint64_t k = 0; k < 5000; ++k) {
    const Query q = affine.make(Format::binary64, 12, k).query;
    const Segment s = segment_of(q.probe);
    const Answer answer = filtered().classify(s, q.triangle());
    ASSERT_EQ(plain(answer), reference_method().classify(s, q.triangle()));
    ++tally[answer.stage];
  }
  EXPECT_GT(tally[Stage::filter], 0U);
  EXPECT_GT(tally[Stage::integers], 0U);
}

Point3 scaled(const Point3& p, const int (&e)[3]) {
  return {std::ldexp(p.x, e[0]), std::ldexp(p.y, e[1]), std::ldexp(p.z, e[2])};
}

Point3 draw_small(Draw& draw) {
  Point3 p;
  for (int i = 0; i < 3; ++i) p[i] = static_cast<double>(draw.between(-3, 3));
  return p;
}

/// Powers of two change no answer, from the smallest subnormal to the largest binade, one for all axes or each its own.
TEST(Filtered, AnswersAtEveryScale) {
  Tally tally;
  Draw draw(77, 1, 0);
  for (int e = -1074; e <= 1021; ++e) {
    for (int i = 0; i < 6; ++i) {
      Point3 v[5];
      for (Point3& p : v) p = draw_small(draw);
      const Answer expected = reference_method().segment({v[0], v[1]}, {v[2], v[3], v[4]});
      const Answer expected_ray = reference_method().ray({v[0], {v[1]}}, {v[2], v[3], v[4]});
      int scale[3] = {e, e, e};
      if (i % 2 == 1) scale[draw.below(3)] = static_cast<int>(draw.between(-1074, 1021));
      for (Point3& p : v) p = scaled(p, scale);
      const Triangle t{v[2], v[3], v[4]};
      const Answer answer = intersect(Segment{v[0], v[1]}, t);
      ++tally[answer.stage];
      ASSERT_EQ(plain(answer), expected) << "2^" << scale[0] << " " << scale[1] << " " << scale[2];
      ASSERT_EQ(plain(intersect(Ray{v[0], {v[1]}}, t)), expected_ray) << "2^" << scale[0];
    }
  }
  EXPECT_GT(tally[Stage::filter], 0U);
  EXPECT_EQ(tally[Stage::exact], 0U) << "one power of two an axis is no reason for GMP";
}

/// Coordinates with any exponents in one query: the integer grid is too coarse for some, and GMP must answer.
TEST(Filtered, ReachesEveryStageOnWildExponents) {
  Tally tally;
  constexpr int spans[] = {0, 4, 20, 60, 200, 1000};
  for (std::uint64_t k = 0; k < 6000; ++k) {
    Draw draw(78, 1, k);
    const int span = spans[k % 6];
    Point3 v[5];
    for (Point3& p : v) {
      for (int i = 0; i < 3; ++i) {
        const auto significand = static_cast<double>(draw.between(-(std::int64_t{1} << 53), std::int64_t{1} << 53));
        p[i] = std::ldexp(significand, static_cast<int>(draw.between(-span, span)) - 53);
      }
    }
    if (k / 6 % 3 == 1) v[4] = v[3];                        // a flat triangle
    if (k / 6 % 3 == 2) v[0] = v[2] + 0.5 * (v[3] - v[2]);  // almost on an edge
    expect_reference(Segment{v[0], v[1]}, {v[2], v[3], v[4]}, tally, "wild exponents");
    expect_reference(Ray{v[0], {v[1]}}, {v[2], v[3], v[4]}, tally, "wild exponents, ray");
  }
  for (const Stage s : deciding_stages) EXPECT_GT(tally[s], 50U) << name_of(s);
}

TEST(Filtered, AnswersAtTheEndsOfTheRange) {
  constexpr double largest = std::numeric_limits<double>::max(), smallest = std::numeric_limits<double>::denorm_min();
  constexpr double ends[] = {largest, -largest, smallest, -smallest, 0, -0.0, 1, 0x1p-1022};
  Tally tally;
  for (std::uint64_t k = 0; k < 8000; ++k) {
    Draw draw(79, 1, k);
    Point3 v[5];
    for (Point3& p : v) {
      for (int i = 0; i < 3; ++i) p[i] = ends[draw.below(8)];
    }
    expect_reference(Segment{v[0], v[1]}, {v[2], v[3], v[4]}, tally, "ends");
    expect_reference(Ray{v[0], {v[1]}}, {v[2], v[3], v[4]}, tally, "ends, ray");
  }
  EXPECT_GT(tally[Stage::exact], 50U);
}

TEST(Filtered, ComparesHitsAsTheReferenceDoes) {
  const FilteredKernel uncounted;
  const RationalKernel reference;
  Tally tally;
  const FilteredKernel kernel(&tally);
  constexpr int spans[] = {0, 3, 30, 100, 400};
  for (std::uint64_t k = 0; k < 10000; ++k) {
    Draw draw(80, 1, k);
    const int span = spans[k % 5];
    Point3 v[8];
    for (Point3& p : v) {
      for (int i = 0; i < 3; ++i) {
        const auto significand = static_cast<double>(draw.between(-(std::int64_t{1} << 53), std::int64_t{1} << 53));
        p[i] = std::ldexp(significand, static_cast<int>(draw.between(-span, span)) - 53);
      }
    }
    if (k % 2 == 0) v[5] = v[2];  // a common vertex: often equal in one coordinate of the hit
    if (k % 4 == 0) v[6] = v[3], v[7] = v[4];
    const Ray r{v[0], {v[1]}};
    const Triangle s{v[2], v[3], v[4]}, t{v[5], v[6], v[7]};
    ASSERT_EQ(kernel.compare_hits(r, s, t), reference.compare_hits(r, s, t));
    ASSERT_EQ(compare_hits(r, s, t), uncounted.compare_hits(r, s, t));
  }
  for (const Stage s : deciding_stages) EXPECT_GT(tally[s], 50U) << name_of(s);
}

TEST(Filtered, DecidesRandomInputInTheFilter) {
  Tally tally;
  for (std::uint64_t k = 0; k < 1'000'000; ++k) {
    Draw draw(81, 1, k);
    Point3 v[5];
    for (Point3& p : v) {
      for (int i = 0; i < 3; ++i) p[i] = std::ldexp(static_cast<double>(draw.next() >> 11), -53);
    }
    ++tally[intersect(Segment{v[0], v[1]}, {v[2], v[3], v[4]}).stage];
  }
  EXPECT_EQ(tally[Stage::filter], 1'000'000U);
}

TEST(Filtered, NamesNoHitForNonFiniteOperands) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {nan, infinity, -infinity}) {
    for (int vertex = 0; vertex < 5; ++vertex) {
      for (int axis = 0; axis < 3; ++axis) {
        Point3 v[5] = {{1, 1, -1}, {1, 1, 1}, {0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
        v[vertex][axis] = bad;
        const Triangle t{v[2], v[3], v[4]};
        EXPECT_FALSE(filter_hits(Segment{v[0], v[1]}, t, pair_filter<Segment>));
        EXPECT_FALSE(filter_hits(Ray{v[0], {v[1]}}, t, pair_filter<Ray>));
        EXPECT_FALSE(hits(Segment{v[0], v[1]}, t));
        EXPECT_FALSE(hits(Ray{v[0], {v[1]}}, t));
        EXPECT_EQ(intersect(Segment{v[0], v[1]}, t).status, Status::nonfinite);
        EXPECT_EQ(classify(Segment{v[0], v[1]}, t).status, Status::nonfinite);
      }
    }
  }
}

/// The trials are made and judged in the default environment; only sf-filtered runs in the other.
class ForeignEnvironment : public testing::TestWithParam<unsigned> {
 protected:
  static constexpr unsigned all_bits = 0xe040;  // rounding mode, flush to zero, denormals are zero
  static void enter(unsigned bits) { __builtin_ia32_ldmxcsr((__builtin_ia32_stmxcsr() & ~all_bits) | bits); }
};

TEST_P(ForeignEnvironment, ChangesNoAnswer) {
  Tally tally;
  for (const char* name :
       {"affine", "scale", "ulp", "zeros", "near", "tilt", "spread", "extreme", "overflow", "direction", "size"}) {
    const Family& family = *find_family(name);
    for (std::uint64_t k = 0; k < 1000; ++k) {
      const Query q = family.make(Format::binary64, 13, k).query;
      const Segment s = segment_of(q.probe);
      const Ray r = ray_of(q.probe);
      const Answer expected = reference_method().classify(s, q.triangle());
      const Answer expected_ray = reference_method().ray(r, q.triangle());
      enter(GetParam());
      const Answer answer = filtered().classify(s, q.triangle());
      const Answer by_query = filtered().segment(s, q.triangle());
      const Answer answer_ray = filtered().ray(r, q.triangle());
      const bool kept = (__builtin_ia32_stmxcsr() & all_bits) == GetParam();
      enter(0);
      ASSERT_EQ(plain(answer), expected) << name << k;
      ASSERT_EQ(by_query.hit, expected.hit) << name << k;
      ASSERT_EQ(plain(answer_ray), expected_ray) << name << k;
      ASSERT_TRUE(kept) << "the caller's environment was changed";
      ++tally[answer.stage];
    }
  }
  EXPECT_GT(tally[Stage::filter], 0U);
  EXPECT_GT(tally[Stage::integers], 0U);
}

INSTANTIATE_TEST_SUITE_P(Registers, ForeignEnvironment,
                         testing::Values(0x0000U, 0x2000U, 0x4000U, 0x6000U, 0x8000U, 0x0040U, 0x8040U, 0xe040U));

/// For points next to the plane of a triangle of any size, near and far, the certain signs of the plane's filter are
/// right.
TEST(PlaneFilter, NeverSaysTheWrongSide) {
  const RationalKernel exact;
  std::size_t certain = 0, undecided = 0;
  for (std::uint64_t k = 0; k < 20000; ++k) {
    Draw draw(978, 1, k);
    const double scale = std::ldexp(1.0, static_cast<int>(draw.between(-170, 170)) * (k % 4 == 0 ? 5 : 0));
    const double far = std::ldexp(1.0, static_cast<int>(draw.between(0, 12)));
    const auto unit = [&] { return std::ldexp(static_cast<double>(draw.between(-(1 << 30), 1 << 30)), -30); };
    const auto point = [&] { return Point3(unit(), unit(), unit()); };
    const Triangle t{scale * point(), scale * point(), scale * point()};
    const double u = far * unit(), v = far * unit();
    const Point3 on = t.a + u * (t.b - t.a) + v * (t.c - t.a);  // up to rounding
    const PlaneFilter plane(t);
    for (const Point3& x : {on, on + scale * 0x1p-50 * point(), on + scale * point()}) {
      const auto side = plane.side(x);
      side ? ++certain : ++undecided;
      ASSERT_EQ(side.value_or(exact.orient3d(t.a, t.b, t.c, x)), exact.orient3d(t.a, t.b, t.c, x)) << k;
      const Direction d{x - t.a};
      const auto towards = plane.side(d);
      ASSERT_EQ(towards.value_or(exact.orient3d(t.a, t.b, t.c, d)), exact.orient3d(t.a, t.b, t.c, d)) << k;
    }
  }
  EXPECT_GT(certain, 10000u);
  EXPECT_GT(undecided, 5000u);
  const double infinity = std::numeric_limits<double>::infinity();
  const PlaneFilter floor(Triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  EXPECT_EQ(floor.side(Point3(0, 0, infinity)), std::nullopt);
  EXPECT_EQ(floor.side(Point3(std::nan(""), 0, 1)), std::nullopt);
}

}  // namespace
}  // namespace tribunal
