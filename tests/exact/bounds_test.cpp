// Rays with bounds on t: the exact answer by formulations that share nothing, every exact method, the filter in every
// floating-point environment, and what contracts owe.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

#include "core/segura_feito.h"
#include "exact/base/failure.h"
#include "exact/cases/case_io.h"
#include "exact/cases/case_line.h"
#include "exact/cases/family_table.h"
#include "exact/filtered/filtered.h"
#include "exact/filtered/filtered_kernel.h"
#include "exact/filtered/within_filter.h"
#include "exact/kernels/rational_kernel.h"
#include "exact/methods/methods.h"
#include "exact/relations/evidence.h"
#include "exact/shrink/shrink.h"
#include "exact/trial/fuzz.h"
#include "tests/exact/scaled_rays.h"

namespace tribunal {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
const Triangle corner{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
const Ray down{{1, 1, 3}, {{0, 0, -2}}};  // hits at t = 1.5

Query bounded(const Ray& r, const Bounds& b, const Triangle& t = corner) { return {r, t, b}; }

Trial trial_of(Format format, std::uint64_t k) { return find_family("bounds")->make(format, 7, k); }

/// The small integers and halves, and none.
constexpr double small_bounds[] = {0, 0.5, 1, 1.5, 2, infinity};

/// All bounds of these on rays of a grid: the truth, in which four formulations agree (or the run ends), and a common
/// point or a separating plane, which share no formula with any of them.
TEST(Bounds, OnASmallGridTheTruthHasEvidence) {
  std::set<ClassId> classes;
  std::uint64_t hits = 0, misses = 0, coplanar = 0;
  for (std::uint64_t k = 0; k < 3'000; ++k) {
    Trial trial = trial_of(Format::binary64, k);
    for (const double tmin : small_bounds) {
      for (const double tmax : small_bounds) {
        if (std::isinf(tmin) || tmin > tmax || (k + static_cast<std::uint64_t>(4 * tmin)) % 5 != 0) continue;
        trial.query.bounds = Bounds{tmin, tmax};
        const Truth truth = exact_truth(trial.query);
        const bool has_point = common_point(trial.query).has_value();
        ASSERT_EQ(truth.hit(), has_point) << case_line("x", trial.query);
        ASSERT_EQ(truth.hit(), !has_separating_plane(trial.query)) << case_line("x", trial.query);
        truth.hit() ? ++hits : ++misses;
        coplanar += truth.contact == Contact::coplanar;
        classes.insert(truth.class_id);
      }
    }
  }
  EXPECT_GT(hits, 500U);
  EXPECT_GT(misses, 500U);
  EXPECT_GT(coplanar, 100U);
  EXPECT_GT(classes.size(), 120U);
}

/// In both formats, at every kind of bound.
TEST(Bounds, EveryExactMethodIsRightOnTheFamily) {
  FuzzPlan plan;
  for (const Method& m : all_methods()) {
    if (m.contract.exact && m.contract.probes.bounds) plan.methods.push_back(m);
  }
  EXPECT_GE(plan.methods.size(), 5U);
  for (const Format format : {Format::binary64, Format::binary32})
    plan.streams.push_back({find_family("bounds"), format});
  plan.cases = 16'000;
  const FuzzReport report = fuzz(plan);
  for (const Finding& f : report.findings) {
    ADD_FAILURE() << plan.methods[f.method].name << " " << case_line("x", f.trial.query);
  }
  std::uint64_t judged = 0;
  report.counts.for_each([&](const Cell&, const Count& count) { judged += count.judged(); });
  EXPECT_EQ(judged, plan.cases * plan.methods.size()) << "all are owed";
}

/// The certified way agrees with the oracles where it is audited, and naive methods are wrong somewhere.
TEST(Bounds, NaiveMethodsAreWrongAtTheBounds) {
  FuzzPlan plan;
  plan.methods = {*find_method("sf-double"), *find_method("mt-double"), *find_method("cgal-epick")};
  plan.streams = {{find_family("bounds"), Format::binary64}};
  plan.cases = 12'000;
  plan.quick = certified_class;
  const FuzzReport report = fuzz(plan);
  EXPECT_GT(report.audited, 20U);
  Count by_method[3];
  report.counts.for_each([&](const Cell& c, const Count& count) { by_method[c.method] += count; });
  EXPECT_GT(by_method[0].wrong, 100U);
  EXPECT_GT(by_method[1].wrong, 100U);
  EXPECT_EQ(by_method[2].judged(), 0U);
  EXPECT_EQ(by_method[2].unsupported, plan.cases) << "counted, not skipped";
}

TEST(Bounds, TheFilterIsRightInEveryEnvironment) {
  std::uint64_t by_filter = 0, by_exact = 0, k = 0;
  for (const unsigned environment : testing::environments) {
    for (int i = 0; i < 1'000; ++i, ++k) {
      const Trial trial = trial_of(Format::binary64, k);
      const Ray r = std::get<Ray>(trial.query.probe);
      const Bounds b = *trial.query.bounds;
      const Triangle& t = trial.query.triangle();
      const Answer expected = segura_feito(r, b, t, RationalKernel{});
      Answer answer;
      bool hit = false;
      {
        const testing::InEnvironment foreign(environment);
        answer = intersect(r, b, t);
        hit = hits(r, b, t);
      }
      by_filter += answer.stage == Stage::filter;
      by_exact += answer.stage == Stage::exact;
      answer.stage = Stage::none;
      ASSERT_EQ(answer, expected) << environment << " " << case_line("x", trial.query);
      ASSERT_EQ(hit, expected.hit);
    }
  }
  EXPECT_GT(by_filter, k / 4) << "the filter decides something";
  EXPECT_GT(by_exact, k / 10) << "and is left";
}

/// The sides along a ray, by every kernel that has them, at all scales.
TEST(Bounds, KernelsAgreeOnTheSideOfAPointOfARay) {
  std::uint64_t certain = 0, zeros = 0;
  for (std::uint64_t k = 0; k < 6'000; ++k) {
    const Query q = trial_of(Format::binary64, k).query;
    const Triangle& t = q.triangle();
    for (const double at : {q.bounds->tmin, q.bounds->tmax}) {
      if (std::isinf(at)) continue;
      const RayPoint x{std::get<Ray>(q.probe), at};
      const Sign exact = RationalKernel{}.orient3d(t.a, t.b, t.c, x);
      zeros += exact == Sign::zero;
      ASSERT_EQ(FilteredKernel{}.orient3d(t.a, t.b, t.c, x), exact);
      if (const auto sign = detail::SidesAlongRay(x.ray, t).at(at)) {
        ++certain;
        ASSERT_EQ(*sign, exact);
      }
    }
  }
  EXPECT_GT(certain, 1'000U);
  EXPECT_GT(zeros, 500U);
}

TEST(Bounds, AreClosedAtBothEnds) {
  const double next = std::nextafter(1.5, 2), before = std::nextafter(1.5, 1);
  for (const Method& m : all_methods()) {
    if (!m.within || m.contract.format != Format::binary64 || m.contract.bounds != Ends::closed) continue;
    if (m.name == "sf-double-eps") continue;  // what is near a bound is at it
    const auto hit = [&](double tmin, double tmax) { return m.ask(bounded(down, {tmin, tmax})).hit; };
    EXPECT_TRUE(hit(0, infinity)) << m.name;
    EXPECT_TRUE(hit(1.5, infinity)) << m.name;
    EXPECT_TRUE(hit(0, 1.5)) << m.name;
    EXPECT_TRUE(hit(1.5, 1.5)) << m.name;
    EXPECT_FALSE(hit(next, infinity)) << m.name;
    EXPECT_FALSE(hit(0, before)) << m.name;
    EXPECT_FALSE(hit(next, next)) << m.name;
  }
}

/// A point of the ray is a crossing where the ray crosses, and says at which bound.
TEST(Bounds, TheContactIsTheRays) {
  const Answer at_both = segura_feito(down, {1.5, 1.5}, corner, RationalKernel{});
  EXPECT_EQ(at_both.contact, Contact::interior);
  EXPECT_EQ(at_both.at, At::source);
  EXPECT_EQ(at_both.facing, Facing::front);
  EXPECT_EQ(segura_feito(down, {1, 1.5}, corner, RationalKernel{}).at, At::target);
  EXPECT_EQ(segura_feito(down, {1, 2}, corner, RationalKernel{}).at, At::between);
  const Ray along{{-2, 1, 0}, {{1, 0, 0}}};  // in the plane, inside from t = 2 to 5
  EXPECT_EQ(segura_feito(along, {1, 2}, corner, RationalKernel{}).contact, Contact::coplanar);
  EXPECT_FALSE(segura_feito(along, {1, std::nextafter(2, 1)}, corner, RationalKernel{}).hit);
  EXPECT_TRUE(segura_feito(along, {5, 7}, corner, RationalKernel{}).hit);
  EXPECT_FALSE(segura_feito(along, {std::nextafter(5, 6), infinity}, corner, RationalKernel{}).hit);
  EXPECT_TRUE(segura_feito(along, {3, 3}, corner, RationalKernel{}).hit) << "a point inside";
  const Ray nowhere{{1, 1, 0}, {{0, 0, 0}}};
  EXPECT_TRUE(segura_feito(nowhere, {3, infinity}, corner, RationalKernel{}).hit) << "a point, whatever t is";
}

TEST(Bounds, ContractsOweWhatTheyReadOfThem) {
  Contract c{.probes = {.bounds = true}};
  const auto owed = [&](double tmin, double tmax) { return due(c, exact_truth(bounded(down, {tmin, tmax}))); };
  EXPECT_EQ(owed(1.5, 2), Due::hit);
  EXPECT_EQ(owed(1.6, 2), Due::miss);
  c.bounds = Ends::open;
  EXPECT_EQ(owed(1.5, 2), Due::miss);
  EXPECT_EQ(owed(1, 1.5), Due::miss);
  EXPECT_EQ(owed(1, 2), Due::hit);
  c.bounds = Ends::unspecified;
  EXPECT_EQ(owed(1, 1.5), Due::nothing);
  EXPECT_EQ(owed(1, 2), Due::hit);
  c.bounds = Ends::closed;
  c.ends = Ends::open;  // of the ray: its origin
  EXPECT_EQ(owed(1.5, 2), Due::hit);
  const Ray from_the_plane{{1, 1, 0}, {{0, 0, -2}}};
  EXPECT_EQ(due(c, exact_truth(bounded(from_the_plane, {0, 2}))), Due::miss);
  c.probes.bounds = false;
  EXPECT_EQ(owed(1, 2), Due::nothing) << "not taken";
  c.probes.bounds = true;
  c.ends = Ends::closed;
  c.culling = Culling::back_faces;
  EXPECT_EQ(owed(1, 2), Due::hit);
  EXPECT_EQ(due(c, exact_truth(bounded(Ray{{1, 1, -3}, {{0, 0, 2}}}, {1, 2}))), Due::miss);
}

TEST(Bounds, AreUnsupportedByMethodsWithoutThem) {
  EXPECT_EQ(find_method("cgal-epick")->ask(bounded(down, {0, 2})).status, Status::unsupported);
  EXPECT_EQ(find_method("jimenez-double")->ask(bounded(down, {0, 2})).status, Status::unsupported);
  EXPECT_EQ(find_method("sf-rational")->ask(bounded(down, {std::nan(""), 2})).status, Status::nonfinite);
  for (const Method& m : all_methods()) EXPECT_EQ(m.contract.probes.bounds, has(m, Capability::bounds)) << m.name;
}

TEST(Bounds, AreReadAndWrittenExactly) {
  const auto read = [](const std::string& t, const char* fmt = "binary64") {
    return to_case(parse_json(R"({"id":"x","fmt":")" + std::string(fmt) + R"(","ray":{"o":[1,1,3],"d":[0,0,-2],"t":)" +
                                  t + R"(},"tri":[[0,0,0],[4,0,0],[0,4,0]]})",
                              {"test"}),
                   {"test"});
  };
  for (const char* t : {"[0,\"inf\"]", "[\"0x1.8p+0\",1.5]", "[5e-324,\"0x1.fffffffffffffp+1023\"]"}) {
    const Case c = read(t);
    ASSERT_TRUE(c.query.bounds);
    EXPECT_EQ(to_case(from_case(c), {"test"}).query.bounds, c.query.bounds);
  }
  EXPECT_EQ(read("[0,\"inf\"]").query.bounds->tmax, infinity);
  for (const char* t : {"[1]", "[-1,2]", "[2,1]", "7", "[0,\"far\"]"}) EXPECT_THROW(read(t), Failure) << t;
  for (const char* t : {"[\"inf\",\"inf\"]", "[0,\"nan\"]", "[0,\"-inf\"]", "[\"nan\",1]"}) {
    EXPECT_FALSE(is_finite(read(t).query)) << t;
  }
  EXPECT_THROW(read("[0,0.1]", "binary32"), Failure);
  EXPECT_NO_THROW(read("[0.5,\"inf\"]", "binary32"));
}

/// A wrong answer shrinks to bounds of few bits, and stays wrong in the same way.
TEST(Bounds, Shrink) {
  Method open = *find_method("sf-rational");
  open.within = [](const Ray& r, const Bounds& b, const Triangle& t) {
    const Answer a = segura_feito(r, b, t, RationalKernel{});
    return a.at == At::source ? miss() : a;
  };
  const Query small = shrink(open, bounded({{0.25, 0.375, 30}, {{0.1, 0.2, -5}}}, {6, 77}), Format::binary64);
  ASSERT_TRUE(small.bounds);
  EXPECT_EQ(small.bounds->tmax, infinity);
  EXPECT_EQ(exact_truth(small).at, At::source);
}

/// The side from which a triangle is met is told by methods that know it, and judged.
TEST(Sides, AreToldAndJudged) {
  const Ray up{{1, 1, -3}, {{0, 0, 2}}};
  for (const Method& m : all_methods()) {
    if (!m.tells_side) continue;
    EXPECT_EQ(m.ray(down, corner).facing, Facing::front) << m.name;
    if (m.contract.culling == Culling::none) {
      EXPECT_EQ(m.ray(up, corner).facing, Facing::back) << m.name;
    }
    EXPECT_EQ(judge(m, exact_truth({down, corner}), m.ray(down, corner)), Outcome::right) << m.name;
    Answer turned = m.ray(down, corner);
    turned.facing = Facing::back;
    EXPECT_EQ(judge(m, exact_truth({down, corner}), turned), Outcome::wrong_contact) << m.name;
  }
  EXPECT_TRUE(find_method("mt-cull-double")->tells_side);
}

TEST(Sides, OfExactMethodsAreRightOnEveryFamily) {
  std::uint64_t told = 0;
  for (const char* name : {"sf-filtered", "sf-epick", "sf-expansion"}) {
    const Method& m = *find_method(name);
    for (const char* family : {"affine", "ulp", "plain", "near", "extreme"}) {
      for (std::uint64_t k = 0; k < 400; ++k) {
        const Query q = find_family(family)->make(Format::binary64, 3, k).query;
        const Answer answer = m.ask(q);
        const Truth truth = exact_truth(q);
        ASSERT_EQ(answer.facing, truth.facing) << name << " " << case_line("x", q);
        told += answer.facing != Facing::unsaid;
      }
    }
  }
  EXPECT_GT(told, 1'000U);
}

}  // namespace
}  // namespace tribunal
