// Methods judged by their contract: for each value a method that keeps it and one that breaks it, through the judge,
// the fuzz run, whole sets, relations and certificates. And the table of methods with its roles.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "core/segura_feito.h"
#include "exact/base/failure.h"
#include "exact/base/output.h"
#include "exact/certificate/certificate.h"
#include "exact/certificate/certify.h"
#include "exact/certificate/small_scope.h"
#include "exact/certificate/verify.h"
#include "exact/kernels/rational_kernel.h"
#include "exact/methods/cgal_kernels.h"
#include "exact/methods/methods.h"
#include "exact/record/contract_json.h"
#include "exact/record/counterexample.h"
#include "exact/relations/relation.h"
#include "exact/trial/fuzz.h"

namespace tribunal {
namespace {

const EpickKernel k;

/// The exact answer, with what a rule makes of it: rule(exact answer, facing) says hit or not.
template <class Rule>
Method by_rule(const char* name, const Contract& contract, const Rule& rule) {
  const auto answer = [rule](const auto& probe, const Triangle& t) {
    const Answer exact = segura_feito(probe, t, k);
    const bool crosses = exact.hit && exact.contact != Contact::coplanar;
    const bool hit = exact.hit && rule(exact, crosses ? facing(probe, t, k) : Facing::unsaid);
    return hit ? hit_at(Contact::unsaid) : miss();
  };
  return {.name = name,
          .contract = contract,
          .segment = [answer](const Segment& s, const Triangle& t) { return answer(s, t); },
          .ray = [answer](const Ray& r, const Triangle& t) { return answer(r, t); }};
}

bool at_boundary(const Answer& a) { return a.contact == Contact::edge || a.contact == Contact::vertex; }
bool at_end(const Answer& a) { return a.at == At::source || a.at == At::target; }

const Contract back_faces_culled{.convention = Convention::transversal, .culling = Culling::back_faces};

/// What a method does, what it says, and whether it may say so.
struct Row {
  Method keeps, breaks;
  bool leaves_cases_open;  ///< some exact answers are outside the contract
};

bool is_front(const Answer& a, Facing f) { return a.contact != Contact::coplanar && f == Facing::front; }
bool is_back(const Answer& a, Facing f) { return a.contact != Contact::coplanar && f == Facing::back; }
bool not_coplanar(const Answer& a, Facing) { return a.contact != Contact::coplanar; }
bool all(const Answer&, Facing) { return true; }
bool inside(const Answer& a, Facing) { return !at_boundary(a); }
bool between_ends(const Answer& a, Facing) { return !at_end(a); }

/// Each value of a contract with a method that keeps it, and one that claims it and does not.
std::vector<Row> rows() {
  const Contract open{.boundary = Boundary::open}, half_open{.boundary = Boundary::half_open};
  const Contract unspecified{.boundary = Boundary::unspecified}, open_ends{.ends = Ends::open};
  const Contract any_ends{.ends = Ends::unspecified}, any_plane{.convention = Convention::unspecified};
  const Contract transversal{.convention = Convention::transversal}, closed;
  const auto lost = [](const Answer& a, Facing) { return a.contact != Contact::interior; };
  return {
      {by_rule("culls", back_faces_culled, is_front), by_rule("culls nothing", back_faces_culled, not_coplanar), false},
      {by_rule("culls", back_faces_culled, is_front), by_rule("culls front", back_faces_culled, is_back), false},
      {by_rule("open", open, inside), by_rule("closed for open", open, all), true},
      {by_rule("half open", half_open, inside), by_rule("half open, lost", half_open, lost), true},
      {by_rule("half open, all", half_open, all), by_rule("half open, lost", half_open, lost), true},
      {by_rule("any edge", unspecified, inside), by_rule("any edge, lost", unspecified, lost), true},
      {by_rule("open ends", open_ends, between_ends), by_rule("closed ends for open", open_ends, all), true},
      {by_rule("any ends", any_ends, between_ends), by_rule("any ends, lost", any_ends, lost), true},
      {by_rule("any plane", any_plane, not_coplanar), by_rule("any plane, lost", any_plane, lost), true},
      {by_rule("any plane, all", any_plane, all), by_rule("any plane, lost", any_plane, lost), true},
      {by_rule("transversal", transversal, not_coplanar), by_rule("closed for it", transversal, all), false},
      {by_rule("closed", closed, all), by_rule("transversal for it", closed, not_coplanar), false},
      {by_rule("closed", closed, all), by_rule("culls unsaid", closed, is_front), false}};
}

Count counted(const Method& method, std::uint64_t cases) {
  FuzzPlan plan{
      .methods = {method}, .streams = streams_of(Operands::triangles), .seed = 11, .cases = cases, .threads = 2};
  Count total;
  fuzz(plan).counts.for_each([&](const Cell&, const Count& c) { total += c; });
  return total;
}

/// Of so many cases those with bounds on t, which none of these methods takes.
std::uint64_t with_bounds(std::uint64_t cases) {
  const std::vector<Stream> streams = streams_of(Operands::triangles);
  std::uint64_t bounded = 0;
  for (std::uint64_t i = 0; i < cases; ++i) {
    const Stream& s = streams[i % streams.size()];
    bounded += s.family->make(s.format, 11, i / streams.size()).query.bounds.has_value();
  }
  return bounded;
}

TEST(Contracts, AreWhatFuzzJudgesBy) {
  for (const Row& row : rows()) {
    const Count kept = counted(row.keeps, 13'000), broken = counted(row.breaks, 13'000);
    EXPECT_EQ(kept.wrong, 0U) << row.keeps.name;
    EXPECT_GT(broken.wrong, 0U) << row.breaks.name << " for " << in_words(row.breaks.contract);
    EXPECT_EQ(kept.unsupported > with_bounds(13'000), row.leaves_cases_open) << row.keeps.name;
    EXPECT_GT(kept.judged(), kept.asked / 3) << row.keeps.name;
  }
}

TEST(Contracts, AreWhatWholeSetsAreJudgedBy) {
  for (const Row& row : rows()) {
    std::uint64_t broken = 0;
    for (const auto run : {pocket_run, ray_pocket_run, line_run}) {
      EXPECT_EQ(run(row.keeps).count.wrong, 0U) << row.keeps.name;
      broken += run(row.breaks).count.wrong;
    }
    EXPECT_GT(broken, 0U) << row.breaks.name;
  }
}

/// The judge, case by case. The triangle's vertices run counterclockwise as seen from above.
TEST(Contracts, JudgeOneCase) {
  const Triangle t{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  const auto verdict = [&](const Contract& c, const Probe& probe, bool hit) {
    const Method m{.name = "m", .contract = c};
    return judge(m, exact_truth({probe, t}), hit ? hit_at(Contact::unsaid) : miss());
  };
  const Segment front{{1, 1, 1}, {1, 1, -1}}, back{{1, 1, -1}, {1, 1, 1}}, beside{{9, 9, 1}, {9, 9, -1}};
  const Ray ray_from_behind{{1, 1, -1}, {{0, 0, 0x1p-400}}};
  EXPECT_EQ(verdict(back_faces_culled, front, true), Outcome::right);
  EXPECT_EQ(verdict(back_faces_culled, front, false), Outcome::false_miss);
  EXPECT_EQ(verdict(back_faces_culled, back, false), Outcome::right);
  EXPECT_EQ(verdict(back_faces_culled, back, true), Outcome::false_hit);
  EXPECT_EQ(verdict(back_faces_culled, ray_from_behind, false), Outcome::right);
  EXPECT_EQ(verdict(back_faces_culled, beside, true), Outcome::false_hit);
  const Segment edge{{2, 0, 1}, {2, 0, -1}}, vertex{{0, 0, 1}, {0, 0, -1}}, touching{{1, 1, 0}, {1, 1, -1}};
  for (const bool hit : {false, true}) {
    for (const Segment& s : {edge, vertex}) {
      EXPECT_EQ(verdict({.boundary = Boundary::half_open}, s, hit), Outcome::not_owed);
      EXPECT_EQ(verdict({.boundary = Boundary::unspecified}, s, hit), Outcome::not_owed);
      EXPECT_EQ(verdict({.boundary = Boundary::open}, s, hit), hit ? Outcome::false_hit : Outcome::right);
      EXPECT_EQ(verdict({}, s, hit), hit ? Outcome::right : Outcome::false_miss);
    }
    EXPECT_EQ(verdict({.ends = Ends::open}, touching, hit), hit ? Outcome::false_hit : Outcome::right);
    EXPECT_EQ(verdict({.ends = Ends::unspecified}, touching, hit), Outcome::not_owed);
    EXPECT_EQ(verdict({.probes = {.segments = false}}, front, hit), Outcome::not_owed);
    EXPECT_EQ(verdict({.triangles = Triangles::proper}, Segment{{1, 1, 0}, {1, 1, 0}}, hit), Outcome::not_owed);
    EXPECT_EQ(verdict({.convention = Convention::unspecified}, Segment{{1, 1, 0}, {2, 1, 0}}, hit), Outcome::not_owed);
  }
}

/// EPICK, which says the side of a case by construction, is held against the rational kernel.
TEST(Contracts, SidesAgreeOnEveryFamily) {
  int crossings = 0;
  for (const Stream& stream : streams_of(Operands::triangles)) {
    for (std::uint64_t i = 0; i < 200; ++i) {
      const Trial trial = stream.family->make(stream.format, 3, i);
      const Truth truth = truth_of(trial, i);
      EXPECT_EQ(truth.facing == Facing::unsaid, !truth.hit() || truth.contact == Contact::coplanar);
      if (truth.facing == Facing::unsaid) continue;
      ++crossings;
      const auto exactly = [&](const auto& probe) { return facing(probe, trial.query.triangle(), RationalKernel{}); };
      ASSERT_EQ(std::visit(exactly, trial.query.probe), truth.facing) << name_of(stream) << " case " << i;
    }
  }
  EXPECT_GT(crossings, 1'000);
}

std::uint64_t relations_broken(const Method& method, std::string_view only = {}) {
  FuzzPlan plan{.methods = {method}, .streams = streams_of(Operands::triangles), .cases = 2'600, .threads = 2};
  std::uint64_t broken = 0;
  for (const RelationCount& c : check_relations(plan)) {
    if (only.empty() || relations_of(Operands::triangles)[c.relation].name == only) broken += c.broken;
  }
  return broken;
}

TEST(Contracts, RelationsBlameNoMethodThatKeepsIts) {
  for (const Row& row : rows()) EXPECT_EQ(relations_broken(row.keeps), 0U) << row.keeps.name;
  EXPECT_GT(relations_broken(by_rule("culls unsaid", {}, is_front), "vertex-order"), 0U);
  EXPECT_GT(relations_broken(by_rule("culls front", back_faces_culled, is_back), "point"), 0U);
  EXPECT_GT(relations_broken(by_rule("culls front", back_faces_culled, is_back), "plane"), 0U);
}

class ContractCertificate : public testing::Test {
 protected:
  void SetUp() override {
    directory_ = (std::filesystem::temp_directory_path() / ("tribunal-contracts-" + std::to_string(getpid()))).string();
    make_directory(directory_);
  }
  void TearDown() override { std::filesystem::remove_all(directory_); }

  Certificate write(const Method& method) {
    ChainedLog log = certify(CertifyPlan{.method = method, .budget = {"tiny", 1, false}, .threads = 2});
    return write_certificate(directory_, log);
  }

  std::string directory_;
};

TEST_F(ContractCertificate, OfAMethodThatCulls) {
  const Certificate kept = write(by_rule("culls", back_faces_culled, is_front));
  EXPECT_EQ(kept.verdict, Verdict::not_refuted);
  EXPECT_EQ(kept.contract, back_faces_culled);
  EXPECT_TRUE(verify(directory_).faults.empty());
  EXPECT_NE(to_markdown(kept).find("segment, ray; any triangle, back faces culled"), std::string::npos);
  const Certificate broken = write(by_rule("culls nothing", back_faces_culled, not_coplanar));
  EXPECT_EQ(broken.verdict, Verdict::refuted);
  const Verification v = verify(directory_);
  EXPECT_TRUE(v.faults.empty()) << v.faults.front();
  EXPECT_GT(v.confirmed, 0U) << "counterexamples are read by the contract that they state";
  const Json finding = read_cases(directory_ + "/counterexamples.jsonl").front().finding;
  EXPECT_EQ(finding["readings"]["culling"], "back faces");
  EXPECT_EQ(finding["expected"], 0);
}

TEST_F(ContractCertificate, NamesWhatHalfOpenEdgesLeaveOpen) {
  const Certificate c = write(by_rule("half open", {.boundary = Boundary::half_open}, inside));
  EXPECT_EQ(c.verdict, Verdict::not_refuted);
  EXPECT_NE(to_markdown(c).find("outside the method's contract: segment, ray; any triangle, half-open edges"),
            std::string::npos);
}

TEST(Contracts, SurviveJson) {
  const Contract contracts[] = {{},
                                back_faces_culled,
                                {.probes = {.rays = false},
                                 .triangles = Triangles::proper,
                                 .polygons = Polygons::planar,
                                 .convention = Convention::unspecified,
                                 .boundary = Boundary::half_open,
                                 .polygon_boundary = Boundary::open,
                                 .ends = Ends::unspecified,
                                 .format = Format::binary32,
                                 .exact = true}};
  for (const Contract& c : contracts) {
    const Json terms = from_contract(c);
    EXPECT_EQ(to_contract({terms, {"x"}}), c);
    Json finding;
    add_readings(finding, c);
    const Contract read = readings_in({finding, {"x"}});
    EXPECT_EQ(read.convention, c.convention);
    EXPECT_EQ(read.boundary, c.boundary);
    EXPECT_EQ(read.polygon_boundary, c.polygon_boundary);
    EXPECT_EQ(read.ends, c.ends);
    EXPECT_EQ(read.culling, c.culling);
  }
  for (const char* key : {"probes", "triangles", "polygons", "coplanar", "boundary", "polygon_boundary", "ends",
                          "culling", "fmt", "exact"}) {
    Json broken = from_contract({});
    broken[key] = "sometimes";
    EXPECT_THROW(to_contract({broken, {"x"}}), Failure) << key;
    broken.erase(key);
    EXPECT_THROW(to_contract({broken, {"x"}}), Failure) << key;
  }
}

/// A prepared form is asked beside the plain one, and must not differ.
TEST(Prepared, FormsAnswerAsTheMethodDoes) {
  Method sound = reference_method();
  sound.name = "prepared";
  sound.prepare_triangle = [](const Triangle& t) {
    return PreparedTriangle{.segment = [t](const Segment& s) { return segura_feito(s, t, k); },
                            .ray = [t](const Ray& r) { return segura_feito(r, t, k); }};
  };
  sound.prepare_ray = [](const Ray& r) -> PreparedRay {
    return [r](const Triangle& t) { return segura_feito(r, t, k); };
  };
  EXPECT_EQ(counted(sound, 2'600).wrong, 0U);

  Method stale = sound;
  stale.prepare_triangle = [](const Triangle& t) {
    return PreparedTriangle{.segment =
                                [t](const Segment& s) {
                                  return segura_feito(s, Triangle{t.a, t.b, t.b}, k);
                                },
                            .ray = [t](const Ray& r) { return segura_feito(r, t, k); }};
  };
  EXPECT_THROW(counted(stale, 2'600), Failure);
  Method as_line = sound;
  as_line.prepare_ray = [](const Ray& r) -> PreparedRay {
    return [r](const Triangle& t) { return segura_feito(Ray{r.o, {-r.d.v}}, t, k); };
  };
  EXPECT_THROW(counted(as_line, 2'600), Failure);
}

TEST(Roles, AreHeldByMethodsThatFitThem) {
  for (const Role role : {Role::reference, Role::second_opinion, Role::flagship}) {
    ASSERT_EQ(methods_with(role).size(), 1U) << name_of(role);
    EXPECT_EQ(methods_with(role).front().name, method_with(role).name);
    EXPECT_TRUE(method_with(role).contract.exact) << name_of(role);
    EXPECT_EQ(roles_of(method_with(role)), std::vector{role});
  }
  EXPECT_EQ(reference_method().contract, flagship_method().contract) << "all that is asked has a reference";
  EXPECT_TRUE(has(reference_method(), Capability::class_id));
  EXPECT_EQ(methods_with(Role::yardstick).size(), 1U) << "times are divided by one method's";
  EXPECT_GE(methods_with(Role::calibration).size(), 2U);
  for (const Method& naive : methods_with(Role::calibration)) {
    EXPECT_FALSE(naive.contract.exact);
    EXPECT_EQ(in_words(naive.contract), in_words(reference_method().contract)) << "it calibrates all that is asked";
  }
  EXPECT_TRUE(roles_of(Method{.name = "nobody"}).empty());
}

TEST(Roles, OnlyTheFlagshipsFilterRunsOnLanes) {
  EXPECT_EQ(methods_with(Capability::tree_lanes), std::vector{&flagship_method()});
  const std::vector<const Method*> in_batches = methods_with(Capability::batch);
  EXPECT_EQ(in_batches.front(), &flagship_method());
  for (const Method* m : in_batches) EXPECT_TRUE(m == &flagship_method() || m->exact_twin) << m->name;
}

/// Correctly rounded, where the ray crosses the plane; nothing where it lies in it or misses.
TEST(Roles, TheFlagshipYieldsParameters) {
  const Triangle t{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  const auto& parameter = flagship_method().parameter;
  EXPECT_EQ(parameter(Ray{{1, 1, 1}, {{0, 0, -3}}}, t), 1.0 / 3);
  EXPECT_EQ(parameter(Ray{{1, 1, 1}, {{0, 0, 3}}}, t), std::nullopt);
  EXPECT_EQ(parameter(Ray{{1, 1, 0}, {{1, 0, 0}}}, t), std::nullopt);
}

}  // namespace
}  // namespace tribunal
