// Inside, outside or on the boundary: the same by every ray from a point, those through vertices and along edges and
// faces included, and equal to the winding number that integers give along vertical lines.
#include <cmath>
#include <string>

#include "exact/mesh/read_mesh.h"
#include "exact/mesh/topology.h"
#include "exact/mesh/triangulate.h"
#include "tests/tracer/nasty_scenes.h"
#include "tests/tracer/tree_support.h"

namespace tribunal {

namespace {

using testing::Random;

using Integer = __int128;

/// A point with integer coordinates below 2²².
struct Lattice {
  std::int64_t x, y, z;

  friend Lattice operator-(const Lattice& a, const Lattice& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend bool operator==(const Lattice&, const Lattice&) = default;
};

Lattice lattice(const Point3& p) {
  return {static_cast<std::int64_t>(p.x), static_cast<std::int64_t>(p.y), static_cast<std::int64_t>(p.z)};
}

Lattice cross(const Lattice& u, const Lattice& v) {
  return {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
}

Integer dot(const Lattice& u, const Lattice& v) { return Integer{u.x} * v.x + Integer{u.y} * v.y + Integer{u.z} * v.z; }

bool is_between(std::int64_t p, std::int64_t a, std::int64_t b) { return std::min(a, b) <= p && p <= std::max(a, b); }

bool is_on_edge(const Lattice& p, const Lattice& a, const Lattice& b) {
  return cross(b - a, p - a) == Lattice{0, 0, 0} && is_between(p.x, a.x, b.x) && is_between(p.y, a.y, b.y) &&
         is_between(p.z, a.z, b.z);
}

/// The oracle, a mesh with integer coordinates; it uses no code of the project.
class LatticeMesh {
 public:
  explicit LatticeMesh(const std::vector<Triangle>& triangles) {
    for (const Triangle& t : triangles) corners_.push_back({lattice(t.a), lattice(t.b), lattice(t.c)});
  }

  bool holds(const Lattice& p) const {
    return std::any_of(corners_.begin(), corners_.end(), [&](const auto& t) { return holds(t, p); });
  }

  /// The winding number about p, along the vertical line upwards from p: each triangle above p counts as often as its
  /// outline, seen from above, winds about p.
  int winding(const Lattice& p) const {
    int sum = 0;
    for (const auto& t : corners_) {
      const int flat = winds(p, t[0], t[1]) + winds(p, t[1], t[2]) + winds(p, t[2], t[0]);
      if (flat == 0) continue;
      const Integer above = dot(cross(t[1] - t[0], t[2] - t[0]), p - t[0]);
      if ((flat > 0) == (above < 0)) sum += flat;
    }
    return sum;
  }

 private:
  using Corners = std::array<Lattice, 3>;

  static bool holds(const Corners& t, const Lattice& p) {
    const Lattice n = cross(t[1] - t[0], t[2] - t[0]);
    if (dot(n, p - t[0]) != 0) return false;
    if (is_on_edge(p, t[0], t[1]) || is_on_edge(p, t[1], t[2]) || is_on_edge(p, t[2], t[0])) return true;
    for (int i = 0; i < 3; ++i) {
      if (dot(n, cross(t[(i + 1) % 3] - t[i], p - t[i])) <= 0) return false;
    }
    return true;
  }

  /// The contribution of one edge that passes to the right of p; the lower end belongs to the edge, the upper one
  /// does not.
  static int winds(const Lattice& p, const Lattice& a, const Lattice& b) {
    if ((a.y <= p.y) == (b.y <= p.y)) return 0;
    const std::int64_t side = (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
    return a.y <= p.y ? side > 0 : -(side < 0);
  }

  std::vector<Corners> corners_;
};

/// Even coordinates up to 2^bits, so that midpoints of edges are on the lattice too.
Mesh on_lattice(const std::string& name, int bits) {
  const std::string path = "data/meshes/" + name + ".off";
  Mesh mesh = triangulated(read_mesh(path), path);
  double size = 0;
  for (const Point3& v : mesh.vertices) size = std::max({size, std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
  for (Point3& v : mesh.vertices) {
    for (int i = 0; i < 3; ++i) v[i] = 2 * std::round(std::ldexp(v[i] / size, bits - 1));
  }
  return mesh;
}

/// The octahedron with all faces counterclockwise from outside.
Mesh outward_octahedron(const Point3& centre, double size) {
  Mesh mesh = testing::octahedron(centre, size).mesh;
  for (auto& t : mesh.triangles) {
    const int negative = (t[0] < 3) + (t[1] < 3) + (t[2] < 3);
    if (negative % 2 == 1) std::swap(t[1], t[2]);
  }
  return mesh;
}

/// A torus of squares, each cut in two: full of vertical faces, shared planes and collinear edges.
Mesh square_torus() {
  Mesh mesh;
  const int ring[4][2] = {{8, -4}, {16, -4}, {16, 4}, {8, 4}}, turn[4][2] = {{1, 1}, {-1, 1}, {-1, -1}, {1, -1}};
  for (const auto& t : turn) {
    for (const auto& r : ring) mesh.vertices.push_back({r[0] * t[0], r[0] * t[1], r[1]});
  }
  for (std::uint32_t i = 0; i < 4; ++i) {
    for (std::uint32_t k = 0; k < 4; ++k) {
      const std::uint32_t j = (i + 1) % 4, l = (k + 1) % 4;
      mesh.triangles.push_back({4 * i + k, 4 * j + k, 4 * j + l});
      mesh.triangles.push_back({4 * i + k, 4 * j + l, 4 * i + l});
    }
  }
  return mesh;
}

/// A second octahedron put over or into one of size 16, perhaps inside out.
Mesh two_octahedra(const Point3& centre, double size, bool inside_out) {
  Mesh mesh = outward_octahedron(Point3(0), 16);
  const Mesh other = outward_octahedron(centre, size);
  for (const Point3& v : other.vertices) mesh.vertices.push_back(v);
  for (const auto& [a, b, c] : other.triangles) {
    mesh.triangles.push_back({a + 6, inside_out ? c + 6 : b + 6, inside_out ? b + 6 : c + 6});
  }
  return mesh;
}

/// A tetrahedron with a vertex in the middle of an edge on one side only; a triangle without area fills the gap.
Mesh with_flat_triangle() {
  Mesh mesh;
  mesh.vertices = {{0, 0, 0}, {16, 0, 0}, {0, 16, 0}, {0, 0, 16}, {8, 0, 0}};
  mesh.triangles = {{0, 2, 1}, {0, 3, 2}, {1, 2, 3}, {0, 4, 3}, {4, 1, 3}, {0, 1, 4}};
  return mesh;
}

struct Named {
  std::string name;
  Mesh mesh;
};

std::vector<Named> closed_meshes() {
  std::vector<Named> all;
  for (const char* name : {"elephant", "knot1", "cow", "pinion", "sphere966", "hand", "3torus", "star"}) {
    for (const int bits : {6, 20}) all.push_back({name + std::to_string(bits), on_lattice(name, bits)});
  }
  all.push_back({"octahedron", outward_octahedron(Point3(2, 0, -4), 64)});
  all.push_back({"octahedron with faces either way", testing::octahedron(Point3(2, 0, -4), 64).mesh});
  all.push_back({"square torus", square_torus()});
  all.push_back({"octahedra that overlap, one inside out", two_octahedra({8, 0, 0}, 16, true)});
  all.push_back({"octahedra that overlap", two_octahedra({0, 0, 2}, 16, false)});
  all.push_back({"an octahedron twice", two_octahedra(Point3(0), 16, false)});
  all.push_back({"an octahedron in another", two_octahedra({0, 2, 0}, 10, false)});
  all.push_back({"with a flat triangle", with_flat_triangle()});
  return all;
}

std::vector<Triangle> triangles_of(const Mesh& mesh) {
  std::vector<Triangle> triangles;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) triangles.push_back(mesh.triangle(i));
  return triangles;
}

const Triangle& some(Random& random, const std::vector<Triangle>& triangles) {
  return triangles[random.below(triangles.size())];
}

Point3 small_step(Random& random, int most) {
  const int x = random.within(-most, most), y = random.within(-most, most), z = random.within(-most, most);
  return {x, y, z};
}

/// Draws a point: on a vertex or a midpoint, next to one, in the planes of many faces, or between some vertices.
Point3 draw_point(Random& random, const std::vector<Triangle>& triangles) {
  const Triangle& t = some(random, triangles);
  const Triangle& u = some(random, triangles);
  switch (random.below(8)) {
    case 0:
      return t.a;
    case 1:
      return 0.5 * (t.a + t.b);
    case 2:
    case 3:
      return 0.5 * (t.a + t.b) + small_step(random, 2);
    case 4:
      return {t.a.x, t.b.y, u.c.z};
    default: {
      const Point3 p = random.below(2) == 0 ? 0.5 * (t.a + u.b) : 0.25 * (t.a + t.b + u.b + u.c);
      return {std::floor(p.x), std::floor(p.y), std::floor(p.z)};
    }
  }
}

/// Draws a direction: exactly at a vertex, a midpoint of an edge or a point of a face; along an edge or an axis; any;
/// or zero.
Direction draw_direction(Random& random, const std::vector<Triangle>& triangles, const Point3& o) {
  const Triangle& t = some(random, triangles);
  Point3 axis(0);
  switch (random.below(8)) {
    case 0:
    case 1:
      return {t.a - o};
    case 2:
      return {t.a + t.b - 2.0 * o};
    case 3:
      return {t.a + t.b + t.c - 3.0 * o};
    case 4:
      return {t.b - t.a};
    case 5:
      axis[static_cast<int>(random.below(3))] = random.below(2) == 0 ? 1.0 : -1.0;
      return {random.below(8) == 0 ? Point3(0) : axis};
    default:
      return {random.point(1)};
  }
}

struct Counts {
  std::uint64_t rays = 0, wrong = 0, inside = 0, boundary = 0, winds_otherwise = 0;
};

/// Compares the oracle on a lattice mesh with the tree on the same mesh and points multiplied by a power of two.
void compare(const Mesh& mesh, int exponent, std::uint64_t seed, Counts& counts) {
  const std::vector<Triangle> triangles = triangles_of(mesh);
  const LatticeMesh oracle(triangles);
  const double scale = std::ldexp(1, exponent);
  std::vector<Triangle> scaled;
  for (const Triangle& t : triangles) scaled.push_back({scale * t.a, scale * t.b, scale * t.c});
  const TriangleTree tree(scaled);
  Random random(seed);
  const bool oriented = topology_of(mesh).oriented();
  constexpr std::size_t points = 60, rays_a_point = 84, together = 8;
  for (std::size_t i = 0; i < points; ++i) {
    const Point3 p = draw_point(random, triangles);
    const bool on_surface = oracle.holds(lattice(p));
    const int winding = on_surface ? 0 : oracle.winding(lattice(p));
    const Side side = on_surface ? Side::boundary : winding % 2 != 0 ? Side::inside : Side::outside;
    counts.inside += side == Side::inside;
    counts.boundary += on_surface;
    counts.winds_otherwise += winding != 0 && winding != 1;
    counts.wrong += tree.inside(scale * p) != side;
    std::vector<Ray> rays;
    while (rays.size() < rays_a_point) {
      const Direction d = draw_direction(random, triangles, p);
      rays.push_back({scale * p, {scale * d.v}});
    }
    std::vector<Parity> some_together(together);
    tree.parity(std::span(rays).first(together), some_together);
    for (std::size_t k = 0; k < rays.size(); ++k) {
      const Parity alone = tree.parity(rays[k]);
      ++counts.rays;
      counts.wrong += alone.on_surface != on_surface || (oriented && alone.winding != winding) ||
                      alone.crossings % 2 != static_cast<std::uint64_t>(side == Side::inside) ||
                      (k < together && some_together[k] != alone);
    }
  }
}

class ParityOf : public testing::OnEveryTarget {};

INSTANTIATE_TEST_SUITE_P(Targets, ParityOf, ::testing::ValuesIn(batch_targets()), testing::target_name);

TEST_P(ParityOf, EveryRayIsTheWindingNumber) {
  Counts counts;
  std::uint64_t seed = 900;
  for (const auto& [name, mesh] : closed_meshes()) {
    ASSERT_TRUE(topology_of(mesh).closed()) << name;
    const std::uint64_t before = counts.wrong;
    constexpr int exponents[] = {0, -1070, 0, 980};
    ++seed;
    compare(mesh, exponents[seed % 4], seed, counts);
    EXPECT_EQ(counts.wrong, before) << name;
  }
  EXPECT_GE(counts.rays, 100'000U);
  EXPECT_GT(counts.inside, 300U);
  EXPECT_GT(counts.boundary, 300U);
  EXPECT_GT(counts.winds_otherwise, 30U) << "overlapping or reversed parts";
}

TEST(Inside, IsToldOfManyPointsAndOfNoPoint) {
  const std::vector<Triangle> triangles = triangles_of(square_torus());
  const TriangleTree tree(triangles);
  const std::vector<Point3> points = {{12, 0, 0},           {0, 0, 0}, {16, 16, 4}, {12, 12, 0},
                                      {0, std::nan(""), 0}, {9, -9, 3}};
  std::vector<Side> sides(points.size());
  tree.inside(points, sides);
  using enum Side;
  EXPECT_EQ(sides, (std::vector<Side>{inside, outside, boundary, inside, outside, inside}));
  EXPECT_EQ(tree.parity({{12, 0, 0}, {{0, 0, 0}}}).crossings % 2, 1U) << "a ray without direction";
  EXPECT_EQ(TriangleTree({}).inside({0, 0, 0}), outside);
}

}  // namespace
}  // namespace tribunal
