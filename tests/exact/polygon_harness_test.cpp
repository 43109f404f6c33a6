// The harness on polygons: it finds planted bugs, shrinks them, and is the same whatever the number of threads; and
// the relations that need no oracle.
#include <gtest/gtest.h>

#include <set>

#include "core/segura_feito_polygon.h"
#include "exact/cases/family_table.h"
#include "exact/cases/polygons/construction.h"
#include "exact/kernels/rational_kernel.h"
#include "exact/methods/methods.h"
#include "exact/record/counterexample.h"
#include "exact/relations/relation.h"
#include "exact/shrink/shrink.h"
#include "exact/trial/coverage.h"
#include "tests/exact/relation_totals.h"

namespace tribunal {
namespace {

FuzzPlan plan_for(const std::vector<std::string>& names, std::uint64_t cases) {
  FuzzPlan plan;
  for (const std::string& name : names) plan.methods.push_back(*find_method(name));
  plan.streams = streams_of(Operands::polygons);
  plan.cases = cases;
  return plan;
}

TEST(PolygonRelations, HoldForExactMethods) {
  const FuzzPlan plan = plan_for({"sf-rational", "sf-epick"}, 2'800);
  for (const RelationCount& c : testing::relation_totals(plan)) {
    const std::string where =
        plan.methods[c.method].name + " " + std::string(relations_of(Operands::polygons)[c.relation].name);
    EXPECT_EQ(c.broken, 0U) << where;
    EXPECT_GT(c.asked, 200U) << where;
  }
}

TEST(PolygonRelations, AreBrokenByNaiveArithmetic) {
  std::uint64_t broken = 0;
  for (const RelationCount& c : testing::relation_totals(plan_for({"sf-double"}, 2'800))) {
    broken += c.broken;
    EXPECT_EQ(c.witness.size(), c.broken > 0 ? 2U : 0U) << "a query and its change";
  }
  EXPECT_GT(broken, 100U);
}

TEST(PolygonRelations, ThreadsDoNotShow) {
  FuzzPlan plan = plan_for({"sf-float", "haines-double"}, 1'400);
  const auto one = check_relations(plan);
  plan.threads = 3;
  const auto three = check_relations(plan);
  ASSERT_EQ(one.size(), three.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].asked, three[i].asked);
    EXPECT_EQ(one[i].broken, three[i].broken);
    EXPECT_EQ(one[i].first, three[i].first);
  }
}

/// A crossing count may answer either way on the boundary: that breaks no promise.
TEST(PolygonRelations, AreAskedWithinTheContractOnly) {
  const auto counts = testing::relation_totals(plan_for({"sf-rational", "haines-double"}, 1'400));
  const std::size_t n = relations_of(Operands::polygons).size();
  for (std::size_t r = 0; r < n; ++r) {
    EXPECT_GT(counts[n + r].asked, 0U);
    EXPECT_LT(counts[n + r].asked, counts[r].asked);
  }
}

/// A method that promises nothing where a ring edge is met is judged there neither across the polygon nor in its plane,
/// whatever its convention; in the plane beside the edges it is.
TEST(PolygonJudge, TheBoundaryIsMetInThePlaneToo) {
  const PolygonData square = PolygonData{}.add(std::vector<Point3>{{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {0, 9, 0}});
  const PolygonData two_points = PolygonData{}.add(std::vector<Point3>{{0, 0, 0}, {2, 0, 0}});
  struct Row {
    Segment segment;
    const PolygonData* polygon;
    Contact contact;
    bool boundary;
  };
  const Row rows[] = {{{{1, 1, 0}, {12, 1, 0}}, &square, Contact::coplanar, true},
                      {{{9, 3, 0}, {9, 3, 0}}, &square, Contact::coplanar, true},
                      {{{1, 0, 1}, {1, 0, -1}}, &two_points, Contact::coplanar, true},
                      {{{9, 3, 1}, {9, 3, -1}}, &square, Contact::edge, true},
                      {{{9, 9, 1}, {9, 9, -1}}, &square, Contact::vertex, true},
                      {{{1, 1, 0}, {2, 1, 0}}, &square, Contact::coplanar, false},
                      {{{1, 1, 1}, {1, 1, -1}}, &square, Contact::interior, false},
                      {{{10, 1, 0}, {12, 1, 0}}, &square, Contact::none, false}};
  for (const Row& row : rows) {
    const Truth truth = exact_truth(Query{row.segment, *row.polygon});
    EXPECT_EQ(truth.contact, row.contact);
    EXPECT_EQ(truth.boundary, row.boundary);
    for (const Convention convention : {Convention::closed, Convention::transversal}) {
      Method m{};
      m.contract = {.polygons = Polygons::any, .convention = convention, .polygon_boundary = Boundary::unspecified};
      const bool due = truth.hit() && (truth.contact != Contact::coplanar || convention == Convention::closed);
      const Outcome wrong = due ? Outcome::false_miss : Outcome::false_hit;
      const Outcome otherwise = row.boundary ? Outcome::not_owed : wrong;
      const Outcome rightly = row.boundary ? Outcome::not_owed : Outcome::right;
      EXPECT_EQ(judge(m, truth, due ? hit_at(Contact::unsaid) : miss()), rightly);
      EXPECT_EQ(judge(m, truth, due ? miss() : hit_at(Contact::unsaid)), otherwise);
      m.contract.polygon_boundary = Boundary::closed;
      EXPECT_TRUE(is_wrong(judge(m, truth, due ? miss() : hit_at(Contact::unsaid))));
    }
  }
}

/// The triangle, as a ring of three and in rings that take the covering.
TEST(PolygonRelations, ATriangleAsPolygonIsTheTriangle) {
  const RationalKernel k;
  int hits = 0;
  for (std::uint64_t i = 0; i < 3'000; ++i) {
    const Family& family = *find_family(i % 2 == 0 ? "affine" : "ulp");
    const Query query = family.make(Format::binary64, 5, i).query;
    const Triangle& t = query.triangle();
    std::visit(
        [&](const auto& probe) {
          Answer expected = segura_feito(probe, t, k);
          expected.facing = Facing::unsaid;  // a polygon has no front
          hits += expected.hit;
          for (const std::vector<Point3>& ring :
               {std::vector<Point3>{t.a, t.b, t.c}, {t.a, t.b, t.c, t.c}, {t.b, t.b, t.c, t.a}, {t.c, t.a, t.b, t.c}}) {
            const PolygonData polygon = PolygonData{}.add(ring);
            const Answer prepared = segura_feito(probe, cover(polygon, k), k);
            EXPECT_TRUE(prepared.planar);
            EXPECT_EQ(prepared, expected) << "prepared, case " << i;
            EXPECT_EQ(segura_feito(probe, Polygon(polygon), k), expected) << "on the fly, case " << i;
          }
        },
        query.probe);
  }
  EXPECT_GT(hits, 500);
}

/// Triangulations of some shapes, by vertex number.
struct Triangulation {
  std::string_view shape;
  std::vector<std::array<std::size_t, 3>> triangles;
};

const Triangulation triangulations[] = {
    {"convex", {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}}},
    {"flat vertices", {{0, 1, 7}, {1, 2, 7}, {2, 3, 7}, {3, 4, 7}, {4, 5, 7}, {5, 6, 7}}},
    {"dart", {{0, 1, 3}, {1, 2, 3}}},
    {"comb", {{1, 2, 3}, {1, 3, 4}, {4, 5, 6}, {0, 1, 4}, {0, 4, 6}, {0, 6, 7}, {0, 7, 8}}},
    {"horseshoe", {{0, 1, 6}, {0, 6, 7}, {1, 2, 5}, {1, 5, 6}, {2, 3, 4}, {2, 4, 5}}},
    {"hole", {{0, 1, 4}, {1, 5, 4}, {1, 2, 5}, {5, 2, 6}, {2, 3, 6}, {3, 4, 6}, {3, 0, 4}}},
};

bool any_triangle(const Method& m, const Query& query, const Triangulation& t) {
  const auto& v = query.polygon().vertices;
  return std::any_of(t.triangles.begin(), t.triangles.end(), [&](const auto& i) {
    return m.ask({query.probe, Triangle{v[i[0]], v[i[1]], v[i[2]]}}).hit;
  });
}

TEST(PolygonRelations, ATriangulationOrEdIsThePolygon) {
  const Method& m = *find_method("sf-epick");
  int asked = 0, hits = 0;
  for (const char* name : {"polygon-affine", "polygon-in-plane", "polygon-scale"}) {
    for (std::uint64_t k = 0; k < 4'000; ++k) {
      const std::string_view shape = all_shapes()[k % shape_count].name;
      const auto* t = std::find_if(std::begin(triangulations), std::end(triangulations),
                                   [&](const Triangulation& row) { return row.shape == shape; });
      if (t == std::end(triangulations)) continue;
      const Query query = find_family(name)->make(Format::binary64, 11, k).query;
      const bool hit = m.ask(query).hit;
      EXPECT_EQ(hit, any_triangle(m, query, *t)) << name << " " << k << " " << shape;
      ++asked;
      hits += hit;
    }
  }
  EXPECT_GT(asked, 3'000);
  EXPECT_GT(hits, 1'000);
}

TEST(PolygonFuzz, FindsNothingOnExactMethodsAndReachesAllConstructions) {
  FuzzPlan plan = plan_for({"sf-epick", "sf-epeck"}, 0);
  plan.streams = {{find_family("polygon-affine"), Format::binary64}};
  plan.cases = 2 * approach_count * shape_count * place_count;
  const FuzzReport report = fuzz(plan);
  EXPECT_TRUE(report.findings.empty());
  Coverage coverage;
  report.counts.for_each([&](const Cell& c, const Count& count) { coverage.add(Format::binary64, c.slot, count); });
  const std::string text = coverage.to_text({});
  EXPECT_TRUE(
      text.starts_with("binary64 ring configurations 22/22, places x approaches 78/78, constructions 774/774, "
                       "constructions by rays 774/774"))
      << text;
  EXPECT_NE(text.find("binary32 ring configurations 0/22, places x approaches 0/78, constructions 0/774"),
            std::string::npos)
      << text;
}

/// Slots are written by name and read back; every construction has its own.
TEST(PolygonSlots, HaveNames) {
  EXPECT_EQ(all_constructions().size(), 774U);
  const SlotRange all = slots_of(Operands::polygons);
  EXPECT_EQ(all.size(), 2 * (774U + 9)) << "with segments and with rays";
  std::set<std::string> names;
  for (Slot slot = 1; slot < all.end; ++slot) {
    names.insert(slot_name(slot));
    EXPECT_EQ(slot_named(slot_name(slot)), slot);
    EXPECT_EQ(operands_of(slot), slot < all.first ? Operands::triangles : Operands::polygons);
  }
  EXPECT_EQ(names.size(), all.end - 1U);
  for (std::size_t i = 0; i < all_constructions().size(); ++i) EXPECT_EQ(index_of(all_constructions()[i]), i);
  EXPECT_EQ(slot_name(slot_of(Truth{.contact = Contact::edge, .planar = false})), "edge, not planar");
  EXPECT_EQ(slot_name(slot_of(Truth{.contact = Contact::coplanar})), "coplanar");
}

TEST(PolygonFuzz, ThreadsDoNotShow) {
  FuzzPlan plan = plan_for({"haines-double", "sf-float"}, 3'000);
  const FuzzReport one = fuzz(plan);
  plan.threads = 3;
  const FuzzReport three = fuzz(plan);
  EXPECT_EQ(one.counts, three.counts);
  ASSERT_EQ(one.findings.size(), three.findings.size());
  ASSERT_FALSE(one.findings.empty());
  for (std::size_t i = 0; i < one.findings.size(); ++i) EXPECT_EQ(one.findings[i].k, three.findings[i].k);
}

TEST(PolygonFuzz, CounterexamplesAreSmallAndReplay) {
  const FuzzPlan plan = plan_for({"haines-double", "feito-double", "sf-double"}, 2'800);
  const FuzzReport report = fuzz(plan);
  std::map<std::size_t, int> kept;
  for (const Finding& f : report.findings) {
    if (++kept[f.method] > 4) continue;
    const Case c = to_counterexample(plan, f);
    EXPECT_LE(c.query.polygon().vertices.size(), f.trial.query.polygon().vertices.size());
    EXPECT_LE(c.query.polygon().vertices.size(), 10U) << c.id;
    EXPECT_EQ(c.finding["answers"].size(), all_methods().size());
    EXPECT_EQ(c.finding["answers"][plan.methods[f.method].name], c.finding["answered"]);
    EXPECT_EQ(c.finding["answers"]["mt-double"], Json()) << "takes no polygons";
    EXPECT_EQ(c.finding["answers"]["sf-rational"], *c.expect ? 1 : 0);
    EXPECT_TRUE(c.finding["made_with"].contains("revision"));
    EXPECT_EQ(c.finding["origin"]["case"], f.k);
    bool wrong = false;
    EXPECT_NE(replay(c, {plan.methods[f.method]}, wrong).find("WRONG"), std::string::npos);
    EXPECT_TRUE(wrong);
    const Case again = to_case(parse_json(from_case(c).dump(), {"case", 1}), {"case", 1});
    EXPECT_EQ(again.query.polygon().vertices, c.query.polygon().vertices);
    const Query fixed = shrink(plan.methods[f.method], c.query, c.format);
    EXPECT_EQ(fixed.polygon().vertices, c.query.polygon().vertices) << "its own fixed point";
  }
  for (std::size_t m = 0; m < 3; ++m) EXPECT_GT(kept[m], 0) << plan.methods[m].name;
}

/// The method, with `change` applied to its answers on polygons.
template <class Change>
Method planted(const Change& change) {
  Method m = reference_method();
  m.polygon = [change](const Polygon& polygon) -> PreparedPolygon {
    const PreparedPolygon right = reference_method().polygon(polygon);
    const auto wrong = [change, right, polygon](const auto& probe, Answer answer) {
      change(probe, polygon, answer);
      return answer;
    };
    return {.segment = [right, wrong](const Segment& s) { return wrong(s, right.segment(s)); },
            .ray = [right, wrong](const Ray& r) { return wrong(r, right.ray(r)); }};
  };
  return m;
}

template <class Change>
std::size_t findings_with(const Change& change) {
  FuzzPlan plan = plan_for({}, 2'800);
  plan.methods = {planted(change)};
  return fuzz(plan).findings.size();
}

TEST(PolygonFuzz, FindsPlantedBugs) {
  EXPECT_EQ(findings_with([](const auto&, const Polygon&, Answer&) {}), 0U);
  EXPECT_GT(
      findings_with([](const auto&, const Polygon&, Answer& a) { a.hit = a.hit && a.contact != Contact::vertex; }), 0U)
      << "vertices excluded";
  EXPECT_GT(findings_with([](const auto&, const Polygon& polygon, Answer& a) {
              a.hit = a.hit && (a.contact != Contact::edge || polygon.rings() == 1);
            }),
            0U)
      << "hole edges excluded";
  EXPECT_GT(findings_with([](const auto&, const Polygon&, Answer& a) { a.planar = true; }), 0U)
      << "planar up to a tolerance";
  EXPECT_GT(findings_with([](const auto& probe, const Polygon& polygon, Answer& a) {
              const RationalKernel k;
              const std::size_t end = polygon.ring(0).size();
              a.hit = segura_feito(probe, Polygon{polygon.ring(0), {&end, 1}}, k).hit;
            }),
            0U)
      << "holes forgotten";
}

}  // namespace
}  // namespace tribunal
