// The mesh trial: exact tests are clean on every mesh, and each planted fault is counted as what it is.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <set>

#include "exact/filtered/crossing.h"
#include "exact/filtered/filtered.h"
#include "exact/filtered/filtered_kernel.h"
#include "exact/filtered/rounded_parameter.h"
#include "exact/methods/methods.h"
#include "exact/trial/judge.h"
#include "tracer/leak/paint.h"
#include "tracer/leak/report.h"

namespace tribunal::leak {
namespace {

Mesh octahedron() {
  return {{{2, 0, 0}, {-2, 0, 0}, {0, 2, 0}, {0, -2, 0}, {0, 0, 2}, {0, 0, -2}},
          {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
}

/// Its faces are their own boxes.
Mesh cube() {
  return {{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {2, 2, 0}, {0, 0, 2}, {2, 0, 2}, {0, 2, 2}, {2, 2, 2}},
          {{0, 2, 3},
           {0, 3, 1},
           {4, 5, 7},
           {4, 7, 6},
           {0, 1, 5},
           {0, 5, 4},  //
           {2, 6, 7},
           {2, 7, 3},
           {0, 4, 6},
           {0, 6, 2},
           {1, 3, 7},
           {1, 7, 5}}};
}

/// The octahedron, each face in four, the corners on a sphere: coordinates of full length.
Mesh ball() {
  Mesh mesh;
  for (const auto& f : octahedron().triangles) {
    const auto corner = [&](std::size_t i) { return octahedron().vertices[f[i]]; };
    const Point3 a = corner(0), b = corner(1), c = corner(2);
    for (const auto& [x, y, z] :
         {std::array{a, a + b, a + c}, {b, b + c, b + a}, {c, c + a, c + b}, {a + b, b + c, c + a}}) {
      const auto n = static_cast<std::uint32_t>(mesh.vertices.size());
      for (const Point3& p : {x, y, z}) mesh.vertices.push_back(glm::normalize(p) * 1.3 + Point3(0.1, 0.2, -0.7));
      mesh.triangles.push_back({n, n + 1, n + 2});
    }
  }
  return mesh;
}

/// Two walls of a box with a notch: not convex, with edges that a ray passes on its way to another face.
Mesh notched() {
  Mesh mesh = cube();
  mesh.vertices.push_back({1, 1, 0.5});
  mesh.triangles.erase(mesh.triangles.begin() + 2, mesh.triangles.begin() + 4);  // the top, instead a pit
  for (const auto& [a, b] : {std::array{4u, 5u}, {5u, 7u}, {7u, 6u}, {6u, 4u}}) mesh.triangles.push_back({a, b, 8});
  return mesh;
}

struct NamedMesh {
  const char* name;
  Mesh (*make)();
};

constexpr NamedMesh closed_meshes[] = {
    {"octahedron", octahedron}, {"cube", cube}, {"ball", ball}, {"notched", notched}};

/// What the one subject of a trial is said to do.
std::string verdict_of(const Surface& surface, const Method& method, const SubjectReport& report) {
  return verdict(surface, subject_of(method, surface), {.rays = report.tally.all().rays}, report);
}

SubjectReport report_of(const Surface& surface, const Method& method, LeakPlan plan = {.rays = 6000}) {
  return run_leak_trial(surface, {subject_of(method, surface)}, plan).subjects[0];
}

std::uint64_t count(const SubjectReport& report, Outcome o) { return report.tally.all()[o]; }

/// A sound method: exact, with closed boundaries and the transversal convention.
Method sound() {
  Method m;
  m.name = "sound";
  m.contract = {.convention = Convention::transversal};
  m.ray = [](const Ray& r, const Triangle& t) {
    const Answer a = intersect(r, t);
    return a.contact == Contact::coplanar ? miss() : a;
  };
  m.compare_hits = [](const Ray& r, const Triangle& s, const Triangle& t) { return compare_hits(r, s, t); };
  return m;
}

/// An exact method that gives each edge to exactly one face.
Method half_open() {
  Method m = sound();
  m.name = "half-open";
  m.contract.boundary = Boundary::half_open;
  m.ray = [](const Ray& r, const Triangle& t) {
    return crossing(r, t).direction != 0 ? hit_at(Contact::unsaid) : miss();
  };
  return m;
}

/// A faulty method: it tests a triangle that is larger by 2⁻²⁰.
Method grown() {
  Method m = sound();
  m.ray = [](const Ray& r, const Triangle& t) {
    const Point3 centre = (t.a + t.b + t.c) / 3.0;
    const auto moved = [&](const Point3& p) { return centre + (p - centre) * (1 + 0x1p-20); };
    const Answer a = intersect(r, {moved(t.a), moved(t.b), moved(t.c)});
    return a.contact == Contact::coplanar ? miss() : a;
  };
  return m;
}

/// A faulty method: it demands that the weights of a hit exceed an ε.
Method shrunk() {
  Method m = sound();
  m.ray = [weights_of = find_method("mt-double")->hit](const Ray& r, const Triangle& t) {
    constexpr double epsilon = 0x1p-20;
    const std::optional<HitAt> hit = weights_of(r, t);
    if (!hit || !sound().ray(r, t).hit) return miss();
    const auto [b, c] = *hit->weights;
    return b > epsilon && c > epsilon && 1 - b - c > epsilon ? hit_at(Contact::unsaid) : miss();
  };
  return m;
}

/// Half of all triangles, by their coordinates.
bool is_chosen(const Triangle& t) { return t.a.x + 3 * t.b.y + 5 * t.c.z > 0; }

Method open_in_some_faces() {
  Method m = sound();
  m.ray = [](const Ray& r, const Triangle& t) {
    const Answer a = intersect(r, t);
    return a.contact == Contact::interior || (a.hit && a.contact != Contact::coplanar && !is_chosen(t)) ? a : miss();
  };
  return m;
}

TEST(MeshTrial, ExactTestsAreClean) {
  for (const NamedMesh& mesh : closed_meshes) {
    for (const Format format : {Format::binary32, Format::binary64}) {
      const Surface surface(mesh.make(), format, mesh.name);
      for (const Method& m : {sound(), half_open(), flagship_method()}) {
        const SubjectReport report = report_of(surface, m);
        EXPECT_FALSE(has_erred(report)) << mesh.name << ": " << verdict_of(surface, m, report);
        EXPECT_GT(report.tally.all().parity_judged, 1000u);
        const bool reports_both = m.contract.boundary == Boundary::closed;
        EXPECT_TRUE(!reports_both || count(report, Outcome::twice) > 200) << mesh.name << " " << m.name;
      }
    }
  }
}

TEST(MeshTrial, AnExactTestThatCullsIsClean) {
  Method culls = sound();
  culls.contract.culling = Culling::back_faces;
  culls.ray = [](const Ray& r, const Triangle& t) {
    const Answer a = sound().ray(r, t);
    return a.hit && facing(r, t, FilteredKernel()) == Facing::front ? a : miss();
  };
  for (const NamedMesh& mesh : closed_meshes) {
    const Surface surface(mesh.make(), Format::binary64, mesh.name);
    EXPECT_FALSE(has_erred(report_of(surface, culls))) << mesh.name;
    culls.contract.culling = Culling::none;
    EXPECT_GT(count(report_of(surface, culls), Outcome::leak), 0u) << "from inside nothing is hit";
    culls.contract.culling = Culling::back_faces;
  }
}

TEST(MeshTrial, RaysGoExactlyThroughEveryVertexAndEdgeFromBothSides) {
  const Surface surface(octahedron(), Format::binary64, "octahedron");
  std::map<bool, std::set<std::pair<Aim, std::uint32_t>>> met;
  for (std::uint64_t k = 0; k < 6000; ++k) {
    const auto aimed = aimed_ray(surface, 1, k);
    ASSERT_TRUE(aimed);
    std::vector<std::uint32_t> faces;
    surface.boxes().candidates(BoxProbe(aimed->ray), faces);
    const RayTruth truth = truth_of(surface, *aimed, faces);
    const Contact wanted = aimed->aim == Aim::vertex ? Contact::vertex : Contact::edge;
    const bool exactly = std::ranges::find(truth.crossed, wanted, &Crossed::contact) != truth.crossed.end();
    if (aimed->aim != Aim::face && exactly) met[truth.inside].insert({aimed->aim, aimed->at});
  }
  EXPECT_EQ(met[false].size(), 6u + 12u);
  EXPECT_EQ(met[true].size(), 6u + 12u);
}

/// No face that a ray meets is missing from its candidates, and whether a source is inside does not depend on the
/// ray.
TEST(MeshTrial, CandidatesAndSidesAreThoseOfEveryFace) {
  for (const NamedMesh& mesh : closed_meshes) {
    const Surface surface(mesh.make(), Format::binary64, mesh.name);
    std::vector<std::uint32_t> faces;
    for (std::uint64_t k = 0; k < 1500; ++k) {
      const auto aimed = aimed_ray(surface, 7, k);
      if (!aimed) continue;
      surface.boxes().candidates(BoxProbe(aimed->ray), faces);
      for (std::uint32_t f = 0; f < surface.face_count(); ++f) {
        ASSERT_TRUE(!hits(aimed->ray, surface.triangle(f)) || std::ranges::binary_search(faces, f));
      }
      const RayTruth truth = truth_of(surface, *aimed, faces);
      const Side side = surface.tree().inside(aimed->ray.o);
      ASSERT_EQ(truth.on_surface, side == Side::boundary);
      ASSERT_TRUE(truth.on_surface || truth.inside == (side == Side::inside)) << mesh.name << " ray " << k;
    }
  }
}

TEST(MeshTrial, OpenEdgesInSomeFacesLeakWhereEdgesAre) {
  for (const NamedMesh& mesh : closed_meshes) {
    const Surface surface(mesh.make(), Format::binary64, mesh.name);
    const SubjectReport report = report_of(surface, open_in_some_faces(), {.rays = 6000, .keep = 10000});
    EXPECT_GT(count(report, Outcome::leak), 50u) << mesh.name;
    EXPECT_EQ(count(report, Outcome::false_hit), 0u);
    for (const LeakFinding& f : report.findings.at(Outcome::leak)) {
      const Answer exact = intersect(f.aimed.ray, surface.triangle(f.face));
      ASSERT_TRUE(exact.contact == Contact::edge || exact.contact == Contact::vertex);
    }
  }
}

TEST(MeshTrial, AnEpsilonThatShrinksLeaksAndOneThatGrowsHitsTwice) {
  for (const NamedMesh& mesh : closed_meshes) {
    const Surface surface(mesh.make(), Format::binary64, mesh.name);
    const SubjectReport small = report_of(surface, shrunk()), large = report_of(surface, grown());
    EXPECT_GT(count(small, Outcome::leak), 500u) << mesh.name;
    EXPECT_GT(count(small, Outcome::lost), 100u) << mesh.name;
    EXPECT_EQ(count(small, Outcome::false_hit) + count(small, Outcome::double_hit), 0u) << mesh.name;
    EXPECT_EQ(count(large, Outcome::leak), 0u) << mesh.name;
    EXPECT_GT(count(large, Outcome::double_hit), 50u) << mesh.name;
    EXPECT_GT(count(large, Outcome::false_hit), 50u) << mesh.name;
  }
}

TEST(MeshTrial, AnOrderTurnedAroundIsAWrongOrderAndNothingElse) {
  Method m = sound();
  m.compare_hits = [](const Ray& r, const Triangle& s, const Triangle& t) { return -compare_hits(r, s, t); };
  const Surface surface(notched(), Format::binary64, "notched");
  const SubjectReport report = report_of(surface, m);
  EXPECT_GT(count(report, Outcome::order), 1000u);
  EXPECT_EQ(count(report, Outcome::order), count(report, Outcome::closest));
  EXPECT_EQ(count(report, Outcome::leak) + count(report, Outcome::false_hit) + count(report, Outcome::double_hit), 0u);
}

TEST(MeshTrial, AClosedTestThatSaysHalfOpenHitsTwiceAndMiscounts) {
  Method m = sound();
  m.contract.boundary = Boundary::half_open;
  const Surface surface(octahedron(), Format::binary64, "octahedron");
  const SubjectReport report = report_of(surface, m);
  EXPECT_GT(count(report, Outcome::double_hit), 200u);
  EXPECT_GT(count(report, Outcome::parity), 200u);
  EXPECT_EQ(count(report, Outcome::leak), 0u);
}

TEST(MeshTrial, ATestThatSaysTheSameToAllIsCaught) {
  Method never = sound(), always = sound();
  never.ray = [](const Ray&, const Triangle&) { return miss(); };
  always.ray = [](const Ray&, const Triangle&) { return hit_at(Contact::unsaid); };
  always.compare_hits = nullptr;
  const Surface surface(ball(), Format::binary64, "ball");
  const SubjectReport none = report_of(surface, never), all = report_of(surface, always);
  EXPECT_GT(count(none, Outcome::lost), 3000u);
  EXPECT_EQ(count(none, Outcome::lost), count(none, Outcome::leak));
  EXPECT_GT(count(all, Outcome::false_hit), 1000u);
  EXPECT_EQ(count(all, Outcome::leak), 0u);
}

TEST(MeshTrial, TIsHeldToWhatIsPromised) {
  const Surface surface(ball(), Format::binary64, "ball");
  Subject exact = subject_of(flagship_method(), surface);
  exact.most_ulps = 0.5;  // the parameter is correctly rounded
  Method coarse = flagship_method();
  coarse.parameter = [](const Ray& r, const Triangle& t) -> std::optional<double> {
    return to_binary32(rounded_parameter(r, t));
  };
  Subject rounded = subject_of(coarse, surface);
  rounded.most_ulps = 4;
  const LeakReport report = run_leak_trial(surface, {exact, rounded}, {.rays = 3000});
  EXPECT_EQ(count(report.subjects[0], Outcome::wrong_t), 0u);
  EXPECT_LE(report.subjects[0].worst_ulps, 0.5);
  EXPECT_GT(count(report.subjects[1], Outcome::wrong_t), 1000u);
}

/// Woop, Benthin and Wald's test is watertight; Möller and Trumbore's is not.
TEST(MeshTrial, PublishedTestsDoAsTheirPapersSay) {
  const Surface surface(ball(), Format::binary32, "ball");
  for (const char* format : {"-float", "-double"}) {
    const auto leaks = [&](const char* name) {
      return count(report_of(surface, *find_method(std::string(name) + format), {.rays = 30000}), Outcome::leak);
    };
    EXPECT_EQ(leaks("woop"), 0u) << format;
    EXPECT_GT(leaks("mt"), 0u) << format;
  }
}

TEST(MeshTrial, AnOpenMeshHasLeaksAndNoParity) {
  Mesh mesh = ball();
  mesh.triangles.pop_back();
  const Surface surface(mesh, Format::binary64, "open");
  EXPECT_FALSE(surface.topology().closed());
  for (const Method& m : {sound(), half_open()}) {
    const SubjectReport report = report_of(surface, m);
    EXPECT_FALSE(has_erred(report)) << verdict_of(surface, m, report);
    EXPECT_EQ(report.tally.all().parity_judged, 0u);
    EXPECT_EQ(verdict_of(surface, m, report).find("watertight"), std::string::npos);
  }
  EXPECT_GT(count(report_of(surface, open_in_some_faces()), Outcome::leak), 50u);
}

TEST(MeshTrial, ThreadsDoNotShowAndTheSeedDoes) {
  const Surface surface(ball(), Format::binary64, "ball");
  const std::vector<Subject> subjects = {subject_of(shrunk(), surface)};
  const auto all_of = [&](unsigned threads, std::uint64_t seed) {
    const LeakReport report = run_leak_trial(surface, subjects, {.seed = seed, .rays = 5000, .threads = threads});
    return summary(surface, subjects, report).dump() + painted(surface, report.subjects[0]) +
           from_case(cases_of(surface, subjects[0], report.subjects[0], "ball", seed).front()).dump();
  };
  EXPECT_EQ(all_of(1, 1), all_of(3, 1));
  EXPECT_NE(all_of(1, 1), all_of(1, 2));
}

/// A leak's case is one that the method, asked about that triangle alone, answers wrongly.
TEST(MeshTrial, LeaksAreCasesOfOneTriangle) {
  const Surface surface(ball(), Format::binary64, "ball");
  const Method m = shrunk();
  const SubjectReport report = report_of(surface, m);
  std::size_t leaks = 0;
  for (const Case& c : cases_of(surface, subject_of(m, surface), report, "ball", 1)) {
    EXPECT_EQ(*c.expect, exact_truth(c.query).hit()) << c.id;
    if (c.finding["outcome"] != "leak") continue;
    EXPECT_TRUE(
        is_wrong(tribunal::judge(m, exact_truth(c.query), m.ray(std::get<Ray>(c.query.probe), c.query.triangle()))));
    ++leaks;
  }
  EXPECT_EQ(leaks, 4u);
}

TEST(MeshTrial, TheMostLeakingFaceIsDarkRed) {
  const Surface surface(octahedron(), Format::binary64, "octahedron");
  SubjectReport report = report_of(surface, sound());
  EXPECT_EQ(painted(surface, report).find(" 112 0 16\n"), std::string::npos);
  report.leaks_at[3] = 7;
  report.leaks_at[4] = 2;
  EXPECT_NE(painted(surface, report).find(" 112 0 16\n"), std::string::npos);
  EXPECT_EQ(worst_faces(report, 3), "  worst faces (leaks): 3 (7), 4 (2)\n");
}

/// Relative luminance, as CIE has it.
double luminance(const FaceColour& c) {
  const auto linear = [](std::uint8_t x) {
    const double share = x / 255.0;
    return share <= 0.04045 ? share / 12.92 : std::pow((share + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(c[0]) + 0.7152 * linear(c[1]) + 0.0722 * linear(c[2]);
}

/// What the header says of colours: the more the darker, in both ramps; leaks before errors; the worst leaks darkest.
TEST(Paint, IsDarkerWhereMoreWentWrong) {
  const FaceColour none = colour_of(0, 100, 0, 100);
  EXPECT_TRUE(none[0] == none[1] && none[1] == none[2]) << "grey";
  double leaks = luminance(none), errors = luminance(none);
  for (const std::uint64_t n : {1U, 2U, 5U, 10U, 20U, 40U, 70U, 100U}) {
    const FaceColour leaking = colour_of(n, 100, 0, 100), erring = colour_of(0, 100, n, 100);
    EXPECT_LT(luminance(leaking), leaks) << n;
    EXPECT_LT(luminance(erring), errors) << n;
    EXPECT_GT(leaking[0], leaking[2]) << "warm";
    EXPECT_LT(erring[0], erring[2]) << "cold";
    EXPECT_EQ(colour_of(n, 100, 99, 100), leaking);
    leaks = luminance(leaking), errors = luminance(erring);
  }
  EXPECT_LT(leaks, errors / 5) << "the worst leaks are what the eye finds";
}

}  // namespace
}  // namespace tribunal::leak
