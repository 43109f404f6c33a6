// Where a miss is a leak and where it is not: the outline, decided exactly.
#include <gmpxx.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numeric>

#include "exact/cases/families/draw.h"
#include "exact/methods/methods.h"
#include "tracer/leak/judge.h"
#include "tracer/leak/nearness.h"

namespace tribunal::leak {
namespace {

/// What is said of a subject that reports these faces, and no t.
Verdict verdict_on(const Surface& surface, const Ray& ray, const std::vector<std::uint32_t>& reported,
                   const Contract& contract = {.convention = Convention::transversal}) {
  std::vector<std::uint32_t> every(surface.face_count());
  std::iota(every.begin(), every.end(), 0u);
  const AimedRay aimed{ray, Aim::face, 0};
  const RayTruth truth = truth_of(surface, aimed, every);
  EXPECT_FALSE(truth.on_surface);
  Testimony said{.hits = std::vector<Reported>()};
  for (const std::uint32_t f : reported) said.hits->push_back({f});
  return judge(surface, {.name = "named faces", .contract = contract, .told = ""}, aimed, truth, said);
}

bool leaks(const Surface& surface, const Ray& ray, const std::vector<std::uint32_t>& reported = {}) {
  return verdict_on(surface, ray, reported).outcomes.has(Outcome::leak);
}

bool passes_outline(const Surface& surface, const Ray& ray, const std::vector<std::uint32_t>& reported = {}) {
  return verdict_on(surface, ray, reported).outcomes.has(Outcome::outline);
}

/// Two faces of cow.off that share an edge, seen as outline by the ray below, closed by two more.
Mesh ridge() {
  return {{{0.0646978, -0.108982, 0.0672886},
           {0.0529241, -0.0875121, 0.072648},
           {0.0415963, -0.0977991, 0.0552322},
           {0.0788748, -0.110769, 0.0596696}},
          {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}};
}

/// Ray 134326 of the trial with seed 1 on cow.off: aimed at the mirror image of the edge 0 2, and so nearly at that
/// edge.
Ray ray_at_ridge() {
  return {{0x1.09008f71f86aep-4, -0x1.be63e8dda48b6p-4, 0x1.19daa72b15c12p-4},
          {{-0x1.7a7eb6bf444dfp-13, 0x1.6e70f6e320ccp-14, -0x1.108facf146c91p-8}}};
}

/// In exact arithmetic the ray meets both faces of the edge, 10⁻²⁰ from it. One edge function of woop-double has the
/// wrong sign, in both faces alike, so it sees the ray pass beside the edge; and as one face looks towards the source
/// and one away, beside the surface. The outline is not the one that the ray was aimed at.
TEST(Outline, AMissBesideAnOutlineThatWasNotAimedAtIsNoLeak) {
  const Surface surface(ridge(), Format::binary64, "ridge");
  const Method woop = *find_method("woop-double"), exact = flagship_method();
  for (const std::uint32_t f : {0u, 1u}) {
    EXPECT_TRUE(exact.ray(ray_at_ridge(), surface.triangle(f)).hit);
    EXPECT_FALSE(woop.ray(ray_at_ridge(), surface.triangle(f)).hit);
  }
  EXPECT_FALSE(leaks(surface, ray_at_ridge()));
  EXPECT_TRUE(passes_outline(surface, ray_at_ridge()));
  const Verdict of_exact = verdict_on(surface, ray_at_ridge(), {}, {.exact = true});
  EXPECT_TRUE(of_exact.outcomes.has(Outcome::leak)) << "nothing excuses an exact test";
}

Mesh octahedron() {
  return {{{2, 0, 0}, {-2, 0, 0}, {0, 2, 0}, {0, -2, 0}, {0, 0, 2}, {0, 0, -2}},
          {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
}

constexpr double ulp_of_8 = 0x1p-49;

/// Straight down from 8, at the middle of the outline's edge between (2, 0, 0) and (0, 2, 0), `ulps` within it.
Ray down_beside_outline(double ulps) { return {{1 - ulps * ulp_of_8, 1 - ulps * ulp_of_8, 8}, {{0, 0, -1}}}; }

TEST(Outline, AnOutlineIsSixteenUlpsWide) {
  const Surface surface(octahedron(), Format::binary64, "octahedron");
  for (const double ulps : {1, 8, 11}) {  // times √2
    EXPECT_TRUE(passes_outline(surface, down_beside_outline(ulps))) << ulps;
    EXPECT_FALSE(leaks(surface, down_beside_outline(ulps))) << ulps;
  }
  EXPECT_TRUE(leaks(surface, down_beside_outline(12)));
  EXPECT_TRUE(leaks(surface, down_beside_outline(1000)));
  EXPECT_FALSE(leaks(surface, down_beside_outline(1000), {0, 4}));
  EXPECT_TRUE(leaks(surface, down_beside_outline(1000), {0})) << "it leaves through the other face";
}

/// Edges and vertices whose faces all look towards the source are no outline, however near.
TEST(Outline, AMissBesideAnInnerEdgeOrVertexIsALeak) {
  const Surface surface(octahedron(), Format::binary64, "octahedron");
  for (const double x : {0.0, ulp_of_8, -3 * ulp_of_8}) {
    for (const double y : {0.0, ulp_of_8 / 8, 0.5}) {
      const Ray ray{{x, y, 8}, {{0, 0, -1}}};
      EXPECT_TRUE(leaks(surface, ray)) << x << " " << y;
      EXPECT_FALSE(passes_outline(surface, ray));
    }
  }
}

/// A house with two flat roofs, the left one higher, from y = −1 to 1. The wall between runs from x = 0 at the top to
/// `lean` at the lower roof.
Mesh steps(double lean) {
  const std::array<std::array<double, 2>, 6> profile{{{-1, 0}, {1, 0}, {1, 0.5}, {lean, 0.5}, {0, 1}, {-1, 1}}};
  Mesh mesh;
  for (const double y : {-1.0, 1.0}) {
    for (const auto& [x, z] : profile) mesh.vertices.push_back({x, y, z});
  }
  for (std::uint32_t i = 0; i < 6; ++i) {
    const std::uint32_t j = (i + 1) % 6;
    mesh.triangles.push_back({i, j + 6, j});
    mesh.triangles.push_back({i, i + 6, j + 6});
  }
  for (std::uint32_t i = 1; i < 5; ++i) {
    mesh.triangles.push_back({0, i, i + 1});
    mesh.triangles.push_back({6, i + 7, i + 6});
  }
  return mesh;
}

/// A wall that is seen edge-on has roofs on both sides: what rounding may take for a way beside it meets one of them.
TEST(Outline, AWallSeenEdgeOnIsNoOutlineWhereTheSurfaceGoesOn) {
  constexpr double lean = 6 * ulp_of_8;
  const Ray ray{{lean / 2, 0.3, 8}, {{0, 0, -1}}};
  const Surface surface(steps(lean), Format::binary64, "steps");
  ASSERT_TRUE(surface.topology().oriented());
  const std::uint32_t wall[] = {6, 7}, upper[] = {8, 9}, lower[] = {4, 5};
  EXPECT_TRUE(leaks(surface, ray));
  for (const auto& faces : {wall, upper, lower}) {
    const bool first_or_second = !leaks(surface, ray, {faces[0], 0}) || !leaks(surface, ray, {faces[1], 0});
    EXPECT_TRUE(first_or_second) << faces[0];
  }
}

/// Leaning over, it is met from behind, between two roofs that are met too: three places, of which one is enough.
TEST(Outline, OfAFoldWithinRoundingOneFaceIsEnough) {
  constexpr double lean = -6 * ulp_of_8;
  const Ray ray{{lean / 2, 0.3, 8}, {{0, 0, -1}}};
  const Surface surface(steps(lean), Format::binary64, "steps");
  std::vector<std::uint32_t> met;
  for (std::uint32_t f = 0; f < surface.face_count(); ++f) {
    if (flagship_method().ray(ray, surface.triangle(f)).hit) met.push_back(f);
  }
  ASSERT_EQ(met.size(), 4u) << "floor, lower roof, wall, upper roof";
  const std::uint32_t floor = met[0];
  EXPECT_TRUE(leaks(surface, ray));
  EXPECT_TRUE(leaks(surface, ray, {floor}));
  for (std::size_t i = 1; i < 4; ++i) {
    EXPECT_FALSE(leaks(surface, ray, {floor, met[i]})) << met[i];
    EXPECT_TRUE(leaks(surface, ray, {met[i]})) << "the floor";
  }
  const Surface wide(steps(-600 * ulp_of_8), Format::binary64, "wide steps");
  const Ray through{{-300 * ulp_of_8, 0.3, 8}, {{0, 0, -1}}};
  EXPECT_TRUE(leaks(wide, through, {floor, met[1]})) << "no rounding takes three faces for one here";
}

/// From a source within rounding of the surface a test may see itself on the other side of it.
TEST(Outline, NothingIsDueOfARayThatStartsWithinRounding) {
  const Surface surface(octahedron(), Format::binary64, "octahedron");
  const auto above = [](double gap) { return Ray{{0.5, 0.5, 1 + gap}, {{0, 0, -1}}}; };
  EXPECT_FALSE(leaks(surface, above(8 * 0x1p-52)));
  EXPECT_TRUE(leaks(surface, above(1000 * 0x1p-52)));
}

using Vector = std::array<mpq_class, 3>;

Vector exact(const Point3& p) { return {p.x, p.y, p.z}; }
Vector minus(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
mpq_class dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// 16 units in the last place of the largest coordinate, which is in [4, 8).
const mpq_class limit = 16 * 0x1p-50;

/// By Pythagoras.
bool is_near(const Ray& ray, const Point3& p) {
  const Vector k = minus(exact(p), exact(ray.o)), d = exact(ray.d.v);
  const mpq_class along = dot(k, d);
  return along >= 0 && dot(k, k) - along * along / dot(d, d) <= limit * limit;
}

/// By the two parameters of the closest points, from the normal equations.
bool is_near(const Ray& ray, const Point3& a, const Point3& b) {
  const Vector d = exact(ray.d.v), e = minus(exact(b), exact(a)), k = minus(exact(a), exact(ray.o));
  const mpq_class dd = dot(d, d), ee = dot(e, e), de = dot(d, e), dk = dot(d, k), ek = dot(e, k);
  const mpq_class det = dd * ee - de * de;
  if (det == 0) return false;
  const mpq_class t = (ee * dk - de * ek) / det, u = (de * dk - dd * ek) / det;
  if (t < 0 || u < 0 || u > 1) return false;
  Vector gap;
  for (std::size_t i = 0; i < 3; ++i) gap[i] = k[i] + u * e[i] - t * d[i];
  return dot(gap, gap) <= limit * limit;
}

double small(Draw& draw) { return static_cast<double>(draw.between(-16, 16)) / 8; }

TEST(Outline, NearnessIsExact) {
  std::array<int, 2> points{}, edges{};
  for (std::uint64_t k = 0; k < 20000; ++k) {
    Draw draw(stream_of("leak rays"), 1, k);
    Ray ray;
    Point3 a, e;
    for (int i = 0; i < 3; ++i) {
      ray.o[i] = i == 0 ? 7 : small(draw);
      a[i] = small(draw);
      e[i] = small(draw);
    }
    const double share = static_cast<double>(draw.below(5)) / 4, side = draw.below(8) == 0 ? -1 : 1;
    ray.d.v = side * (a + share * e - ray.o);
    const Point3 b = a + e;
    const int axis = static_cast<int>(draw.below(3));
    ray.o[axis] += static_cast<double>(draw.between(-24, 24)) * 0x1p-50;
    if (ray.d.v == Point3(0) || ray.o.x < 6.9 || ray.o.x >= 7.9) continue;
    const Nearness near(ray, Format::binary64);
    ASSERT_EQ(near.has(a), is_near(ray, a)) << k;
    ASSERT_EQ(near.has(a, b), is_near(ray, a, b)) << k;
    ++points[near.has(a)];
    ++edges[near.has(a, b)];
  }
  EXPECT_GT(std::min(points[0], points[1]), 1000);
  EXPECT_GT(std::min(edges[0], edges[1]), 1000);
}

}  // namespace
}  // namespace tribunal::leak
