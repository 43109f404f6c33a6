// The 163 classes: the table against exhaustive counting, and every exact method against the table.
#include "exact/classes/class_table.h"

#include <gtest/gtest.h>

#include <array>
#include <map>

#include "exact/certificate/small_scope.h"
#include "exact/methods/methods.h"

namespace tribunal {
namespace {

using IntegerKernel = FormulaKernel<std::int64_t>;

std::vector<Point3> lattice(int side) {
  std::vector<Point3> points;
  for (int i = 0; i < side * side * side; ++i) points.emplace_back(i / side / side, i / side % side, i % side);
  return points;
}

TEST(ClassTable, HasTheFrozenIds) {
  ASSERT_EQ(class_table().size(), 163U);
  for (int i = 0; i < class_count; ++i) EXPECT_EQ(class_table()[static_cast<std::size_t>(i)].id, i + 1);
  EXPECT_EQ(class_name(17), "C017");
  EXPECT_EQ(class_named("C163"), 163);
  for (const char* none : {"C000", "C164", "C17", "c017", "C0170", "", "Cxyz"}) EXPECT_EQ(class_named(none), 0) << none;
}

TEST(ClassTable, EachRepresentativeIsInItsClass) {
  for (const ClassRow& row : class_table()) {
    const Chirotope c = chirotope(row.representative_segment(), row.representative_triangle(), IntegerKernel{});
    EXPECT_EQ(class_of(c), row.id);
    EXPECT_EQ(c.rank, row.rank) << class_name(row.id);
  }
}

/// The number of unordered tuples of {0,1,2}³ in each class, against the table's own column.
TEST(ClassTable, CountsOfTheSmallLatticeAreRight) {
  const std::vector<Point3> v = lattice(3);
  std::map<ClassId, std::uint64_t> counts;
  for (std::size_t a = 0; a < v.size(); ++a) {
    for (std::size_t b = a; b < v.size(); ++b) {
      for (std::size_t c = b; c < v.size(); ++c) {
        for (std::size_t p = 0; p < v.size(); ++p) {
          for (std::size_t q = p; q < v.size(); ++q) {
            ++counts[class_of(chirotope(Segment{v[p], v[q]}, {v[a], v[b], v[c]}, IntegerKernel{}))];
          }
        }
      }
    }
  }
  EXPECT_EQ(counts[0], 0U) << "a tuple in no class";
  for (const ClassRow& row : class_table()) EXPECT_EQ(counts[row.id], row.count_3) << class_name(row.id);
}

class ExactMethods : public testing::TestWithParam<const char*> {};

Point3 mapped(const Point3& p, const std::array<int, 3>& axis, int negatives) {
  Point3 r;
  for (int i = 0; i < 3; ++i) {
    const double x = p[axis[static_cast<std::size_t>(i)]];
    r[i] = (negatives >> i & 1) != 0 ? -x : x;
  }
  return r;
}

At at_of(const ClassRow& row, bool source_touches) {
  if (row.intersection != "point") return At::unsaid;
  if (row.touches.starts_with("int")) return At::between;
  return source_touches ? At::source : At::target;
}

/// Compares hit, class, contact and at with the table, for 163 classes × 12 orders × 48 axis maps.
TEST_P(ExactMethods, AnswerEveryClassInEveryOrderAndFrame) {
  const Method& method = *find_method(GetParam());
  int asked = 0;
  for (const ClassRow& row : class_table()) {
    const Triangle t = row.representative_triangle();
    const Segment s = row.representative_segment();
    const bool p_touches = reference_method().segment(Segment{s.p, s.p}, t).hit;
    const std::array<Point3, 3> v{t.a, t.b, t.c};
    std::array<int, 3> axis{0, 1, 2};
    do {
      for (int negatives = 0; negatives < 8; ++negatives) {
        const auto map = [&](const Point3& p) { return mapped(p, axis, negatives); };
        std::array<std::size_t, 3> order{0, 1, 2};
        do {
          const Triangle u{map(v[order[0]]), map(v[order[1]]), map(v[order[2]])};
          for (const bool reversed : {false, true}) {
            const Segment r = reversed ? Segment{map(s.q), map(s.p)} : Segment{map(s.p), map(s.q)};
            const Answer answer = method.classify(r, u);
            ++asked;
            ASSERT_EQ(answer.class_id, row.id);
            ASSERT_EQ(answer.hit, row.hit()) << class_name(row.id);
            ASSERT_EQ(answer.contact, row.contact()) << class_name(row.id);
            const bool both_ends = s.p == s.q;
            ASSERT_EQ(answer.at, at_of(row, both_ends || p_touches != reversed)) << class_name(row.id);
            ASSERT_EQ(method.segment(r, u).hit, row.hit());
          }
        } while (std::next_permutation(order.begin(), order.end()));
      }
    } while (std::next_permutation(axis.begin(), axis.end()));
  }
  EXPECT_EQ(asked, 93'888);
}

INSTANTIATE_TEST_SUITE_P(Kernels, ExactMethods,
                         testing::Values("sf-rational", "sf-filtered", "sf-epick", "sf-epeck", "sf-expansion"),
                         [](const auto& tested) { return std::string(tested.param).substr(3); });

/// CGAL's own test within its preconditions, and what lies outside them.
TEST(CgalPeers, AgreeWhereTheirPreconditionsHold) {
  for (const char* name : {"cgal-epick", "cgal-epeck"}) {
    const Method& method = *find_method(name);
    for (const ClassRow& row : class_table()) {
      const Answer answer = method.segment(row.representative_segment(), row.representative_triangle());
      const bool regular = row.triangle == "tri" && row.probe == "seg";
      ASSERT_EQ(answer.status, regular ? Status::ok : Status::unsupported) << name << class_name(row.id);
      if (regular) {
        EXPECT_EQ(answer.hit, row.hit()) << name << class_name(row.id);
      }
    }
  }
}

TEST(SmallScope, SeesAPlantedBug) {
  Method bad = *find_method("sf-double");
  bad.segment = [](const Segment& s, const Triangle& t) {
    const Answer answer = find_method("sf-double")->segment(s, t);
    return answer.contact == Contact::vertex ? miss() : answer;
  };
  const ScopeResult good = pocket_run(*find_method("sf-double"));
  const ScopeResult result = pocket_run(bad);
  EXPECT_EQ(good.count.wrong, 0U);
  EXPECT_EQ(good.classes, 163);
  EXPECT_EQ(result.count.wrong, 2U * 12 * 48) << "C014 and C017 touch a vertex";
  EXPECT_NE(result.answers_hash, good.answers_hash);
}

TEST(SmallScope, ThreadsDoNotShow) {
  const Method& method = *find_method("mt-float");
  const ScopeResult one = lattice_run(method, 2, 1), seven = lattice_run(method, 2, 7);
  EXPECT_EQ(one.size, 32768U);
  EXPECT_TRUE(one.complete);
  EXPECT_EQ(one.answers_hash, seven.answers_hash);
  EXPECT_EQ(one.count, seven.count);
}

}  // namespace
}  // namespace tribunal
