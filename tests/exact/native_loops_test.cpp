// The loops that a clock runs answer as the methods do that they are loops of.
#include <gtest/gtest.h>

#include <algorithm>

#include "exact/base/json.h"
#include "exact/chart/pairs.h"
#include "exact/chart/speed.h"
#include "exact/methods/methods.h"

namespace tribunal {
namespace {

/// Pairs with coordinates that are exact in binary32, so that both formats get the same pairs.
std::vector<SegmentPair> pairs() {
  std::vector<SegmentPair> all = random_pairs(200, 50);
  const std::vector<SegmentPair> degenerate = degenerate_pairs(200, 4);
  all.insert(all.end(), degenerate.begin(), degenerate.end());
  for (SegmentPair& p : all) {
    for (Point3* v : {&p.segment.p, &p.segment.q, &p.triangle.a, &p.triangle.b, &p.triangle.c}) {
      *v = in_format(*v, Format::binary32);
    }
  }
  return all;
}

bool ask(const Method& m, const SegmentPair& p, ProbeKind kind) {
  return kind == ProbeKind::ray ? m.ray(ray_of(p), p.triangle).hit : m.segment(p.segment, p.triangle).hit;
}

std::vector<std::uint8_t> answers_of(const NativeRun& run, std::size_t n) {
  std::vector<std::uint8_t> hits(n, 9);
  run(hits, 7);
  return hits;
}

TEST(NativeLoops, AnswerAsTheMethodDoes) {
  const std::vector<SegmentPair> all = pairs();
  int batches = 0, prepared = 0;
  for (const Method& m : all_methods()) {
    for (const ProbeKind kind : {ProbeKind::segment, ProbeKind::ray}) {
      const std::string name = m.name + (kind == ProbeKind::ray ? " on rays" : "");
      const NativeLoops& native = loops_of(m, kind);
      const bool takes = kind == ProbeKind::ray ? m.contract.probes.rays : m.contract.probes.segments;
      if (m.contract.triangles == Triangles::none || !takes) continue;
      std::vector<std::uint8_t> expected;
      for (const SegmentPair& p : all) expected.push_back(ask(m, p, kind));
      EXPECT_TRUE(native.single) << name;
      EXPECT_EQ(answers_of(single_loop(m, kind)(all), all.size()), expected) << name;
      if (native.batch) {
        ++batches;
        EXPECT_EQ(answers_of(native.batch(all), all.size()), expected) << name;
      }
      if (!native.prepared) continue;
      ++prepared;
      EXPECT_EQ(answers_of(prepared_loop(m, kind)(all), all.size()), expected) << name;
      const PreparedRun run = native.prepared(all);
      run.set_up();
      EXPECT_EQ(answers_of(run.ask, all.size()), expected) << name << " prepared again";
    }
  }
  EXPECT_GT(prepared, 16);
  EXPECT_GT(batches, 3);
}

TEST(NativeLoops, EveryMethodThatPreparesTrianglesIsTimedSo) {
  for (const Method& m : all_methods()) {
    if (m.contract.triangles == Triangles::none) continue;
    EXPECT_EQ(m.native.prepared != nullptr, m.prepare_triangle != nullptr) << m.name;
    EXPECT_GT(m.native.bytes, 0U) << m.name;
    if (!m.contract.probes.rays) continue;
    EXPECT_EQ(m.native_rays.prepared != nullptr, m.prepare_triangle != nullptr) << m.name;
    EXPECT_EQ(m.native_rays.bytes, m.native.bytes) << m.name;
    EXPECT_EQ(m.native_rays.batch != nullptr, m.native.batch != nullptr) << m.name;
  }
}

TEST(PairsToTime, HitInTheirShare) {
  for (const int percent : hit_shares) {
    const std::vector<SegmentPair> some = random_pairs(400, percent);
    const auto hits = std::ranges::count_if(
        some, [](const SegmentPair& p) { return reference_method().segment(p.segment, p.triangle).hit; });
    EXPECT_EQ(hits, 4 * percent);
    const std::vector<SegmentPair> rays = random_rays(400, percent);
    EXPECT_EQ(std::ranges::count_if(
                  rays, [](const SegmentPair& p) { return reference_method().ray(ray_of(p), p.triangle).hit; }),
              4 * percent);
  }
}

TEST(Speed, HasARowForEveryCallAndForTestsThatDoNothing) {
  const std::vector<Method> methods = {*find_method("sf-filtered"), *find_method("wald-double")};
  const std::vector<SpeedRow> rows = measure_speed(methods, 9);
  std::vector<std::string> calls;
  for (const SpeedRow& r : rows) calls.push_back(r.method + " " + r.call + (r.probe == ProbeKind::ray ? " rays" : ""));
  std::vector<std::string> expected;
  for (const char* probe : {"", " rays"}) {
    for (const char* call : {"(empty loop) single", "(empty C function) single", "sf-filtered single",
                             "sf-filtered batch", "wald-double single", "wald-double batch", "wald-double prepared"}) {
      expected.push_back(std::string(call) + probe);
    }
    if (*probe == 0) expected.push_back("wald-double set-up");
  }
  EXPECT_EQ(calls, expected);
  const double nothing = rows[0].times[1].median;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    if (calls[i] == "(empty loop) single rays") continue;
    EXPECT_GT(rows[i].times[0].median, nothing) << calls[i];
  }
  for (const Json& row : to_json(rows)) EXPECT_GT(row["nanoseconds"]["median"], 0.0) << row;
}

}  // namespace
}  // namespace tribunal
