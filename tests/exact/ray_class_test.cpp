// The 165 classes of a ray and a triangle: that there are no others, by two ways of counting that share nothing; and
// every exact method against the table.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <set>

#include "exact/classes/class_table.h"
#include "exact/kernels/integers.h"
#include "exact/methods/methods.h"
#include "exact/oracles/caratheodory.h"

namespace tribunal {
namespace {

using IntegerKernel = FormulaKernel<std::int64_t>;

std::vector<Point3> cube(int least, int most) {
  std::vector<Point3> points;
  for (int x = least; x <= most; ++x) {
    for (int y = least; y <= most; ++y) {
      for (int z = least; z <= most; ++z) points.emplace_back(x, y, z);
    }
  }
  return points;
}

TEST(RayClasses, HaveTheFrozenIds) {
  ASSERT_EQ(ray_class_table().size(), 165U);
  for (int i = 0; i < ray_class_count; ++i) {
    EXPECT_EQ(ray_class_table()[static_cast<std::size_t>(i)].id, class_count + 1 + i);
  }
  EXPECT_EQ(class_name(163), "C163");
  EXPECT_EQ(class_name(164), "R001");
  EXPECT_EQ(class_named("R165"), 328);
  for (const char* none : {"R000", "R166", "R17", "r017", "R0170", "Q001"}) EXPECT_EQ(class_named(none), 0) << none;
}

TEST(RayClasses, HoldTheirRepresentatives) {
  for (const ClassRow& row : ray_class_table()) {
    const Chirotope c = chirotope(row.representative_ray(), row.representative_triangle(), IntegerKernel{});
    EXPECT_EQ(ray_class_of(c), row.id);
    EXPECT_EQ(c.rank, row.rank) << class_name(row.id);
  }
}

/// All unordered triangles and origins of the points, with these directions: classes by signs, hits by Carathéodory
/// too.
std::map<ClassId, std::uint64_t> count_lattice(const std::vector<Point3>& v, const std::vector<Point3>& directions) {
  std::map<ClassId, std::uint64_t> counts;
  for (std::size_t a = 0; a < v.size(); ++a) {
    for (std::size_t b = a; b < v.size(); ++b) {
      for (std::size_t c = b; c < v.size(); ++c) {
        const Triangle t{v[a], v[b], v[c]};
        for (const Point3& o : v) {
          for (const Point3& d : directions) {
            const Ray r{o, {d}};
            const ClassId id = class_of(r, t, IntegerKernel{});
            ++counts[id];
            if (id == 0 || class_row(id).hit() != meets_by_caratheodory<std::int64_t>(r, t)) ++counts[0];
          }
        }
      }
    }
  }
  return counts;
}

TEST(RayClasses, AreCountedRightOnTheSmallLattice) {
  auto counts = count_lattice(cube(0, 2), cube(-1, 1));
  EXPECT_EQ(counts[0], 0U) << "a ray in no class, or one of which signs and Caratheodory differ";
  for (const ClassRow& row : ray_class_table()) EXPECT_EQ(counts[row.id], row.count_3) << class_name(row.id);
}

TEST(RayClasses, AreCountedRightOnTheLargeLattice) {
  if (std::getenv("TRIBUNAL_LONG") == nullptr) return;  // three minutes
  auto counts = count_lattice(cube(0, 3), cube(-2, 2));
  EXPECT_EQ(counts[0], 0U);
  for (const ClassRow& row : ray_class_table()) EXPECT_EQ(counts[row.id], row.count_4) << class_name(row.id);
}

/// 1 for an even permutation, −1 for an odd one.
int parity(const std::array<int, 5>& p) {
  int sign = 1;
  for (std::size_t i = 0; i < 5; ++i) {
    for (std::size_t j = 0; j < i; ++j) sign = p[j] > p[i] ? -sign : sign;
  }
  return sign;
}

Sign signed_by(int parity, std::int64_t x) { return parity > 0 ? sign_of(x) : -sign_of(x); }

/// Rank 4 from its one dependency: the sign of a basis is that of the coefficient of the element left out, with the
/// parity of moving it to the end.
TEST(RayClasses, OfRankFourAreAllFound) {
  std::set<ClassId> found;
  for (int signs = 0; signs < 243; ++signs) {
    std::array<int, 5> x;
    for (int i = 0, rest = signs; i < 5; ++i, rest /= 3) x[static_cast<std::size_t>(i)] = rest % 3 - 1;
    const auto [least, most] = std::minmax({x[0], x[1], x[2], x[3]});
    const bool adds_up = least < 0 ? most > 0 : most == 0;  // the last row: the points' coefficients add up to zero
    if (!adds_up || (most == 0 && x[4] == 0)) continue;
    ChirotopeCode code;
    for (int left_out = 4; left_out >= 0; --left_out) {
      code.append(signed_by(left_out % 2 == 0 ? 1 : -1, x[static_cast<std::size_t>(left_out)]));
    }
    const ClassId id = ray_class_of(code.of_rank(4));
    EXPECT_NE(id, 0);
    found.insert(id);
  }
  EXPECT_EQ(found.size(), 24U);
}

/// Rank 3 from its plane of dependencies (Gale's dual): one vector of the plane for each element, those of the four
/// points adding up to zero. The sign of a basis is that of the two vectors left out, with a parity.
TEST(RayClasses, OfRankThreeAreAllFound) {
  struct Plane {
    std::int64_t x, y;
  };
  std::vector<Plane> small, larger;
  for (int x = -4; x <= 4; ++x) {
    for (int y = -4; y <= 4; ++y) {
      larger.push_back({x, y});
      if (std::abs(x) < 4 && std::abs(y) < 4) small.push_back({x, y});
    }
  }
  struct Basis {
    int left_out[2], parity;
  };
  std::vector<Basis> bases;
  code_of<3>([&](const int(&s)[3]) {
    std::array<int, 5> order{s[0], s[1], s[2], 0, 0};
    int n = 3;
    for (int i = 0; i < 5; ++i) {
      if (std::ranges::find(s, i) == std::end(s)) order[static_cast<std::size_t>(n++)] = i;
    }
    bases.push_back({{order[3], order[4]}, parity(order)});
    return Sign::zero;
  });
  std::set<ClassId> found;
  for (const Plane& a : small) {
    for (const Plane& b : small) {
      for (const Plane& c : small) {
        if (std::tie(c.x, c.y) < std::tie(b.x, b.y) || std::tie(b.x, b.y) < std::tie(a.x, a.y)) continue;
        for (const Plane& d : larger) {
          const Plane g[5] = {a, b, c, {-a.x - b.x - c.x, -a.y - b.y - c.y}, d};
          ChirotopeCode code;
          for (const Basis& basis : bases) {
            const Plane &u = g[basis.left_out[0]], &v = g[basis.left_out[1]];
            code.append(signed_by(basis.parity, u.x * v.y - u.y * v.x));
          }
          if (!code.any()) continue;  // no plane
          const ClassId id = ray_class_of(code.of_rank(3));
          ASSERT_NE(id, 0);
          found.insert(id);
        }
      }
    }
  }
  EXPECT_EQ(found.size(), 110U);
}

TEST(RayClasses, OnALineAreAllFound) {
  std::set<ClassId> found;
  for (int places = 0; places < 256; ++places) {
    const auto at = [&](int shift) { return Point3(places >> shift & 3, 0, 0); };
    for (const double d : {-1.0, 0.0, 1.0}) {
      found.insert(class_of(Ray{at(0), {{d, 0, 0}}}, Triangle{at(2), at(4), at(6)}, IntegerKernel{}));
    }
  }
  EXPECT_EQ(found.count(0), 0U);
  EXPECT_EQ(found.size(), 31U) << "30 of rank 2, one of rank 1";
}

Point3 mapped(const Point3& p, const std::array<int, 3>& axis, int negatives) {
  Point3 r;
  for (int i = 0; i < 3; ++i) {
    const double x = p[axis[static_cast<std::size_t>(i)]];
    r[i] = (negatives >> i & 1) != 0 ? -x : x;
  }
  return r;
}

At at_of(const ClassRow& row) {
  if (row.intersection != "point") return At::unsaid;
  return row.touches.starts_with("origin") ? At::source : At::between;
}

class ExactMethodsOnRays : public testing::TestWithParam<const char*> {};

/// Compares hit, class, contact and at with the table, for 165 classes × 6 orders × 48 axis maps, with directions at
/// another scale than the triangle.
TEST_P(ExactMethodsOnRays, AnswerEveryClassInEveryOrderAndFrame) {
  const Method& method = *find_method(GetParam());
  int asked = 0;
  for (const ClassRow& row : ray_class_table()) {
    const Triangle t = row.representative_triangle();
    const Ray r = row.representative_ray();
    const std::array<Point3, 3> v{t.a, t.b, t.c};
    std::array<int, 3> axis{0, 1, 2};
    do {
      for (int negatives = 0; negatives < 8; ++negatives) {
        const auto map = [&](const Point3& p) { return mapped(p, axis, negatives); };
        std::array<std::size_t, 3> order{0, 1, 2};
        do {
          const Triangle u{map(v[order[0]]), map(v[order[1]]), map(v[order[2]])};
          for (const double length : {0x1p-1060, 0x1p-30, 1.0, 0x1p900}) {
            const Ray s{map(r.o), {length * map(r.d.v)}};
            const Answer answer = method.classify(s, u);
            ++asked;
            ASSERT_EQ(answer.class_id, row.id);
            ASSERT_EQ(answer.hit, row.hit()) << class_name(row.id);
            ASSERT_EQ(answer.contact, row.contact()) << class_name(row.id);
            ASSERT_EQ(answer.at, at_of(row)) << class_name(row.id);
            ASSERT_EQ(method.ray(s, u).hit, row.hit());
          }
        } while (std::next_permutation(order.begin(), order.end()));
      }
    } while (std::next_permutation(axis.begin(), axis.end()));
  }
  EXPECT_EQ(asked, 165 * 6 * 48 * 4);
}

INSTANTIATE_TEST_SUITE_P(Kernels, ExactMethodsOnRays,
                         testing::Values("sf-rational", "sf-filtered", "sf-epick", "sf-epeck", "sf-expansion"),
                         [](const auto& tested) { return std::string(tested.param).substr(3); });

}  // namespace
}  // namespace tribunal
