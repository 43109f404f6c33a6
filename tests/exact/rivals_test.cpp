// The shelf of published rivals: each is right on plain cases, its exact twin is never wrong under its contract, and
// each is wrong somewhere in floating point. docs/rivals.md has the table that this test holds them to.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <set>

#include "exact/cases/case_io.h"
#include "exact/cases/families/draw.h"
#include "exact/certificate/small_scope.h"
#include "exact/classes/class_table.h"
#include "exact/methods/methods.h"
#include "exact/trial/fuzz.h"
#include "exact/trial/judge.h"
#include "exact/trial/truth.h"

namespace tribunal {
namespace {

/// Faults of logic: rivals whose exact twins are wrong, and where.
const std::map<std::string, std::string> faults_of_logic = {
    {"havel-herout", "a probe in the plane is a hit, wherever the triangle is"},
    {"mt-eps", "a determinant below 1e-6 is a miss"},
    {"mt-cull", "a determinant below 1e-6 is a miss"},
};

std::string shelf_name(const Method& m) { return m.name.substr(0, m.name.rfind('-')); }

/// All methods with an exact twin, but for Segura–Feito in floating point, whose twin is the reference.
std::vector<Method> rivals() {
  std::vector<Method> all;
  for (const Method& m : all_methods()) {
    if (m.exact_twin && !m.name.starts_with("sf-")) all.push_back(m);
  }
  return all;
}

/// The exact twins as methods, one for each pair of float and double.
std::vector<Method> twins() {
  std::vector<Method> all;
  for (Method m : rivals()) {
    if (!m.name.ends_with("-double")) continue;
    const auto twin = m.exact_twin;
    m.segment = [twin](const Segment& s, const Triangle& t) { return twin({s, t}); };
    m.ray = [twin](const Ray& r, const Triangle& t) { return twin({r, t}); };
    all.push_back(m);
  }
  return all;
}

TEST(Rivals, FillAShelf) {
  std::set<std::string> names;
  for (const Method& m : rivals()) names.insert(shelf_name(m));
  EXPECT_GE(names.size(), 18U);
  EXPECT_EQ(rivals().size(), 2 * names.size()) << "each in float and in double";
  EXPECT_GE(all_methods().size(), 30U);
}

/// A case that is far from every boundary: a triangle with sides and height of some units, and a point of it or beside
/// it by a tenth at least, at a parameter away from both ends.
struct Plain {
  Triangle triangle;
  Segment segment;
  Ray ray;
  double t;     ///< the parameter at which the ray meets the plane
  double b, c;  ///< the weights of that point
};

double unit(Draw& draw) { return static_cast<double>(draw.between(-1000, 1000)) / 1000; }

Point3 drawn(Draw& draw, double size) {
  const double x = unit(draw);
  const double y = unit(draw);
  const double z = unit(draw);
  return in_format(Point3(x, y, z) * size, Format::binary32);
}

double length(const Point3& v) { return std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z); }

double determinant(const Point3& u, const Point3& v, const Point3& w) {
  return u.x * (v.y * w.z - v.z * w.y) + u.y * (v.z * w.x - v.x * w.z) + u.z * (v.x * w.y - v.y * w.x);
}

double height_over(const Point3& ab, const Point3& ac, const Point3& d) {
  return std::fabs(determinant(d, ab, ac)) / (length(ab) * length(ac) * length(d));
}

/// Draws a plain case; none if the triangle is flat or the probe grazes it.
std::optional<Plain> plain_case(std::uint64_t k) {
  Draw draw(9001, 7, k);
  const Triangle t{drawn(draw, 4), drawn(draw, 4), drawn(draw, 4)};
  const Point3 d = drawn(draw, 6);
  const double b = 0.375 + unit(draw);
  const double c = 0.375 + unit(draw);
  const double before = 0.75 + unit(draw) / 2;
  const double after = 0.375 + unit(draw);
  const Point3 ab = t.b - t.a, ac = t.c - t.a;
  if (length(ab) < 1 || length(ac) < 1 || length(d) < 1 || height_over(ab, ac, d) < 0.05) return std::nullopt;
  for (const double margin : {b, c, 1 - b - c, after, before + after}) {
    if (std::fabs(margin) < 0.1) return std::nullopt;
  }
  const Point3 x = t.a + b * ab + c * ac;
  const Point3 o = in_format(x - before * d, Format::binary32);
  const Point3 q = in_format(x + after * d, Format::binary32);
  return Plain{t, {o, q}, {o, {d}}, before, b, c};
}

void expect_near_construction(const Method& m, const Plain& plain, std::uint64_t k) {
  const std::optional<HitAt> hit = m.hit(plain.ray, plain.triangle);
  ASSERT_TRUE(hit.has_value()) << m.name << " case " << k;
  EXPECT_NEAR(hit->t, plain.t, 1e-3) << m.name << " case " << k;
  EXPECT_EQ(m.parameter(plain.ray, plain.triangle), hit->t) << m.name << " case " << k;
  if (!hit->weights) return;
  EXPECT_NEAR(hit->weights->b, plain.b, 1e-3) << m.name << " case " << k;
  EXPECT_NEAR(hit->weights->c, plain.c, 1e-3) << m.name << " case " << k;
}

TEST(Rivals, AreRightOnPlainCasesInFloatAndInDouble) {
  std::map<std::string, int> hits, misses, points;
  for (std::uint64_t k = 0; k < 9'000; ++k) {
    const std::optional<Plain> plain = plain_case(k);
    if (!plain) continue;
    for (const Query& query : {Query{plain->segment, plain->triangle}, Query{plain->ray, plain->triangle}}) {
      const Truth truth = exact_truth(query);
      for (const Method& m : rivals()) {
        const Answer answer = m.ask(query);
        if (answer.status == Status::unsupported) {
          EXPECT_TRUE(is_of_ray(query) && !m.contract.probes.rays) << m.name;
          continue;
        }
        EXPECT_EQ(judge(m, truth, answer), Outcome::right) << m.name << " case " << k;
        EXPECT_EQ(m.exact_twin(query).hit, answer.hit) << m.name << " case " << k;
        ++(answer.hit ? hits : misses)[m.name];
        if (!answer.hit || !is_of_ray(query)) continue;
        ++points[m.name];
        expect_near_construction(m, *plain, k);
      }
    }
  }
  for (const Method& m : rivals()) {
    EXPECT_GT(hits[m.name], 250) << m.name;
    EXPECT_GT(misses[m.name], 1000) << m.name;
    EXPECT_EQ(points[m.name] > 150, m.contract.probes.rays) << m.name;
  }
}

/// Normals with zeros and with equal coordinates: walls, floors and slopes.
std::vector<Point3> plain_normals() {
  std::vector<Point3> normals;
  for (int code = 0; code < 125; ++code) {
    const Point3 n(code % 5 - 2, code / 5 % 5 - 2, code / 25 - 2);
    if (n != Point3(0, 0, 0)) normals.push_back(n);
  }
  return normals;
}

/// Two edges at a right angle to n and to each other.
std::pair<Point3, Point3> edges_across(const Point3& n) {
  const Point3 u = n.x == 0 && n.y == 0 ? Point3(8, 0, 0) : Point3(-4 * n.y, 4 * n.x, 0);
  return {u, {n.y * u.z - n.z * u.y, n.z * u.x - n.x * u.z, n.x * u.y - n.y * u.x}};
}

/// A segment and a ray along n, through the point that has this weight of the second vertex and 1/2 of the third.
std::array<Query, 2> across_wall(const Point3& n, double weight) {
  const auto [u, v] = edges_across(n);
  const Point3 corner(3, -5, 7);
  const Point3 x = corner + weight * u + 0.5 * v;
  const Triangle t{corner, corner + u, corner + v};
  return {Query{Segment{x - n, x + 3.0 * n}, t}, Query{Ray{x + n, {-2.0 * n}}, t}};
}

TEST(Rivals, AreRightOnWalls) {
  std::map<std::string, int> hits, misses;
  const auto ask_all = [&](const Query& query, Contact contact) {
    const Truth truth = exact_truth(query);
    ASSERT_EQ(truth.contact, contact);
    for (const Method& m : rivals()) {
      const Answer answer = m.ask(query);
      if (answer.status == Status::unsupported) continue;
      EXPECT_EQ(judge(m, truth, answer), Outcome::right) << m.name;
      EXPECT_EQ(m.exact_twin(query).hit, answer.hit) << m.name;
      ++(answer.hit ? hits : misses)[m.name];
    }
  };
  for (const Point3& n : plain_normals()) {
    for (const Query& query : across_wall(n, 0.25)) ask_all(query, Contact::interior);
    for (const Query& query : across_wall(n, -0.25)) ask_all(query, Contact::none);
    for (const Query& query : across_wall(n, 0.75)) ask_all(query, Contact::none);
  }
  for (const Method& m : rivals()) EXPECT_TRUE(hits[m.name] >= 100 && misses[m.name] >= 200) << m.name;
}

/// A set that is run whole: none wrong, unless the table says why. `shown`: how many of the set show a fault of logic.
void expect_sound(const Method& twin, const ScopeResult& result, std::uint64_t shown = 0) {
  if (result.of_rays ? !twin.contract.probes.rays : !twin.contract.probes.segments) return;
  EXPECT_GT(result.count.judged(), result.size / 8) << twin.name << " " << result.name;
  EXPECT_EQ(result.count.wrong, shown) << twin.name << " " << result.name;
  if (!twin.name.starts_with("havel")) return;
  for (const Query& query : result.wrong)
    EXPECT_EQ(exact_truth(query).contact, Contact::none) << "beside, in the plane";
}

TEST(Rivals, ExactTwinsAreNeverWrongOnWholeSets) {
  for (const Method& twin : twins()) {
    const std::string name = shelf_name(twin);
    const bool in_plane = name == "havel-herout";
    // The set of rays has directions of length 2⁻¹⁰⁰.
    const std::uint64_t parallel = name == "mt-eps" ? 1'728 : name == "mt-cull" ? 864 : 0;
    expect_sound(twin, pocket_run(twin), in_plane ? 16'128 : 0);
    expect_sound(twin, ray_pocket_run(twin), in_plane ? 31'968 : parallel);
    expect_sound(twin, lattice_run(twin, 2, 2));
  }
}

Point3 of_cube(Draw& draw) {
  const auto x = draw.between(-1, 1);
  const auto y = draw.between(-1, 1);
  const auto z = draw.between(-1, 1);
  return {x, y, z};
}

/// A segment, a ray and a triangle of {−1, 0, 1}³; the ray has the segment's source.
struct SmallCase {
  Segment segment;
  Ray ray;
  Triangle triangle;
};

SmallCase small_case(std::uint32_t stream, std::uint64_t k) {
  Draw draw(stream, 7, k);
  const Point3 p = of_cube(draw);
  const Point3 q = of_cube(draw);
  const Point3 a = of_cube(draw);
  const Point3 b = of_cube(draw);
  const Point3 c = of_cube(draw);
  return {{p, q}, {p, {q}}, {a, b, c}};
}

/// Cases of {−1, 0, 1}³, segments and rays in turn, as they are drawn.
TEST(Rivals, ExactTwinsAreNeverWrongOnRandomCasesOfASmallCube) {
  const std::vector<Method> all = twins();
  std::map<std::string, std::uint64_t> wrong, judged;
  for (std::uint64_t k = 0; k < 200'000; ++k) {
    const SmallCase c = small_case(9002, k);
    const Probe probe = k % 2 == 0 ? Probe(c.segment) : Probe(c.ray);
    const Query query{probe, c.triangle};
    const Truth truth = truth_in_class(reference_method().classify(probe, query.triangle()).class_id, query);
    for (const Method& twin : all) {
      const Outcome outcome = judge(twin, truth, twin.ask(query));
      judged[twin.name] += is_judged(outcome);
      wrong[twin.name] += is_wrong(outcome);
    }
  }
  for (const Method& twin : all) {
    EXPECT_GT(judged[twin.name], twin.contract.probes.rays ? 60'000U : 30'000U) << twin.name;
    EXPECT_EQ(wrong[twin.name] > 0, twin.name == "havel-herout-double") << twin.name;
  }
}

/// Every form of a method gives the same answer: plain, with the triangle prepared, with the ray prepared.
TEST(Rivals, PreparedFormsAnswerAsThePlainOnes) {
  std::map<std::string, int> hits;
  std::set<std::string> of_triangles, of_rays;
  for (std::uint64_t k = 0; k < 3'000; ++k) {
    const auto [s, r, t] = small_case(9004, k);
    for (const Method& m : rivals()) {
      hits[m.name] += m.segment(s, t).hit;
      if (m.prepare_triangle) {
        of_triangles.insert(m.name);
        const PreparedTriangle prepared = m.prepare_triangle(t);
        EXPECT_EQ(prepared.segment(s), m.segment(s, t)) << m.name << " case " << k;
        EXPECT_EQ(prepared.ray(r), m.ray(r, t)) << m.name << " case " << k;
      }
      if (m.prepare_ray) {
        of_rays.insert(m.name);
        EXPECT_EQ(m.prepare_ray(r)(t), m.ray(r, t)) << m.name << " case " << k;
      }
    }
  }
  for (const auto& [name, n] : hits) EXPECT_GT(n, name.starts_with("chirkov") ? 0 : 30) << name;
  EXPECT_EQ(of_triangles.size(), 16U);
  EXPECT_EQ(of_rays, (std::set<std::string>{"woop-double", "woop-float"}));
}

/// Lanes answer as a number alone does, among neighbours of every kind: of all families, 37 pairs at once, so that the
/// last registers are not full.
TEST(Rivals, BatchesAnswerAsTheSingleFormDoes) {
  std::set<std::string> in_batches;
  for (const Method& m : rivals()) {
    if (!m.batch) continue;
    in_batches.insert(shelf_name(m));
    std::map<bool, int> answered;
    for (const Stream& stream : streams_of(Operands::triangles)) {
      for (std::uint64_t first = 0; first < 1'110; first += 37) {
        std::vector<TrianglePair> pairs;
        for (std::uint64_t k = first; k < first + 37; ++k) {
          pairs.push_back(pair_of(stream.family->make(stream.format, 11, k).query));
        }
        std::vector<Answer> answers(pairs.size());
        m.batch(pairs, answers);
        for (std::size_t i = 0; i < pairs.size(); ++i) {
          ++answered[answers[i].hit];
          EXPECT_EQ(answers[i], m.ask({pairs[i].probe, pairs[i].triangle})) << m.name << " case " << first + i;
        }
      }
    }
    EXPECT_TRUE(answered[true] > 5'000 && answered[false] > 5'000) << m.name;
  }
  EXPECT_EQ(in_batches, (std::set<std::string>{"embree", "havel-herout", "shevtsov", "wald"}));
}

/// The nearer of two parallel triangles, by every method that orders hits.
TEST(Rivals, OrderTwoHitsOnARay) {
  const Triangle near{{-4, -4, 2}, {5, -3, 2}, {0, 6, 2}}, far{{-4, -4, 5}, {5, -3, 5}, {0, 6, 5}};
  const Ray up{{0.25, 0.5, 0}, {{0, 0, 1}}}, down{{0.25, 0.5, 9}, {{0, 0, -1}}};
  for (const Method& m : rivals()) {
    EXPECT_EQ(m.compare_hits != nullptr, m.contract.probes.rays) << m.name;
    if (!m.compare_hits) continue;
    const bool sees_from_above = m.contract.culling == Culling::back_faces;
    EXPECT_EQ(m.compare_hits(up, near, far), sees_from_above ? Sign::zero : Sign::negative) << m.name;
    EXPECT_EQ(m.compare_hits(down, near, far), Sign::positive) << m.name;
    EXPECT_EQ(m.compare_hits(down, far, far), Sign::zero) << m.name;
  }
}

/// Where the table names a fault of logic, the twin shows it, and another method's does not.
TEST(Rivals, FaultsOfLogicAreThoseOfTheTable) {
  const Query small{Segment{{0x1p-12, 0x1p-12, 0x1p-10}, {0x1p-12, 0x1p-12, -0x1p-10}},
                    Triangle{{0, 0, 0}, {0x1p-10, 0, 0}, {0, 0x1p-10, 0}}};
  const Query beside{Segment{{8, 8, 0}, {9, 9, 0}}, Triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
  for (const Method& m : twins()) {
    bool wrong = false;
    for (const Query& query : {small, beside}) {
      wrong |= is_wrong(judge(m, exact_truth(query), m.exact_twin(query)));
    }
    EXPECT_EQ(wrong, faults_of_logic.contains(shelf_name(m))) << m.name;
  }
}

/// One of the six orders of the vertices.
Triangle in_order(const Triangle& t, std::uint64_t order) {
  const Triangle turned = order % 3 == 0 ? t : order % 3 == 1 ? Triangle{t.b, t.c, t.a} : Triangle{t.c, t.a, t.b};
  return order < 3 ? turned : Triangle{turned.a, turned.c, turned.b};
}

/// Of the faces around an edge or a vertex, a probe through it hits exactly one, in exact arithmetic.
TEST(Rivals, HalfOpenFacesShareTheirEdgesAndVertices) {
  std::uint64_t on_boundary = 0;
  for (const Method& m : twins()) {
    if (m.contract.boundary != Boundary::half_open) continue;
    for (std::uint64_t k = 0; k < 20'000; ++k) {
      Draw draw(9003, 7, k);
      const Point3 p = Point3(0, 0, 3) + of_cube(draw);
      const Point3 q = Point3(0, 0, -3) + of_cube(draw);
      const std::uint64_t orders = draw.next();
      // A fan of six triangles around a point that is lifted off the plane of the others.
      const Point3 rim[6] = {{3, 0, 0}, {3, 3, 0}, {0, 3, 0}, {-3, 0, 0}, {-3, -3, 0}, {0, -3, 0}};
      int hits = 0;
      for (std::size_t i = 0; i < 6; ++i) {
        const Triangle t = in_order({{0, 0, 1}, rim[i], rim[(i + 1) % 6]}, (orders >> 3 * i) % 6);
        const Segment s{p, q};
        hits += m.segment(s, t).hit;
        const Contact contact = reference_method().segment(s, t).contact;
        on_boundary += contact == Contact::edge || contact == Contact::vertex;
      }
      EXPECT_EQ(hits, 1) << m.name << " case " << k;
    }
  }
  EXPECT_GT(on_boundary, 1000U);
}

/// One witness of rounding a method, and one of logic where the table names a fault: shrunk counterexamples.
TEST(Rivals, AreWrongOnTheirWitnesses) {
  std::set<std::string> rounding, logic;
  for (const Case& c : read_cases("data/cases/rival-witnesses.jsonl")) {
    const std::string name = c.id.substr(0, c.id.find(' '));
    const Method* m = find_method(name);
    ASSERT_NE(m, nullptr) << name;
    const Truth truth = exact_truth(c.query);
    EXPECT_EQ(truth.hit(), c.expect) << c.id;
    EXPECT_TRUE(takes(*m, c.format)) << c.id;
    EXPECT_TRUE(is_wrong(judge(*m, truth, m->ask(c.query)))) << c.id;
    const bool twin_is_wrong = is_wrong(judge(*m, truth, m->exact_twin(c.query)));
    EXPECT_EQ(c.source.starts_with("logic"), twin_is_wrong) << c.id;
    (twin_is_wrong ? logic : rounding).insert(name);
  }
  for (const Method& m : rivals()) {
    EXPECT_TRUE(rounding.contains(m.name)) << m.name;
    EXPECT_EQ(logic.contains(m.name), faults_of_logic.contains(shelf_name(m))) << m.name;
  }
}

/// Each rounds somewhere: the first wrong answer of each is printed.
TEST(Rivals, AreEachWrongSomewhereInFloatingPoint) {
  FuzzPlan plan;
  plan.methods = rivals();
  plan.streams = streams_of(Operands::triangles);
  plan.cases = plan.streams.size() * 400;
  plan.threads = 2;
  const FuzzReport report = fuzz(plan);
  std::vector<std::uint64_t> wrong(plan.methods.size()), judged(plan.methods.size());
  report.counts.for_each([&](const Cell& cell, const Count& count) {
    wrong[cell.method] += count.wrong;
    judged[cell.method] += count.judged();
  });
  std::printf("  %-24s %8s %8s\n", "method", "judged", "wrong");
  for (std::size_t i = 0; i < plan.methods.size(); ++i) {
    EXPECT_GT(wrong[i], 0U) << plan.methods[i].name;
    EXPECT_LT(wrong[i], judged[i] / 2) << plan.methods[i].name;
    std::printf("  %-24s %8llu %8llu\n", plan.methods[i].name.c_str(), static_cast<unsigned long long>(judged[i]),
                static_cast<unsigned long long>(wrong[i]));
  }
}

}  // namespace
}  // namespace tribunal
