// Shrinking: 2,100 counterexamples, each of which must be its own fixed point and the same counterexample.
#include "exact/shrink/shrink.h"

#include <gtest/gtest.h>

#include "exact/cases/case_io.h"
#include "exact/methods/methods.h"
#include "exact/shrink/coordinate_rules.h"
#include "exact/trial/fuzz.h"

namespace tribunal {
namespace {

Method method(const char* name) { return *find_method(name); }

/// A method that is wrong if the x of the probe's source has an odd number of significant bits: a bug that no rule of
/// the shrinker is made for.
Method capricious() {
  Method m = method("sf-filtered");
  m.name = "capricious";
  m.batch = {};
  const auto spoil = [](double x, Answer answer) {
    answer.hit ^= significand_bits(x) % 2 == 1;
    return answer;
  };
  m.segment = [spoil](const Segment& s, const Triangle& t) {
    return spoil(s.p.x, method("sf-filtered").segment(s, t));
  };
  m.ray = [spoil](const Ray& r, const Triangle& t) { return spoil(r.o.x, method("sf-filtered").ray(r, t)); };
  return m;
}

/// A method that takes the ray o + t·d for the segment from o to o + d.
Method rays_are_segments() {
  Method m = method("sf-rational");
  m.name = "rays-are-segments";
  m.ray = [](const Ray& r, const Triangle& t) { return method("sf-rational").segment(Segment{r.o, r.o + r.d.v}, t); };
  return m;
}

std::string text_of(const Query& query) { return from_case(Case{.query = query}).dump(); }

bool is_same_case(const Truth& a, const Truth& b) {
  return a.class_id == b.class_id && a.contact == b.contact && a.planar == b.planar;
}

void expect_fixed_point(const Method& m, const Query& query, const Truth& truth, Format format) {
  const Query small = shrink(m, query, format);
  const Truth after = exact_truth(small);
  EXPECT_TRUE(is_same_case(after, truth)) << m.name << " " << text_of(query);
  EXPECT_TRUE(is_wrong(judge(m, after, m.ask(small)))) << m.name << " " << text_of(query);
  EXPECT_FALSE(is_simpler(query, small));
  EXPECT_EQ(text_of(shrink(m, small, format)), text_of(small)) << m.name << " from " << text_of(query);
}

/// Wrong answers of the method, up to `most`, by case number over all streams in turn; every second segment of a
/// triangle case is asked as a ray with the same coordinates.
int shrink_many(const Method& m, const std::vector<Stream>& streams, int most, std::uint64_t end) {
  int found = 0;
  for (std::uint64_t k = 0; k < end && found < most; ++k) {
    const auto& stream = streams[k % streams.size()];
    if (!takes(m, stream.format)) continue;
    auto query = stream.family->make(stream.format, 11, k).query;
    if (const auto* s = std::get_if<Segment>(&query.probe); s != nullptr && k / streams.size() % 2 == 1) {
      const Ray ray{s->p, {s->q}};
      query.probe = ray;
    }
    const auto truth = exact_truth(query);
    if (!is_wrong(judge(m, truth, m.ask(query)))) continue;
    ++found;
    expect_fixed_point(m, query, truth, stream.format);
  }
  return found;
}

TEST(Shrinking, EveryResultIsItsOwnFixedPoint) {
  int total = 0;
  for (const Method& m : {method("sf-float"), method("sf-double"), method("mt-double"), method("sf-double-eps"),
                          capricious(), rays_are_segments()}) {
    const int found = shrink_many(m, streams_of(Operands::triangles), 300, 400'000);
    EXPECT_EQ(found, 300) << m.name;
    total += found;
  }
  EXPECT_EQ(total, 1800);
}

TEST(Shrinking, EveryPolygonIsItsOwnFixedPoint) {
  int total = 0;
  for (const char* name : {"haines-double", "feito-double", "sf-double"}) {
    const int found = shrink_many(method(name), streams_of(Operands::polygons), 100, 40'000);
    EXPECT_EQ(found, 100) << name;
    total += found;
  }
  EXPECT_EQ(total, 300);
}

}  // namespace
}  // namespace tribunal
