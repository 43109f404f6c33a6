// Cases made from the user's own data: what is drawn, and what it finds that no shipped family does.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <fstream>
#include <limits>
#include <map>
#include <set>
#include <vector>

#include "exact/base/failure.h"
#include "exact/base/sha256.h"
#include "exact/cases/own/family.h"
#include "exact/cases/own/mutate.h"
#include "exact/cases/own/parts.h"
#include "exact/methods/methods.h"
#include "exact/trial/fuzz.h"

namespace tribunal {
namespace {

constexpr std::uint64_t seed = 11;

/// A wall of 6 × 6 m, a survey's coordinates away from the origin, and a probe that passes through it.
const Triangle wall{{4321.125, -1234.5, 560}, {4327.125, -1234.5, 560}, {4321.125, -1234.5, 566}};
const Query through_wall{Segment{{4323, -1230, 562}, {4322, -1238.5, 561}}, wall};
const Query ray_at_wall{Ray{{4323, -1230, 562}, {{0.25, -1, 0.125}}}, wall};

Query ring() {
  PolygonData polygon;
  polygon.add(std::vector<Point3>{{0, 0, 7}, {12.5, 0, 7}, {12.5, 8.25, 7}, {0, 8.25, 7}});
  polygon.add(std::vector<Point3>{{3, 3, 7}, {6, 3, 7}, {3, 5, 7}});
  return {Segment{{1, 1, 9}, {2, 3, -1}}, polygon};
}

OwnData cases_of(std::vector<OwnQuery> queries) {
  return {.kind = OwnKind::cases, .file = "f", .queries = std::move(queries)};
}

/// So many queries about walls, no two alike.
OwnData street(std::size_t n) {
  std::vector<OwnQuery> queries;
  for (std::size_t i = 0; i < n; ++i) {
    Query q = i % 2 == 0 ? through_wall : ray_at_wall;
    for (Point3* v : Parts(q).points()) v->x += 6.0 * static_cast<double>(i);
    queries.push_back({q, Format::binary64});
  }
  return cases_of(std::move(queries));
}

OwnData mesh_of_walls(std::size_t n) {
  OwnData data{.kind = OwnKind::mesh, .file = "m"};
  for (const OwnQuery& q : street(n).queries) data.triangles.push_back(q.query.triangle());
  return data;
}

std::vector<double> numbers_of(Query query) {
  std::vector<double> numbers;
  for (const Point3* v : Parts(query).vectors()) numbers.insert(numbers.end(), {v->x, v->y, v->z});
  return numbers;
}

/// −0 and 0 are different cases of the same answer.
std::vector<double> with_signs(std::vector<double> numbers) {
  for (std::size_t i = 0, n = numbers.size(); i < n; ++i) numbers.push_back(std::signbit(numbers[i]) ? 1 : 0);
  return numbers;
}

std::vector<Stream> streams_in(const OwnFamily& own) {
  std::vector<Stream> streams;
  for (const Format format : own.formats) streams.push_back({&own.family, format});
  return streams;
}

std::vector<OwnData> all_kinds() {
  OwnData scene = street(40);
  scene.kind = OwnKind::scene;
  return {street(40),        street(1), cases_of({{ring(), Format::binary64}}),
          mesh_of_walls(40), scene,     cases_of({{through_wall, Format::binary32}})};
}

TEST(OwnFamily, CasesAreFiniteFitTheirFormatAndAreAFunctionOfTheirNumber) {
  for (const OwnData& data : all_kinds()) {
    const OwnFamily own = family_of(data), again = family_of(data);
    for (const Format format : own.formats) {
      for (std::uint64_t k = 0; k < 5'000; ++k) {
        const Trial trial = own.family.make(format, seed, k);
        ASSERT_TRUE(is_finite(trial.query)) << own.family.name << " " << k;
        ASSERT_EQ(trial.format, format);
        const std::vector<double> numbers = numbers_of(trial.query);
        ASSERT_TRUE(std::ranges::all_of(numbers, [&](double x) { return is_exact_in(x, format); }));
        ASSERT_EQ(numbers, numbers_of(again.family.make(format, seed, k).query));
        ASSERT_LT(trial.level, own.family.levels(format).size());
      }
    }
  }
}

TEST(OwnFamily, HardlyEverRepeatsACase) {
  constexpr std::size_t n = 4'800;
  for (const OwnData& data : all_kinds()) {
    const OwnFamily own = family_of(data);
    for (const Format format : own.formats) {
      std::set<std::vector<double>> cases;
      for (std::uint64_t k = 0; k < n; ++k) {
        cases.insert(with_signs(numbers_of(own.family.make(format, seed, k).query)));
      }
      EXPECT_GE(cases.size(), n * 98 / 100) << own.family.name << " of " << own.family.data->items;
    }
  }
}

TEST(OwnFamily, AsksEachCaseAsItStandsInTurnWithChangedOnes) {
  const OwnData data = street(40);
  const OwnFamily own = family_of(data);
  for (std::uint64_t k = 0; k < 200; ++k) {
    const Trial trial = own.family.make(Format::binary64, seed, k);
    const bool as_it_stands = k % 2 == 0 && k < 80;
    EXPECT_EQ(trial.level == 0, as_it_stands) << k;
    if (as_it_stands) {
      EXPECT_EQ(numbers_of(trial.query), numbers_of(data.queries[k / 2].query));
    }
  }
}

/// Probes stay what they are; at triangles without probes, both kinds are aimed.
TEST(OwnFamily, AsksSegmentsAndRaysAtEveryLevelWithBothAnswers) {
  for (const OwnData& data : {street(40), mesh_of_walls(40)}) {
    const OwnFamily own = family_of(data);
    for (const Format format : own.formats) {
      std::map<std::pair<bool, int>, int> hits, misses;
      for (std::uint64_t k = 80; k < 6'000; ++k) {
        const Trial trial = own.family.make(format, seed, k);
        auto& counts = flagship_method().ask(trial.query).hit ? hits : misses;
        ++counts[{is_of_ray(trial.query), trial.level}];
      }
      for (const bool ray : {false, true}) {
        for (const int level : {1, 2, 3, 4, 5}) {
          EXPECT_GT((hits[{ray, level}]), 50) << own.family.name << " level " << level;
          EXPECT_GT((misses[{ray, level}]), 50) << own.family.name << " level " << level;
        }
      }
    }
  }
}

/// Cases of binary32 are asked in binary32 alone; those of binary64 in both, where they fit.
TEST(OwnFamily, KeepsToTheFormatsOfItsData) {
  EXPECT_EQ(family_of(cases_of({{through_wall, Format::binary32}})).formats, std::vector{Format::binary32});
  Query far = through_wall;
  far.triangle().a.x = 1e300;
  EXPECT_EQ(family_of(cases_of({{far, Format::binary64}})).formats, std::vector{Format::binary64});
  const OwnFamily both = family_of(cases_of({{far, Format::binary64}, {through_wall, Format::binary64}}));
  EXPECT_EQ(both.formats.size(), 2u);
  EXPECT_EQ(both.family.data->left_out, "1 in binary32, beyond its range");
}

/// A ray's bounds are numbers of the case as well: exact in its format, in order, changed like the others, and aimed at
/// where the ray hits. Where they are the only thing that changes, the hash of the numbers does.
TEST(OwnFamily, BoundsOfRaysAreNumbersOfTheCase) {
  Query bounded = ray_at_wall;
  bounded.bounds = Bounds{0.1, 4.7};
  const OwnFamily own = family_of(cases_of({{bounded, Format::binary64}}));
  for (const Format format : own.formats) {
    std::set<double> least, largest;
    int at_an_end = 0;
    for (std::uint64_t k = 0; k < 2'000; ++k) {
      const Query query = own.family.make(format, seed, k).query;
      ASSERT_TRUE(query.bounds && is_finite(query));
      const auto [tmin, tmax] = *query.bounds;
      ASSERT_TRUE(is_exact_in(tmin, format) && is_exact_in(tmax, format)) << k;
      ASSERT_TRUE(tmin >= 0 && tmin <= tmax) << k;
      least.insert(tmin);
      largest.insert(tmax);
      const At at = flagship_method().ask(query).at;
      at_an_end += at == At::source || at == At::target;
    }
    EXPECT_GT(least.size(), 100u);
    EXPECT_GT(largest.size(), 100u);
    EXPECT_GT(at_an_end, 50);
  }
  Query other = bounded;
  other.bounds->tmax = 4.75;
  EXPECT_NE(family_of(cases_of({{other, Format::binary64}})).family.data->numbers_sha256,
            own.family.data->numbers_sha256);
  Query endless = bounded;
  endless.bounds->tmax = std::numeric_limits<double>::infinity();
  const OwnFamily of_endless = family_of(cases_of({{endless, Format::binary64}}));
  for (std::uint64_t k = 0; k < 500; ++k)
    ASSERT_TRUE(is_finite(of_endless.family.make(Format::binary32, seed, k).query));
}

/// Coordinates at the ends of the range neither overflow nor stop the draws.
TEST(OwnFamily, TakesNumbersOfAnySize) {
  const Query extreme{Segment{{1.7e308, -1.7e308, 5e-324}, {-1.7e308, 1.7e308, 0}},
                      Triangle{{1.7e308, 5e-324, 0}, {-1.7e308, 1e-300, 1}, {3, -0.0, 1.7e308}}};
  const Query ray{Ray{{1.7e308, -5e-324, 0}, {{-5e-324, 1.7e308, 0}}}, extreme.target};
  for (const Query& query : {extreme, ray}) {
    const OwnFamily own = family_of(cases_of({{query, Format::binary64}}));
    for (std::uint64_t k = 0; k < 5'000; ++k) ASSERT_TRUE(is_finite(own.family.make(Format::binary64, seed, k).query));
  }
}

TEST(OwnFamily, EveryMutationChangesSomething) {
  for (const Mutation& mutation : mutations()) {
    int changed = 0;
    for (std::uint64_t k = 0; k < 1'000; ++k) {
      Draw draw(stream_of("family own-cases"), seed, k);
      Query query = ray_at_wall;
      mutate(query, mutation, {through_wall, 5'000, Format::binary64}, draw);
      changed += with_signs(numbers_of(query)) != with_signs(numbers_of(ray_at_wall));
    }
    EXPECT_GT(changed, 500) << mutation.name;
  }
}

/// One snap cannot turn a probe that crosses the wall into its plane; an aim along an edge does.
TEST(OwnFamily, SnapsAndAimsProbesAtVerticesEdgesAndFaces) {
  for (const std::size_t index : {std::size_t{2}, std::size_t{4}}) {
    std::map<Contact, int> met;
    for (std::uint64_t k = 0; k < 600; ++k) {
      Draw draw(stream_of("family own-cases"), seed, k);
      Query query = through_wall;
      mutate(query, mutations()[index], {ray_at_wall, 5'000, Format::binary64}, draw);
      ++met[flagship_method().ask(query).contact];
    }
    for (const Contact c : {Contact::none, Contact::interior, Contact::edge, Contact::vertex, Contact::coplanar}) {
      if (c == Contact::coplanar && index == 2) continue;
      EXPECT_GE(met[c], 5) << mutations()[index].name << ": " << name_of(c);
    }
  }
}

/// Is wrong where a probe ends within a micrometre of a corner of one wall, as a program is that has a tolerance for
/// its own units. No shipped family goes there.
Method wrong_at_the_wall() {
  Method m = flagship_method();
  const auto near_corner = [](const Query& q) {
    const Point3 end = std::get<Segment>(q.probe).q, corner = q.triangle().a;
    const Point3 by = end - corner, from_wall = corner - wall.a;
    const auto within = [](const Point3& v, double d) {
      return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)}) <= d;
    };
    return within(by, 1e-6) && within(from_wall, 50);
  };
  Method wrong{.name = "wrong-at-the-wall", .contract = m.contract};
  wrong.contract.exact = false;
  wrong.segment = [m, near_corner](const Segment& s, const Triangle& t) {
    Answer a = m.segment(s, t);
    if (near_corner({s, t})) a.hit = !a.hit;
    return a;
  };
  wrong.ray = m.ray;
  return wrong;
}

FuzzPlan plan_of(const Method& method, std::vector<Stream> streams, std::uint64_t cases) {
  FuzzPlan plan{.methods = {method}, .streams = std::move(streams), .seed = seed, .cases = cases};
  plan.quick = quick_class_for(plan.methods, Operands::triangles);
  return plan;
}

TEST(OwnFamily, FindsFromOneCaseWhatNoShippedFamilyFinds) {
  const Method wrong = wrong_at_the_wall();
  EXPECT_TRUE(fuzz(plan_of(wrong, streams_of(Operands::triangles), 400'000)).findings.empty());
  const OwnFamily own = family_of(cases_of({{through_wall, Format::binary64}}));
  ASSERT_EQ(wrong.ask(through_wall).hit, flagship_method().ask(through_wall).hit)
      << "it answers the case itself rightly";
  FuzzPlan plan = plan_of(wrong, streams_in(own), 100'000);
  plan.until_first = true;
  const FuzzReport report = fuzz(plan);
  ASSERT_EQ(report.findings.size(), 1u);
  EXPECT_LT(case_number(plan, report.findings[0]), 20'000u);
}

TEST(OwnFamily, FindsFromOneMeshWhatNoShippedFamilyFinds) {
  const OwnFamily own = family_of(mesh_of_walls(4));
  EXPECT_FALSE(fuzz(plan_of(wrong_at_the_wall(), streams_in(own), 20'000)).findings.empty());
}

/// Is wrong on one query in so many, by a hash of its numbers.
Method wrong_on_one_in(std::uint64_t period) {
  const Method m = flagship_method();
  Method wrong{.name = "wrong-on-some", .contract = m.contract};
  wrong.contract.exact = false;
  const auto flips = [period](const Query& q) {
    std::uint64_t hash = 0;
    for (const double x : numbers_of(q)) {
      hash = (hash ^ std::bit_cast<std::uint64_t>(x)) * 0x9e3779b97f4a7c15u;
      hash ^= hash >> 29;
    }
    return hash % period == 0;
  };
  const auto answer = [m, flips](const Query& q) {
    Answer a = m.ask(q);
    a.hit = a.hit != flips(q);
    return a;
  };
  wrong.segment = [answer](const Segment& s, const Triangle& t) { return answer({s, t}); };
  wrong.ray = [answer](const Ray& r, const Triangle& t) { return answer({r, t}); };
  return wrong;
}

/// The finding, and all counts, are those of the lowest case number whatever the threads; and a whole run finds it
/// first.
TEST(UntilFirst, IsTheSameForAnyNumberOfThreads) {
  const OwnFamily own = family_of(street(40));
  std::uint64_t latest = 0;
  for (const Method& method : {*find_method("jimenez-double"), wrong_on_one_in(20'000), wrong_on_one_in(70'000)}) {
    FuzzPlan plan = plan_of(method, streams_in(own), 300'000);
    const FuzzReport whole = fuzz(plan);
    plan.until_first = true;
    const FuzzReport one = fuzz(plan);
    ASSERT_EQ(one.findings.size(), 1u);
    latest = std::max(latest, case_number(plan, one.findings[0]));
    EXPECT_LT(one.cases, whole.cases);
    EXPECT_TRUE(is_complete(plan, one));
    EXPECT_EQ(case_number(plan, one.findings[0]), case_number(plan, whole.findings[0]));
    for (const unsigned threads : {2u, 7u}) {
      plan.threads = threads;
      const FuzzReport many = fuzz(plan);
      ASSERT_EQ(many.findings.size(), 1u);
      EXPECT_EQ(case_number(plan, many.findings[0]), case_number(plan, one.findings[0]));
      EXPECT_EQ(many.cases, one.cases);
      EXPECT_TRUE(many.counts == one.counts);
    }
  }
  EXPECT_GT(latest, 16 * block_size_of(Operands::triangles)) << "all were found in the first few blocks";
}

TEST(UntilFirst, RunsToTheEndWithoutAFinding) {
  FuzzPlan plan = plan_of(flagship_method(), streams_of(Operands::triangles), 10'000);
  plan.until_first = true;
  const FuzzReport report = fuzz(plan);
  EXPECT_TRUE(report.findings.empty());
  EXPECT_EQ(report.cases, 10'000u);
  EXPECT_TRUE(is_complete(plan, report));
}

// --- what is read ------------------------------------------------------------------------------------------------

std::string written(const std::string& name, const std::string& text) {
  const std::string path = ::testing::TempDir() + name;
  std::ofstream(path, std::ios::binary) << text;
  return path;
}

constexpr const char* triangle_line = R"({"id":"t","seg":[[0,0,1],[0,0,-1]],"tri":[[0,0,0],[1,0,0],[0,1,0]]})";
constexpr const char* ring_line = R"({"id":"r","seg":[[0,0,1],[0,0,-1]],"rings":[[[0,0,0],[1,0,0],[0,1,0]]]})";

TEST(OwnData, TakesTheOperandsThatAreWantedAndCountsTheOthers) {
  const std::string file = written("mixed.jsonl", std::string(triangle_line) + "\n" + ring_line + "\n" + ring_line);
  EXPECT_EQ(read_own_cases(file, std::nullopt).queries.size(), 1u);
  EXPECT_EQ(read_own_cases(file, std::nullopt).other_operands, 2u);
  EXPECT_EQ(read_own_cases(file, Operands::polygons).queries.size(), 2u);
  const std::string rings = written("rings.jsonl", ring_line);
  EXPECT_EQ(family_of(read_own_cases(rings, std::nullopt)).family.operands, Operands::polygons);
  EXPECT_THROW(read_own_cases(rings, Operands::triangles), Failure);
  EXPECT_EQ(read_own_cases(rings, std::nullopt).sha256, sha256(ring_line));
}

TEST(OwnData, TheHashOfNumbersIsThatOfWhatIsAsked) {
  const auto hash = [](const OwnData& data) { return family_of(data).family.data->numbers_sha256; };
  OwnData changed = street(3);
  EXPECT_EQ(hash(changed), hash(street(3)));
  Parts(changed.queries[2].query).source().x = std::nextafter(Parts(changed.queries[2].query).source().x, 0.0);
  EXPECT_NE(hash(changed), hash(street(3)));
  changed = street(3);
  changed.queries[1].format = Format::binary32;
  EXPECT_NE(hash(changed), hash(street(3)));
}

}  // namespace
}  // namespace tribunal
