// The relations that need no oracle, and the evidence that two of them rest on.
#include <gtest/gtest.h>

#include <array>
#include <set>

#include "core/segura_feito.h"
#include "exact/methods/methods.h"
#include "exact/oracles/caratheodory.h"
#include "exact/relations/evidence.h"
#include "exact/relations/relation.h"
#include "tests/exact/relation_totals.h"

namespace tribunal {
namespace {

const FormulaKernel<std::int64_t> k;

Point3 lattice_point(std::uint64_t i) { return Point3(i / 9 % 3, i / 3 % 3, i % 3); }

/// The n-th tuple of five points of {0,1,2}³; all 27⁵ come up, in a scattered order.
std::array<Point3, 5> tuple(std::uint64_t n) {
  std::uint64_t code = n * 7'368'787 % 14'348'907;  // coprime to 3, so all tuples come up
  std::array<Point3, 5> v;
  for (Point3& p : v) {
    p = lattice_point(code % 27);
    code /= 27;
  }
  return v;
}

/// Expects evidence of one kind only: a common point for a hit, of the contact that the signs say, or a separating
/// plane for a miss.
template <class P>
void expect_evidence(const P& probe, const Triangle& t, bool meets) {
  const auto x = common_point({probe, t});
  ASSERT_EQ(x.has_value(), meets);
  ASSERT_NE(x.has_value(), has_separating_plane({probe, t}));
  const Answer answer = segura_feito(probe, t, k);
  if (x) {
    ASSERT_EQ(x->contact, answer.contact);
    ASSERT_EQ(x->at, answer.at);
  }
}

TEST(Evidence, IsFoundForEveryAnswerOnTheSmallLattice) {
  int hits = 0;
  for (std::uint64_t n = 0; n < 30'000; ++n) {
    const auto v = tuple(n);
    const Triangle t{v[0], v[1], v[2]};
    const Segment s{v[3], v[4]};
    const Ray r{v[3], {v[4] - Point3(1.0)}};
    const bool meets = meets_by_caratheodory<std::int64_t>(s, t);
    expect_evidence(s, t, meets);
    expect_evidence(r, t, meets_by_caratheodory<std::int64_t>(r, t));
    if (HasFatalFailure()) FAIL() << "tuple " << n;
    hits += meets;
  }
  EXPECT_GT(hits, 3'000);
}

FuzzPlan plan_for(std::vector<Method> methods, std::uint64_t cases) {
  FuzzPlan plan;
  plan.methods = std::move(methods);
  plan.streams = streams_of(Operands::triangles);
  plan.cases = cases;
  plan.threads = 2;
  return plan;
}

const RelationCount& count_of(const std::vector<RelationCount>& counts, std::string_view relation) {
  const auto named = [&](const RelationCount& c) {
    return relations_of(Operands::triangles)[c.relation].name == relation;
  };
  return *std::find_if(counts.begin(), counts.end(), named);
}

/// A method that takes no degenerate operands answers anything there, and no relation may blame it.
TEST(Relations, AskNothingBeyondTheContract) {
  Method proper = *find_method("sf-epick");
  proper.contract.triangles = Triangles::proper;
  proper.segment = [right = proper.segment](const Segment& s, const Triangle& t) {
    return is_degenerate({s, t}) ? hit_at(Contact::unsaid) : right(s, t);
  };
  for (const RelationCount& c : testing::relation_totals(plan_for({proper}, 2'600))) {
    EXPECT_EQ(c.broken, 0U) << relations_of(Operands::triangles)[c.relation].name;
  }
  proper.contract.triangles = Triangles::any;
  EXPECT_GT(count_of(testing::relation_totals(plan_for({proper}, 2'600)), "end").broken, 0U);
}

std::vector<Method> exact_methods() {
  std::vector<Method> methods;
  for (const Method& method : all_methods()) {
    if (method.contract.exact) methods.push_back(method);
  }
  return methods;
}

TEST(Relations, HoldForExactMethodsOnEveryFamily) {
  const FuzzPlan plan = plan_for(exact_methods(), 2'600);
  ASSERT_GE(plan.methods.size(), 5U);
  for (const RelationCount& c : testing::relation_totals(plan)) {
    const Method& method = plan.methods[c.method];
    const std::string where = method.name + " " + std::string(relations_of(Operands::triangles)[c.relation].name);
    EXPECT_EQ(c.broken, 0U) << where;
    if (method.name.starts_with("sf-")) {
      EXPECT_GT(c.asked, 50U) << where << ": the relation has no cases";
    }
  }
}

TEST(Relations, AreBrokenByNaiveArithmetic) {
  std::set<std::string_view> broken;
  for (const RelationCount& c :
       testing::relation_totals(plan_for({*find_method("sf-double"), *find_method("sf-float")}, 7'800))) {
    if (c.broken > 0) broken.insert(relations_of(Operands::triangles)[c.relation].name);
    EXPECT_EQ(!c.witness.empty(), c.broken > 0);
  }
  for (const char* name :
       {"vertex-order", "reversal", "shear", "longer", "ray", "larger", "parts", "probe-parts", "point", "plane"}) {
    EXPECT_TRUE(broken.contains(name)) << name;
  }
}

Method spoilt(std::function<Answer(const Segment&, const Triangle&)> segment) {
  Method bad = *find_method("sf-epick");
  bad.segment = std::move(segment);
  return bad;
}

std::vector<RelationCount> counts_of(const Method& method) {
  return testing::relation_totals(plan_for({method}, 2'600));
}

Answer right(const Segment& s, const Triangle& t) { return find_method("sf-epick")->segment(s, t); }

/// Each relation catches the bug that it is there for.
TEST(Relations, CatchWhatTheyAreThereFor) {
  const auto asymmetric = counts_of(spoilt([](auto& s, auto& t) { return s.q == t.c ? miss() : right(s, t); }));
  EXPECT_GT(count_of(asymmetric, "vertex-order").broken, 0U);
  EXPECT_GT(count_of(asymmetric, "reversal").broken, 0U);

  const auto never = counts_of(spoilt([](auto&, auto&) { return miss(); }));
  EXPECT_EQ(count_of(never, "vertex-order").broken, 0U) << "consistently wrong";
  EXPECT_GT(count_of(never, "plane").broken, 0U);

  const auto always = counts_of(spoilt([](auto&, auto&) { return hit_at(Contact::unsaid); }));
  EXPECT_EQ(count_of(always, "parts").broken, 0U) << "consistently wrong";
  EXPECT_GT(count_of(always, "point").broken, 0U);

  const auto mislabels = counts_of(spoilt([](auto& s, auto& t) {
    Answer answer = right(s, t);
    if (answer.contact == Contact::edge) answer.contact = Contact::vertex;
    return answer;
  }));
  EXPECT_GT(count_of(mislabels, "point").broken, 0U) << "the hit is right, the contact is not";
  EXPECT_EQ(count_of(mislabels, "plane").broken, 0U);

  const auto flat = counts_of(spoilt([](auto& s, auto& t) {
    return t.b == t.c ? right(s, {t.a, t.a, t.a}) : right(s, t);
  }));
  EXPECT_GT(count_of(flat, "exchange").broken, 0U);
  EXPECT_GT(count_of(flat, "point-exchange").broken, 0U);

  const auto blind_to_points =
      counts_of(spoilt([](auto& s, auto& t) { return s.p == s.q ? hit_at(Contact::unsaid) : right(s, t); }));
  EXPECT_GT(count_of(blind_to_points, "end").broken, 0U);
}

TEST(Relations, ThreadsDoNotShow) {
  FuzzPlan plan = plan_for({*find_method("sf-float")}, 1'500);
  plan.threads = 1;
  const auto one = check_relations(plan);
  plan.threads = 5;
  const auto five = check_relations(plan);
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].asked, five[i].asked);
    EXPECT_EQ(one[i].broken, five[i].broken);
    EXPECT_EQ(one[i].first, five[i].first);
  }
}

}  // namespace
}  // namespace tribunal
