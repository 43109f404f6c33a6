// What is called plain: where the points lie says it, and no sound test is wrong there.
#include "exact/trial/severity.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "exact/cases/case_io.h"
#include "exact/cases/family_table.h"
#include "exact/cases/own/family.h"
#include "exact/methods/methods.h"
#include "exact/trial/fuzz.h"

namespace tribunal {
namespace {

constexpr Triangle floor_of_ten{{0, 0, 0}, {10, 0, 0}, {0, 10, 0}};

Severity severity(const Query& q) { return severity_of(q, exact_truth(q)); }

/// Upright through (x, y) of the floor.
Query upright(double x, double y) { return {Segment{{x, y, 1}, {x, y, -1}}, floor_of_ten}; }

TEST(Severity, IsThatOfTheQuery) {
  EXPECT_EQ(severity({Segment{{2, 3, 1}, {3, 2, -1}}, floor_of_ten}), Severity::plain);
  EXPECT_EQ(severity({Segment{{20, 3, 1}, {30, 2, -1}}, floor_of_ten}), Severity::plain);
  EXPECT_EQ(severity(upright(2, 0)), Severity::boundary);
  EXPECT_EQ(severity(upright(2, 0.001)), Severity::plain);
  EXPECT_EQ(severity(upright(2, -0.001)), Severity::plain);
  EXPECT_EQ(severity({Segment{{2, 0x1p-13, 1}, {2, 0, -1}}, floor_of_ten}), Severity::plain) << "2^-14 above the edge";
  EXPECT_EQ(severity({Segment{{2, 1e-5, 1}, {2, 1, -1}}, floor_of_ten}), Severity::extreme);
  EXPECT_EQ(severity({Segment{{2, 1, 1e6}, {2, 1, -1}}, floor_of_ten}), Severity::extreme);
  EXPECT_EQ(severity({Ray{{2, 1, 1}, {{0, 0, -1}}}, floor_of_ten}), Severity::plain);
  EXPECT_EQ(severity({Ray{{2, 1, 1}, {{1, 0, 0}}}, floor_of_ten}), Severity::boundary) << "parallel";
  EXPECT_EQ(severity({Ray{{2, 1, 1}, {{0, 0, -1e-9}}}, floor_of_ten}), Severity::extreme);
}

TEST(Severity, OfNeedlesAndOfProbesThatHardlyLeaveThePlaneIsBoundary) {
  const Triangle needle{{0, 0, 0}, {10, 0, 0}, {5, 0x1p-12, 0}};
  EXPECT_EQ(severity({Segment{{5, 0x1p-13, 1}, {5, 0x1p-13, -1}}, needle}), Severity::boundary);
  EXPECT_EQ(severity({Segment{{2, 1, 0x1p-13}, {2, 1, -1}}, floor_of_ten}), Severity::plain);
  EXPECT_EQ(severity({Segment{{2, 1, 1e-4 + 1e-9}, {9, 1, -1}}, Triangle{{0, 0, 0}, {1e3, 0, 0}, {0, 1e3, 0}}}),
            Severity::boundary);
  EXPECT_EQ(severity({Ray{{2, 1, 1}, {{1e5, 0, 0.25}}}, floor_of_ten}), Severity::boundary) << "almost parallel";
}

/// Volumes that are far from zero, beside what they are summed from, say nothing of how near the vertex is.
TEST(Severity, OfAProbeTwoUlpsFromAVertexIsBoundary) {
  const double y = 0.017408;
  const Triangle t{{0, 0, 1}, {0, y - std::ldexp(1, -57), 0}, {0, 1, 1}};
  const Query q{Segment{{-1, y, 0}, {1, y, 0}}, t};
  ASSERT_NE(t.b.y, y);
  EXPECT_EQ(severity(q), Severity::boundary);
  EXPECT_EQ(severity({Segment{{-1, y, 0.125}, {1, y, 0.125}}, t}), Severity::plain);
}

TEST(Severity, KnowsBounds) {
  const Ray down{{2, 1, 1}, {{0, 0, -1}}};
  const auto within = [&](double tmin, double tmax) { return severity({down, floor_of_ten, Bounds{tmin, tmax}}); };
  EXPECT_EQ(within(0.5, 2), Severity::plain);
  EXPECT_EQ(within(0.5, INFINITY), Severity::plain);
  EXPECT_EQ(within(0.5, 0.75), Severity::plain);
  EXPECT_EQ(within(1, 2), Severity::boundary);
  EXPECT_EQ(within(0.5, 1 + 1e-9), Severity::boundary);
}

TEST(Severity, OfPolygonsLooksAtRingEdgesAndThePlane) {
  PolygonData square;
  square.add(std::vector<Point3>{{0, 0, 0}, {8, 0, 0}, {8, 8, 0}, {0, 8, 0}});
  const auto of = [&](const Segment& s) { return severity({s, square}); };
  EXPECT_EQ(of({{3, 2, 1}, {3, 2, -1}}), Severity::plain);
  EXPECT_EQ(of({{13, 2, 1}, {13, 2, -1}}), Severity::plain);
  EXPECT_EQ(of({{3, 0, 1}, {3, 0, -1}}), Severity::boundary) << "on an edge";
  EXPECT_EQ(of({{3, 1e-4 + 1e-12, 1}, {3, -1e-4, -1}}), Severity::boundary) << "5e-13 from an edge";
  EXPECT_EQ(of({{3, 2, 0}, {3, 2, -1}}), Severity::boundary) << "from the plane";
  EXPECT_EQ(of({{3, 2, 0}, {5, 2, 0}}), Severity::boundary) << "in the plane";
  EXPECT_EQ(of({{3, 2, 1}, {3, 2, -1e9}}), Severity::extreme);
}

/// Laws of the header: clearance stays the same when everything is scaled or moved, or a direction is longer; no
/// coordinate is larger than what it is measured with.
TEST(Clearance, IsOfPositionsAlone) {
  const auto moved = [](double scale, double by) {
    const auto at = [&](double x, double y, double z) { return Point3(x, y, z) * scale + by; };
    return Query{Segment{at(2, 3, 1), at(3, 2, -2)}, Triangle{at(0, 0, 0), at(10, 0, 1), at(0, 10, 0)}};
  };
  const Clearance here = clearance_of(moved(1, 0));
  EXPECT_GT(here.of_extent, 0.01);
  EXPECT_EQ(here.of_extent, here.of_coordinates);
  EXPECT_DOUBLE_EQ(clearance_of(moved(0x1p-10, 0)).of_coordinates, here.of_coordinates);
  EXPECT_DOUBLE_EQ(clearance_of(moved(1, 1024)).of_extent, here.of_extent);
  EXPECT_LT(clearance_of(moved(1, 1024)).of_coordinates, here.of_coordinates / 1000);
  const auto along = [](double length) {
    return clearance_of({Ray{{2, 3, 1}, {Point3(1, -1, -3) * length}}, floor_of_ten}).of_extent;
  };
  EXPECT_DOUBLE_EQ(along(1), along(1024));
}

TEST(Clearance, OfWhatHasNoAreaOrNoLengthIsNotEnough) {
  const auto clear = [](const Query& q) { return clearance_of(q).of_extent >= least_clearance; };
  EXPECT_FALSE(clear({Segment{{2, 3, 1}, {2, 3, 1}}, floor_of_ten}));
  EXPECT_FALSE(clear({Segment{{2, 3, 1}, {2, 3, -1}}, Triangle{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}}));
  EXPECT_FALSE(clear({Segment{{2, 3, 1}, {2, 3, -1}}, Triangle{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}}));
}

/// A metre of wall far from the origin is plain if its numbers have the digits, and not if tests in binary32 may be
/// asked.
TEST(Clearance, FarFromTheOriginNeedsDigits) {
  const auto at = [](double x) {
    return Query{Segment{{x, x + 0.25, -1}, {x, x + 0.25, 1}}, Triangle{{x - 1, x, 0}, {x + 1, x, 0}, {x, x + 1, 0}}};
  };
  EXPECT_EQ(severity(at(16)), Severity::plain);
  EXPECT_EQ(severity(at(0x1p16)), Severity::boundary);
  EXPECT_EQ(severity(at(0x1p16 + 1e-6)), Severity::plain);
}

/// Wrong as their authors wrote them, or numerically unstable, as docs/rivals.md and docs/findings.md say: these may be
/// wrong in plain position.
bool is_sound(const Method& m) {
  const auto is = [&](std::string_view start) { return m.name.starts_with(start); };
  return !is("mt-eps") && !is("mt-cull") && !is("badouel");
}

std::vector<Method> sound_methods(Operands operands) {
  std::vector<Method> sound;
  for (const Method& m : all_methods()) {
    const bool takes = operands == Operands::triangles ? m.contract.triangles != Triangles::none
                                                       : m.contract.polygons != Polygons::none;
    const bool is_float = m.card.number == "binary32" || m.card.number == "binary64";
    if (takes && is_float && is_sound(m)) sound.push_back(m);
  }
  return sound;
}

void expect_none_plain(const FuzzPlan& plan) {
  std::vector<Count> totals(plan.methods.size());
  fuzz(plan).counts.for_each([&](const Cell& c, const Count& count) { totals[c.method] += count; });
  for (std::size_t m = 0; m < totals.size(); ++m) {
    EXPECT_EQ(totals[m].at(Severity::plain), 0U) << plan.methods[m].name;
    EXPECT_GT(totals[m].at(Severity::boundary), 10U) << plan.methods[m].name;
    EXPECT_EQ(totals[m].unsaid(), 0U);
  }
}

TEST(Plain, NoSoundTestIsWrongThere) {
  const std::vector<Method> sound = sound_methods(Operands::triangles);
  ASSERT_GE(sound.size(), 34U);
  expect_none_plain({.methods = sound,
                     .streams = streams_of(Operands::triangles),
                     .seed = 9,
                     .cases = 240'000,
                     .threads = 2,
                     .quick = certified_class});
}

TEST(Plain, NoSoundTestOfPolygonsIsWrongThere) {
  expect_none_plain({.methods = sound_methods(Operands::polygons),
                     .streams = streams_of(Operands::polygons),
                     .seed = 9,
                     .cases = 40'000,
                     .threads = 2});
}

/// Triangles in space, as they come: none is degenerate, and rounded vertices lie next to everything.
TEST(Plain, NoSoundTestIsWrongThereOnAMesh) {
  for (const char* name : {"pig", "rotor", "triceratops"}) {
    const OwnFamily own = family_of(read_own_mesh(std::string("data/meshes/") + name + ".off"));
    std::vector<Stream> streams;
    for (const Format format : own.formats) streams.push_back({&own.family, format});
    expect_none_plain({.methods = sound_methods(Operands::triangles),
                       .streams = streams,
                       .seed = 5,
                       .cases = 60'000,
                       .threads = 2,
                       .quick = certified_class});
  }
}

/// If a method is wrong on a case of the control family `plain`, the severity is `plain`; and the family does not hug
/// the bound.
TEST(Plain, TheFamilyPlainIsPlain) {
  const Family& family = *find_family("plain");
  for (const Format format : {Format::binary64, Format::binary32}) {
    int hits = 0;
    for (std::uint64_t k = 0; k < 16'000; ++k) {
      const Trial trial = family.make(format, 3, k);
      const Truth truth = exact_truth(trial.query);
      ASSERT_EQ(severity_of(trial.query, truth), Severity::plain) << k << ", level " << trial.level;
      ASSERT_GT(clearance_of(trial.query).of_coordinates, 2 * least_clearance) << k;
      hits += truth.hit();
    }
    EXPECT_GT(hits, 4'000);
  }
}

/// Faults that do not come of rounding next to a boundary are called plain as before.
TEST(Plain, PublishedFailuresAre) {
  for (const Case& c : read_cases("data/cases/published-rivals.jsonl")) {
    const bool in_plane = c.id.starts_with("in-plane");
    EXPECT_EQ(severity(c.query), in_plane ? Severity::boundary : Severity::plain) << c.id;
  }
  const auto wrong_and_plain = [](const char* name, const Query& q) {
    const Method& m = *find_method(name);
    const Truth truth = exact_truth(q);
    return is_wrong(judge(m, truth, m.ask(q))) && severity_of(q, truth) == Severity::plain;
  };
  const Query tiny{Segment{{2e-4, 3e-4, 1e-3}, {2e-4, 3e-4, -1e-3}}, Triangle{{0, 0, 0}, {1e-3, 0, 0}, {0, 1e-3, 0}}};
  for (const char* name : {"mt-eps-float", "mt-eps-double", "mt-cull-float", "mt-cull-double"}) {
    const Query rounded{
        Segment{in_format(std::get<Segment>(tiny.probe).p, Format::binary32),
                in_format(std::get<Segment>(tiny.probe).q, Format::binary32)},
        Triangle{
            {0, 0, 0}, in_format(tiny.triangle().b, Format::binary32), in_format(tiny.triangle().c, Format::binary32)}};
    EXPECT_TRUE(wrong_and_plain(name, rounded)) << name;
  }
  const double next = 1 + 0x1p-52;
  EXPECT_TRUE(wrong_and_plain("badouel-double",
                              {Segment{{65, 8, 1}, {65, 8, -1}}, Triangle{{1, 0, 0}, {next, 1, 0}, {129, 0, 0}}}));
}

}  // namespace
}  // namespace tribunal
