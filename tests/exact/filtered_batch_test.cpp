// The batch against the single test, on every target of this machine.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "exact/cases/families/draw.h"
#include "exact/cases/family_table.h"
#include "exact/filtered/batch.h"
#include "exact/filtered/filtered.h"
#include "exact/methods/methods.h"

namespace tribunal {

namespace {

/// A table that owns its columns.
struct Table {
  std::vector<double> x, y, z;

  void add(const Point3& p) {
    x.push_back(p.x);
    y.push_back(p.y);
    z.push_back(p.z);
  }
  PointColumns columns() const { return {x, y, z}; }
};

/// Source and target; a ray's direction is taken for a point, and back again for the ray that is asked.
Segment ends_of(const Probe& probe) {
  if (const auto* r = std::get_if<Ray>(&probe)) return {r->o, r->d.v};
  return std::get<Segment>(probe);
}

struct Corpus {
  std::vector<TrianglePair> segments, rays;
  Table p, q, d, a, b, c;

  void add(const Segment& s, const Triangle& t) {
    const Direction direction{s.q};
    segments.push_back({s, t});
    rays.push_back({Ray{s.p, direction}, t});
    p.add(s.p), q.add(s.q), d.add(direction.v), a.add(t.a), b.add(t.b), c.add(t.c);
  }
  TriangleColumns triangles() const { return {a.columns(), b.columns(), c.columns()}; }
};

Point3 draw_any(Draw& draw) {
  constexpr double ends[] = {std::numeric_limits<double>::max(), 0x1p-1074, -0x1p-1022, 0, 1, -1, 0x1p200, 0x1p-200};
  Point3 p;
  for (int i = 0; i < 3; ++i) p[i] = ends[draw.below(8)];
  return p;
}

/// Cases of all families, random points, and coordinates from the ends of the range. Their number is no multiple of
/// any number of lanes.
const Corpus& corpus() {
  static const Corpus made = [] {
    Corpus c;
    for (const Family& family : families_of(Operands::triangles)) {
      for (const Format format : {Format::binary32, Format::binary64}) {
        for (std::uint64_t k = 0; k < 500; ++k) {
          const Query q = family.make(format, 14, k).query;
          c.add(ends_of(q.probe), q.triangle());
        }
      }
    }
    for (std::uint64_t k = 0; k < 2003; ++k) {
      Draw draw(82, 1, k);
      Point3 v[5];
      for (Point3& p : v) {
        if (k % 2 == 0) {
          p = draw_any(draw);
        } else {
          for (int i = 0; i < 3; ++i) p[i] = std::ldexp(static_cast<double>(draw.next() >> 11), -53);
        }
      }
      c.add({v[0], v[1]}, {v[2], v[3], v[4]});
    }
    return c;
  }();
  return made;
}

/// The tests run once for each instruction set of this machine.
class Batch : public testing::TestWithParam<std::string_view> {
 protected:
  void SetUp() override { force_batch_target(GetParam()); }
  void TearDown() override { force_batch_target(""); }
};

std::uint64_t total(const Tally& t) { return t[Stage::filter] + t[Stage::integers] + t[Stage::exact]; }

TEST_P(Batch, AnswersEachPairAsTheSingleTestDoes) {
  const Corpus& c = corpus();
  const std::size_t n = c.segments.size();
  std::vector<std::uint8_t> by_segment(n, 9), by_ray(n, 9);
  const Tally segments = hits(SegmentColumns{c.p.columns(), c.q.columns()}, c.triangles(), by_segment);
  const Tally rays = hits(RayColumns{c.p.columns(), c.d.columns()}, c.triangles(), by_ray);
  for (std::size_t i = 0; i < n; ++i) {
    ASSERT_EQ(by_segment[i], intersect(c.segments[i]).hit) << i;
    ASSERT_EQ(by_ray[i], intersect(c.rays[i]).hit) << i;
  }
  for (const Tally& tally : {segments, rays}) {
    EXPECT_EQ(total(tally), n);
    for (const Stage s : deciding_stages) EXPECT_GT(tally[s], 0U) << name_of(s);
  }
}

TEST_P(Batch, AnswersOneAgainstManyAsTheSingleTestDoes) {
  const Corpus& c = corpus();
  std::vector<std::uint8_t> hit(c.segments.size());
  for (std::size_t k = 0; k < c.segments.size(); k += 2999) {
    const Segment s = std::get<Segment>(c.segments[k].probe);
    const Ray r = std::get<Ray>(c.rays[k].probe);
    hits(s, c.triangles(), hit);
    for (std::size_t i = 0; i < hit.size(); ++i) ASSERT_EQ(hit[i], hits(s, c.segments[i].triangle)) << k << " " << i;
    hits(r, c.triangles(), hit);
    for (std::size_t i = 0; i < hit.size(); ++i) ASSERT_EQ(hit[i], hits(r, c.segments[i].triangle)) << k << " " << i;
  }
}

TEST_P(Batch, AnswersQueriesAsTheMethodDoes) {
  const Method& method = *find_method("sf-filtered");
  std::vector<TrianglePair> mixed;
  for (std::size_t i = 0; i < corpus().segments.size(); ++i) {
    mixed.push_back(i % 3 == 0 ? corpus().rays[i] : corpus().segments[i]);
  }
  std::vector<Answer> answers(mixed.size());
  method.batch(mixed, answers);
  for (std::size_t i = 0; i < mixed.size(); ++i) {
    const Answer single = method.ask(as_query(mixed[i]));
    Answer batched = answers[i];
    if (batched.stage == Stage::filter) batched.facing = single.facing;  // the lanes do not tell the side
    if (batched.stage == Stage::filter || single.stage == Stage::filter) batched.stage = single.stage;
    ASSERT_EQ(batched, single) << i;
  }
}

/// Every length up to several vectors, and the sizes around a block.
TEST_P(Batch, HandlesEveryLength) {
  const Corpus& c = corpus();
  const auto first = [](const PointColumns& p, std::size_t n) {
    return PointColumns{p.x.first(n), p.y.first(n), p.z.first(n)};
  };
  std::vector<std::size_t> lengths{511, 512, 513, 1024, 1031};
  for (std::size_t n = 0; n < 40; ++n) lengths.push_back(n);
  for (const std::size_t n : lengths) {
    std::vector<std::uint8_t> hit(n + 16, 7);
    const TriangleColumns t{first(c.a.columns(), n), first(c.b.columns(), n), first(c.c.columns(), n)};
    const SegmentColumns s{first(c.p.columns(), n), first(c.q.columns(), n)};
    EXPECT_EQ(total(hits(s, t, std::span(hit).first(n))), n);
    for (std::size_t i = 0; i < n; ++i) ASSERT_EQ(hit[i], intersect(c.segments[i]).hit) << n << " " << i;
    for (std::size_t i = n; i < hit.size(); ++i) ASSERT_EQ(hit[i], 7) << "wrote past the end";
  }
}

/// A NaN or an infinity in any coordinate of any vertex, in any lane, next to sound pairs that hit.
TEST_P(Batch, SaysNothingOfNonFiniteOperands) {
  const double bad[] = {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()};
  const TrianglePair sound{Segment{{1, 1, -1}, {1, 1, 1}}, {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}};
  for (int spoilt = 0; spoilt < 2 * 15 * 2; ++spoilt) {
    const auto spoil = [&](Point3(&v)[5]) { v[spoilt / 2 % 5][spoilt / 10 % 3] = bad[spoilt / 30]; };
    std::vector<TrianglePair> queries(24, sound);
    for (std::size_t i = 0; i < queries.size(); i += 3) {
      Point3 v[5] = {{1, 1, -1}, {1, 1, 1}, {0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
      spoil(v);
      const Triangle t{v[2], v[3], v[4]};
      if (spoilt % 2 == 0) {
        queries[i] = {Segment{v[0], v[1]}, t};
      } else {
        queries[i] = {Ray{v[0], {v[1]}}, t};
      }
    }
    std::vector<Answer> answers(queries.size());
    intersect(queries, answers);
    for (std::size_t i = 0; i < queries.size(); ++i) {
      ASSERT_EQ(answers[i], i % 3 == 0 ? refusal(Status::nonfinite) : certain(true)) << spoilt << " " << i;
    }
  }
}

/// The rounding mode and flush-to-zero of the caller make no difference: all bits of MXCSR that could.
TEST_P(Batch, ForeignEnvironmentsChangeNoAnswer) {
  const Corpus& c = corpus();
  std::vector<std::uint8_t> expected(c.segments.size()), hit(c.segments.size());
  hits(SegmentColumns{c.p.columns(), c.q.columns()}, c.triangles(), expected);
  for (const unsigned bits : {0x2000U, 0x4000U, 0x6000U, 0x8040U, 0xe040U}) {
    const unsigned own = __builtin_ia32_stmxcsr();
    __builtin_ia32_ldmxcsr((own & ~0xe040U) | bits);
    hits(SegmentColumns{c.p.columns(), c.q.columns()}, c.triangles(), hit);
    __builtin_ia32_ldmxcsr(own);
    ASSERT_EQ(hit, expected) << std::hex << bits;
  }
}

INSTANTIATE_TEST_SUITE_P(Targets, Batch, testing::ValuesIn(batch_targets()), [](const auto& tested) {
  std::string name(tested.param);
  name.erase(std::remove(name.begin(), name.end(), '-'), name.end());
  return name;
});

TEST(BatchLaws, RefusesColumnsOfDifferentLengths) {
  const Corpus& c = corpus();
  std::vector<std::uint8_t> hit(c.segments.size() - 1);
  EXPECT_THROW(hits(Segment{}, c.triangles(), hit), std::invalid_argument);
  EXPECT_THROW(force_batch_target("abacus"), std::invalid_argument);
}

}  // namespace
}  // namespace tribunal
