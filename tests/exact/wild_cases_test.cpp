// Failures of published intersection code (data/cases/wild-cases.jsonl, with sources): every exact method must give
// the answer that was worked out by hand or in rationals for each.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <set>
#include <sstream>
#include <stdexcept>

#include "core/segura_feito.h"
#include "exact/base/files.h"
#include "exact/base/json.h"
#include "exact/kernels/rational_kernel.h"
#include "exact/methods/cgal_kernels.h"
#include "exact/methods/methods.h"
#include "exact/sweep/map.h"

namespace tribunal {
namespace {

std::vector<Json> wild_cases() {
  std::istringstream lines(read_file("data/cases/wild-cases.jsonl"));
  std::vector<Json> cases;
  for (std::string line; std::getline(lines, line);) cases.push_back(Json::parse(line));
  return cases;
}

const Json& wild_case(const std::vector<Json>& cases, const std::string& id) {
  const auto found = std::ranges::find_if(cases, [&](const Json& c) { return c["id"] == id; });
  if (found == cases.end()) throw std::runtime_error("no wild case " + id);
  return *found;
}

/// "f32": decimal, rounded to binary32. "f32hex": the bits of a binary32 number.
double number(const Json& x, const std::string& precision) {
  if (precision == "f32hex") {
    return static_cast<double>(
        std::bit_cast<float>(static_cast<std::uint32_t>(std::stoul(x.get<std::string>(), nullptr, 16))));
  }
  const double value = x.get<double>();
  return precision == "f32" ? to_binary32(value) : value;
}

Point3 point(const Json& p, const std::string& precision) {
  return {number(p[0], precision), number(p[1], precision), number(p[2], precision)};
}

Triangle triangle(const Json& t, const std::string& precision) {
  return {point(t[0], precision), point(t[1], precision), point(t[2], precision)};
}

Probe probe(const Json& c) {
  const auto precision = c["prec"].get<std::string>();
  if (c.contains("seg")) return Segment{point(c["seg"][0], precision), point(c["seg"][1], precision)};
  return Ray{point(c["ray"]["o"], precision), {point(c["ray"]["d"], precision)}};
}

/// The hand-made verdicts: "edge t=1.0", "interior+start t=0.0", "coplanar, …", "none (…)", "degenerate triangle;
/// none".
Contact contact_in(const std::string& verdict) {
  if (verdict.find("none") != std::string::npos) return Contact::none;
  for (const Contact c : {Contact::interior, Contact::edge, Contact::vertex, Contact::coplanar}) {
    if (verdict.starts_with(name_of(c))) return c;
  }
  throw std::logic_error("verdict: " + verdict);
}

std::vector<const Method*> exact_methods() {
  std::vector<const Method*> methods;
  for (const Method& m : all_methods()) {
    if (m.contract.exact) methods.push_back(&m);
  }
  return methods;
}

TEST(WildCases, EveryTriangleHasItsContactByEveryExactMethod) {
  int judged = 0, refused = 0;
  for (const Json& c : wild_cases()) {
    if (!c.contains("tris")) continue;
    for (std::size_t i = 0; i < c["tris"].size(); ++i) {
      const Contact expected = contact_in(c["exact_check"][i].get<std::string>());
      const Query query{probe(c), triangle(c["tris"][i], c["prec"].get<std::string>())};
      for (const Method* m : exact_methods()) {
        const Answer answer = m->ask(query);
        const std::string where = c["id"].get<std::string>() + " by " + m->name;
        if (answer.status != Status::ok) {
          ++refused;
          EXPECT_TRUE(m->name.starts_with("cgal-")) << where;
          continue;
        }
        ++judged;
        EXPECT_EQ(answer.hit, expected != Contact::none) << where;
        if (answer.contact != Contact::unsaid) {
          EXPECT_EQ(answer.contact, expected) << where;
        }
      }
    }
  }
  EXPECT_EQ(judged, 208);
  EXPECT_EQ(refused, 30) << "29 rays to cgal-epick, one degenerate triangle to cgal-epeck";
}

/// The faces that are hit, on which all exact Segura–Feito methods must agree.
std::vector<std::size_t> faces_hit(const Probe& p, const std::vector<Triangle>& faces) {
  std::vector<std::size_t> hit;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const bool expected = reference_method().ask({p, faces[i]}).hit;
    for (const Method* m : exact_methods()) {
      const Answer answer = m->ask({p, faces[i]});
      if (answer.status == Status::ok) {
        EXPECT_EQ(answer.hit, expected) << m->name;
      }
    }
    if (expected) hit.push_back(i);
  }
  return hit;
}

std::vector<Triangle> box(const Point3& lo, const Point3& hi) {
  const auto corner = [&](int i) {
    return Point3((i & 1) != 0 ? hi.x : lo.x, (i & 2) != 0 ? hi.y : lo.y, (i & 4) != 0 ? hi.z : lo.z);
  };
  constexpr int quads[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  std::vector<Triangle> faces;
  for (const auto& q : quads) {
    faces.push_back({corner(q[0]), corner(q[1]), corner(q[2])});
    faces.push_back({corner(q[0]), corner(q[2]), corner(q[3])});
  }
  return faces;
}

TEST(WildCases, OctahedronTopIsHitWhateverTheLabelling) {
  const auto cases = wild_cases();
  const Json& c = wild_case(cases, "radiance-2.15-octa");
  std::vector<Triangle> faces;
  for (const int x : {0, 1}) {
    for (const int y : {2, 3}) {
      for (const int z : {4, 5}) {
        const auto v = [&](int i) { return point(c["verts"][static_cast<std::size_t>(i)], "f64"); };
        for (const auto& order : {std::array{x, y, z}, {x, z, y}, {y, x, z}, {y, z, x}, {z, x, y}, {z, y, x}}) {
          faces.push_back({v(order[0]), v(order[1]), v(order[2])});
        }
      }
    }
  }
  EXPECT_EQ(faces_hit(probe(c), faces).size(), 48U) << "each of the eight faces, in each of six orders";
}

TEST(WildCases, MeshesAreHitWhereTheThreadsSay) {
  const auto cases = wild_cases();
  const Json& bindings = wild_case(cases, "libigl-py-78");
  std::vector<Triangle> faces;
  for (const Json& f : bindings["faces"]) {
    const auto v = [&](std::size_t i) { return point(bindings["verts"][f[i].get<std::size_t>()], "f64"); };
    faces.push_back({v(0), v(1), v(2)});
  }
  EXPECT_EQ(faces_hit(probe(bindings), faces), (std::vector<std::size_t>{0, 10}));

  const std::vector<Triangle> unit = box(Point3(-0.5), Point3(0.5));
  EXPECT_EQ(faces_hit(probe(wild_case(cases, "manifold-1")), unit).size(), 4U) << "two diagonals, two faces each";
  EXPECT_EQ(faces_hit(probe(wild_case(cases, "manifold-2")), unit).size() % 2, 0U) << "a vertical edge";
  EXPECT_GE(faces_hit(probe(wild_case(cases, "manifold-2")), unit).size(), 4U);
  EXPECT_GE(faces_hit(probe(wild_case(cases, "manifold-3")), unit).size(), 2U) << "closed sets: the silhouette is met";
  EXPECT_EQ(faces_hit(probe(wild_case(cases, "pyvista-4842")), box(Point3(0.0), Point3(10, 10, 6))).size(), 2U);
}

template <class K>
Sign rows_sign(const Json& rows) {
  return K{}.orient3d(Point3(0.0), point(rows[0], "f64"), point(rows[1], "f64"), Direction{point(rows[2], "f64")});
}

TEST(WildCases, OrientationPredicatesAreExact) {
  const auto cases = wild_cases();
  const Json& rows = wild_case(cases, "spirula-60")["rows"];
  EXPECT_EQ(rows_sign<RationalKernel>(rows), Sign::positive);
  EXPECT_EQ(rows_sign<EpickKernel>(rows), Sign::positive);
  EXPECT_EQ(rows_sign<EpeckKernel>(rows), Sign::positive);
  EXPECT_NE(rows_sign<FormulaKernel<double>>(rows), Sign::positive) << "the reported failure of double";

  const Json& pts = wild_case(cases, "danshapero-12")["pts"];
  const auto v = [&](std::size_t i) { return point(pts[i], "f64"); };
  EXPECT_EQ(RationalKernel{}.orient3d(v(0), v(1), v(2), v(3)), Sign::zero);
  EXPECT_EQ(EpickKernel{}.orient3d(v(2), v(3), v(0), v(1)), Sign::zero);
  EXPECT_EQ(EpeckKernel{}.orient3d(v(2), v(3), v(0), v(1)), Sign::zero);
}

struct GridCount {
  int wrong = 0, opposite = 0, falsely_collinear = 0;
};

/// Kettner et al.'s picture, moved as failure maps move points: 256 × 256 neighbours of p one ulp of 1/2 apart, double
/// against the exact sign.
GridCount naive_on_grid(const Json& c) {
  const auto flat = [](const Json& p) { return Point3(p[0].get<double>(), p[1].get<double>(), 0); };
  const Point3 p = flat(c["p"]), q = flat(c["q"]), r = flat(c["r"]);
  GridCount count;
  for (int i = 0; i < 256; ++i) {
    for (int j = 0; j < 256; ++j) {
      const Point3 moved = moved_on_map(p, Format::binary64, i, j);
      const Sign exact = RationalKernel{}.orient2d(Axis::z, moved, q, r);
      const Sign naive = FormulaKernel<double>{}.orient2d(Axis::z, moved, q, r);
      EXPECT_EQ(EpickKernel{}.orient2d(Axis::z, moved, q, r), exact);
      count.wrong += naive != exact;
      count.opposite += exact != Sign::zero && naive == -exact;
      count.falsely_collinear += exact != Sign::zero && naive == Sign::zero;
    }
  }
  return count;
}

TEST(WildCases, KettnerGridsFailInDoubleAsPublished) {
  const auto cases = wild_cases();
  const struct {
    const char* id;
    int wrong, opposite, falsely_collinear;
  } published[] = {{"kettner-grid-a", 11972, 672, 11300},
                   {"kettner-grid-b", 19776, 638, 19138},
                   {"kettner-grid-c", 10338, 920, 9418}};
  for (const auto& grid : published) {
    const GridCount count = naive_on_grid(wild_case(cases, grid.id));
    EXPECT_EQ(count.wrong, grid.wrong) << grid.id;
    EXPECT_EQ(count.opposite, grid.opposite) << grid.id;
    EXPECT_EQ(count.falsely_collinear, grid.falsely_collinear) << grid.id;
  }
}

}  // namespace
}  // namespace tribunal
