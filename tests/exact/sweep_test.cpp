// Sweeps: axes are pure functions and mean what they say, thresholds are found where they are, records do not depend on
// threads.
#include "exact/sweep/sweep.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <set>

#include "exact/base/json.h"
#include "exact/cases/case_io.h"
#include "exact/kernels/rational_kernel.h"
#include "exact/methods/methods.h"
#include "exact/sweep/map.h"
#include "exact/sweep/record.h"
#include "exact/sweep/thresholds.h"
#include "tests/tracer/support.h"

namespace tribunal {
namespace {

using testing::method;

constexpr Format formats[] = {Format::binary32, Format::binary64};

std::string line_of(const Trial& trial) { return from_case({.format = trial.format, .query = trial.query}).dump(); }

std::vector<Point3> points_of(const Query& query) {
  std::vector<Point3> points;
  if (query.operands() == Operands::polygons) {
    points = query.polygon().vertices;
  } else {
    points = {query.triangle().a, query.triangle().b, query.triangle().c};
  }
  if (const auto* s = std::get_if<Segment>(&query.probe)) {
    points.insert(points.end(), {s->p, s->q});
  } else {
    points.push_back(std::get<Ray>(query.probe).o);
  }
  return points;
}

/// Calls visit(axis, format, value).
template <class Visit>
void for_each_value(const Visit& visit) {
  for (const StressAxis& axis : all_stress_axes()) {
    for (const Format format : formats) {
      for (const int value : axis.values(format)) visit(axis, format, value);
    }
  }
}

TEST(Axes, NamesAreDistinctAndValuesAscend) {
  std::set<std::string_view> names;
  for (const StressAxis& axis : all_stress_axes()) {
    EXPECT_TRUE(names.insert(axis.name).second) << axis.name;
    for (const Format format : formats) {
      const auto values = axis.values(format);
      EXPECT_TRUE(std::ranges::is_sorted(values, std::ranges::less_equal{})) << axis.name;
      EXPECT_EQ(std::ranges::count(values, axis.easiest(format)), 1) << axis.name;
    }
  }
}

TEST(Axes, ACaseIsAPureFunctionOfSeedValueAndNumber) {
  for_each_value([](const StressAxis& axis, Format format, int value) {
    for (const std::uint64_t k : {0, 1, 327}) {
      const std::string first = line_of(case_at(axis, format, 5, value, k));
      case_at(axis, format, 5, value, k + 1);
      EXPECT_EQ(line_of(case_at(axis, format, 5, value, k)), first) << axis.name << " " << value;
      EXPECT_NE(line_of(case_at(axis, format, 6, value, k + 700)), first);
    }
  });
}

/// Small maps have few images; everything else draws from far more cases than this.
TEST(Axes, CasesAreDistinct) {
  for_each_value([](const StressAxis& axis, Format format, int value) {
    std::set<std::string> lines;
    for (std::uint64_t k = 0; k < 100; ++k) lines.insert(line_of(case_at(axis, format, 1, value, k)));
    EXPECT_GE(lines.size(), 85u) << axis.name << " " << name_of(format) << " " << value;
  });
}

TEST(Axes, CoordinatesAreFiniteAndExactInTheFormat) {
  for_each_value([](const StressAxis& axis, Format format, int value) {
    for (std::uint64_t k = 0; k < 400; ++k) {
      const Query query = case_at(axis, format, 3, value, k).query;
      ASSERT_TRUE(is_finite(query)) << axis.name << " " << value << " case " << k;
      for (const Point3& p : points_of(query)) ASSERT_TRUE(is_exact_in(p, format)) << axis.name << " " << value;
      if (const auto* r = std::get_if<Ray>(&query.probe)) {
        ASSERT_TRUE(is_exact_in(r->d.v, format)) << axis.name;
      }
    }
  });
}

TEST(Axes, BothKindsOfProbeAreAskedUnlessTheAxisIsOfRays) {
  for_each_value([](const StressAxis& axis, Format format, int value) {
    int rays = 0;
    for (std::uint64_t k = 0; k < 328; ++k) rays += is_of_ray(case_at(axis, format, 1, value, k).query);
    if (axis.has_segments()) {
      EXPECT_NEAR(rays, 164, 4) << axis.name;
    } else {
      EXPECT_EQ(rays, 328) << axis.name;
    }
  });
}

TEST(Axes, WhatACaseKnowsByConstructionIsTrue) {
  for_each_value([](const StressAxis& axis, Format format, int value) {
    for (std::uint64_t k = 0; k < 328; k += 13) {
      const Trial trial = case_at(axis, format, 2, value, k);
      if (trial.class_id != 0) {
        ASSERT_EQ(trial.class_id, certified_class(trial.query)) << axis.name << " " << value;
      }
    }
  });
}

// --- what a value means, measured -----------------------------------------------------------------------------------

double largest(const std::vector<Point3>& points) {
  double size = 0;
  for (const Point3& p : points) size = std::max({size, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
  return size;
}

/// Zeros stand for themselves: the same classes have them at every value.
double log_of(double x) { return x == 0 ? 0 : std::log2(x); }

/// The largest coordinate of a difference of two points.
double extent(const std::vector<Point3>& points) {
  std::vector<Point3> differences;
  for (const Point3& p : points) differences.push_back(p - points[0]);
  return largest(differences);
}

double height_over_length(const Triangle& t) {
  const Point3 u = t.b - t.a, v = t.c - t.a, w = t.c - t.b;
  const double x = u.y * v.z - u.z * v.y, y = u.z * v.x - u.x * v.z, z = u.x * v.y - u.y * v.x;
  const auto square = [](const Point3& p) { return p.x * p.x + p.y * p.y + p.z * p.z; };
  return std::sqrt(x * x + y * y + z * z) / std::max({square(u), square(v), square(w)});
}

Point3 along(const Query& query) {
  if (const auto* s = std::get_if<Segment>(&query.probe)) return s->q - s->p;
  return std::get<Ray>(query.probe).d.v;
}

/// The measured quantity of one case, in the axis's own unit.
double measured(const std::string_view axis, const Query& query) {
  const std::vector<Point3> points = points_of(query);
  if (axis == "scale" || axis == "polygon-scale" || axis == "offset") return log_of(largest(points));
  if (axis == "distance") return log_of(largest({along(query)}));
  if (axis == "direction") return log_of(largest({along(query)})) - log_of(largest(points));
  if (axis == "vertices") return static_cast<double>(query.polygon().vertices.size());
  if (axis == "sliver") return -log_of(height_over_length(query.triangle()));
  if (axis == "fill" || axis == "polygon-fill") return log_of(extent(points));
  return 0;
}

double mean_measured(const StressAxis& axis, Format format, int value) {
  double sum = 0;
  constexpr int n = 656;
  for (std::uint64_t k = 0; k < n; ++k) sum += measured(axis.name, case_at(axis, format, 1, value, k).query);
  return sum / n;
}

/// The means rise with the value, as far as the format can tell.
void expect_rising(const char* name, int lo, int hi) {
  const StressAxis& axis = *find_stress_axis(name);
  for (const Format format : formats) {
    double before = -1e9;
    for (const int value : axis.values(format)) {
      if (value < lo || value > hi) continue;
      const double mean = mean_measured(axis, format, value);
      EXPECT_GT(mean, before) << name << " " << name_of(format) << " " << value;
      before = mean;
    }
  }
}

TEST(Axes, AValueMeansWhatTheAxisSays) {
  expect_rising("scale", -2000, 2000);
  expect_rising("polygon-scale", -2000, 2000);
  expect_rising("offset", 5, 2000);
  expect_rising("distance", -18, 2000);
  expect_rising("direction", -2000, 2000);
  expect_rising("vertices", 0, 2000);
  expect_rising("sliver", 0, 20);
  expect_rising("fill", 0, 2000);
  expect_rising("polygon-fill", 0, 2000);
}

TEST(Axes, ScaleIsExact) {
  const StressAxis& axis = *find_stress_axis("scale");
  for (const Format format : formats) {
    for (const int value : axis.values(format)) {
      for (std::uint64_t k = 0; k < 328; ++k) {
        const double size = largest(points_of(case_at(axis, format, 1, value, k).query));
        EXPECT_LE(size, std::ldexp(7.0, value));
        EXPECT_EQ(std::ldexp(size, -value), std::rint(std::ldexp(size, -value)));
      }
    }
  }
}

/// Two values of the scale have the same maps only by chance, which entries in {-1, 0, 1} make small.
TEST(Axes, NoTwoValuesShareTheirDraws) {
  const StressAxis& axis = *find_stress_axis("scale");
  const auto vertex_at = [&](int value, std::uint64_t k) {
    const Point3 a = case_at(axis, Format::binary64, 1, value, k).query.triangle().a;
    return Point3{std::ldexp(a.x, -value), std::ldexp(a.y, -value), std::ldexp(a.z, -value)};
  };
  int same = 0;
  for (std::uint64_t k = 0; k < 328; ++k) same += vertex_at(100, k) == vertex_at(200, k);
  EXPECT_LT(same, 164);
}

// --- thresholds -----------------------------------------------------------------------------------------------------

/// The reference, which answers the opposite where the first vertex is farther than 2^25.5 from the origin.
Method failing_far_away() {
  const Method& right = reference_method();
  const auto turn = [](Answer a, const Triangle& t) {
    if (std::fabs(t.a.x) > 0x1.7p25) a.hit = !a.hit;
    return a;
  };
  Method m{.name = "planted-far", .contract = right.contract};
  m.contract.polygons = Polygons::none;
  m.segment = [&right, turn](const Segment& s, const Triangle& t) { return turn(right.segment(s, t), t); };
  m.ray = [&right, turn](const Ray& r, const Triangle& t) { return turn(right.ray(r, t), t); };
  return m;
}

SweepPlan plan_of(std::vector<Method> methods, const char* axis, std::uint64_t cases, unsigned threads = 2) {
  return {
      .methods = std::move(methods), .axes = {find_stress_axis(axis)}, .seed = 3, .cases = cases, .threads = threads};
}

TEST(Thresholds, AMethodThatFailsFromAKnownValueOnIsFoundThere) {
  const SweepPlan plan = plan_of({failing_far_away()}, "offset", 328);
  const Sweep result = sweep(plan);
  std::vector<Threshold> rows = thresholds_of(plan, result);
  std::erase_if(rows, [](const Threshold& t) { return t.format == Format::binary32; });
  ASSERT_EQ(rows.size(), 4u) << "false hits and false misses of segments and of rays";
  for (const Threshold& t : rows) {
    ASSERT_TRUE(t.before && t.all);
    EXPECT_EQ(t.before->value, 24);
    EXPECT_EQ(t.first.value, 26);
    EXPECT_EQ(t.all->value, 26);
    EXPECT_EQ(t.first.failures, t.first.chances);
  }
  for (const WitnessedThreshold& w : with_witnesses(plan, result, rows)) {
    EXPECT_GT(std::fabs(w.witness.query.triangle().a.x), 0x1.7p25) << "shrunk, and still wrong";
    EXPECT_EQ(w.witness.finding["origin"]["value"], 26);
  }
  for (const auto& [place, count] : result.counts) {
    if (place.format == Format::binary32) {
      EXPECT_EQ(count.count.wrong, 0u) << place.value;
    }
  }
}

TEST(Thresholds, NaiveDoubleLosesTheFirstHitToUnderflowBelowMinus358) {
  const SweepPlan plan = plan_of({method("sf-double")}, "scale", 656);
  const Sweep result = sweep(plan);
  for (const Threshold& t : thresholds_of(plan, result)) {
    if (t.format == Format::binary32 || t.side == AxisSide::up) continue;
    ASSERT_TRUE(t.before);
    EXPECT_LE(t.first.value, -358) << "docs: none wrong at 2^-358 on small integers";
    EXPECT_GE(t.first.value, -400);
  }
}

TEST(Thresholds, ValuesRunOutwardFromTheEasiest) {
  const StressAxis& scale = *find_stress_axis("scale");
  EXPECT_EQ(values_outward(scale, Format::binary64, AxisSide::up).front(), 0);
  EXPECT_EQ(values_outward(scale, Format::binary64, AxisSide::down).front(), 0);
  EXPECT_EQ(values_outward(scale, Format::binary64, AxisSide::down).back(), -1074);
  EXPECT_TRUE(values_outward(*find_stress_axis("fill"), Format::binary64, AxisSide::down).empty());
  EXPECT_TRUE(values_outward(*find_stress_axis("ulps"), Format::binary64, AxisSide::up).empty());
  EXPECT_EQ(values_outward(*find_stress_axis("ulps"), Format::binary64, AxisSide::down).back(), 0);
}

TEST(Sweeps, TheRecordDoesNotDependOnThreads) {
  const auto text_with = [](unsigned threads) {
    const SweepPlan plan = plan_of({method("sf-float"), method("mt-double")}, "fill", 328, threads);
    const Sweep result = sweep(plan);
    return to_json_text(plan, result, with_witnesses(plan, result, thresholds_of(plan, result))) + to_csv(plan, result);
  };
  const std::string one = text_with(1);
  EXPECT_EQ(one, text_with(3));
  EXPECT_TRUE(Json::accept(one.substr(0, one.rfind('}') + 1)));
}

TEST(Sweeps, EveryAnswerIsCountedOnceAndChancesAddUp) {
  const SweepPlan plan = plan_of({method("sf-double"), method("haines-double")}, "polygon-fill", 200);
  for (const auto& [place, c] : sweep(plan).counts) {
    EXPECT_EQ(c.chances(SweptOutcome::false_hit) + c.chances(SweptOutcome::false_miss), c.count.judged());
    for (const SweptOutcome o : swept_outcomes) EXPECT_LE(c.failures(o), c.chances(o));
    EXPECT_EQ(c.count.asked, 100u) << "half of 200 are segments";
  }
}

// --- failure maps ---------------------------------------------------------------------------------------------------

constexpr ProbeKind probe_kinds[] = {ProbeKind::segment, ProbeKind::ray};

TEST(FailureMaps, TheMiddleIsTheContactThatTheMapIsNamedFor) {
  for (const Format format : formats) {
    for (const ProbeKind probe : probe_kinds) {
      const auto middle_of = [&](const char* map) {
        return exact_truth(query_of_pixel({find_map_contact(map), probe}, format, 128, 128)).contact;
      };
      EXPECT_EQ(middle_of("edge"), Contact::edge);
      EXPECT_EQ(middle_of("vertex"), Contact::vertex);
      EXPECT_EQ(middle_of("plane"), Contact::coplanar);
      EXPECT_EQ(middle_of("end"), Contact::interior);
    }
  }
}

TEST(FailureMaps, EveryPixelIsAnotherCaseExactInItsFormat) {
  for (const MapContact& contact : all_map_contacts()) {
    for (const Format format : formats) {
      std::set<std::string> lines;
      for (const ProbeKind probe : probe_kinds) {
        for (int y = 0; y < 256; y += 15) {
          for (int x = 0; x < 256; x += 15) {
            const Query query = query_of_pixel({&contact, probe}, format, x, y);
            for (const Point3& p : points_of(query)) ASSERT_TRUE(is_exact_in(p, format)) << contact.name;
            if (probe == ProbeKind::ray) {
              ASSERT_TRUE(is_exact_in(std::get<Ray>(query.probe).d.v, format)) << contact.name;
            }
            lines.insert(line_of({.query = query, .format = format}));
          }
        }
      }
      EXPECT_EQ(lines.size(), 2 * 18u * 18u);
    }
  }
}

/// Below the diagonal, and on it: by the sign of x − y alone. So it is of a ray, whose direction has x = y.
TEST(FailureMaps, TheTruthOfAnEdgeIsADiagonal) {
  for (const ProbeKind probe : probe_kinds) {
    const MapPlan plan{.methods = {method("sf-filtered"), method("mt-double")},
                       .map = {find_map_contact("edge"), probe, 64},
                       .threads = 2};
    const FailureMap map = failure_map(plan);
    for (std::size_t y = 0; y < 64; ++y) {
      for (std::size_t x = 0; x < 64; ++x) EXPECT_EQ(map.truth.at(Format::binary64)[y][x] == 'h', x >= y);
    }
    EXPECT_EQ(map.panels[0].counts, (std::map<Outcome, std::uint64_t>{{Outcome::right, 4096}}));
    EXPECT_GT(map.panels[1].counts.at(Outcome::false_hit), 0u);
    MapPlan other = plan;
    other.threads = 3;
    EXPECT_EQ(to_json_text(plan, map), to_json_text(other, failure_map(other)));
  }
}

}  // namespace
}  // namespace tribunal
