// Triangulation by a sweep line, held against ear clipping on small faces, and against the face's own edges and area,
// exactly, on great ones.
#include "exact/mesh/sweep_triangles.h"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <cmath>
#include <ctime>
#include <map>
#include <numeric>

#include "exact/mesh/triangulate.h"
#include "tests/exact/mesh/ear_clipping.h"
#include "tests/exact/mesh/lattice_faces.h"

namespace tribunal {
namespace {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;
using Edges = std::map<std::pair<std::uint32_t, std::uint32_t>, int>;

std::optional<Triangles> swept(const Rings& face, const std::vector<Point3>& points) {
  return sweep_triangles(flattened(face, points));
}

mpq_class area(const Point3& a, const Point3& b, const Point3& c) {
  const mpq_class x(a.x), y(a.y);
  return mpq_class((b.x - x) * (c.y - y) - (b.y - y) * (c.x - x));
}

/// Counts an edge; one that is passed both ways is none.
void pass(Edges& edges, std::uint32_t from, std::uint32_t to) {
  const auto [low, high] = std::minmax(from, to);
  if (low == high) return;
  int& count = edges[{low, high}];
  count += from == low ? 1 : -1;
  if (count == 0) edges.erase({low, high});
}

/// The edges of the triangles that no other triangle passes the other way.
Edges outline_of(const Triangles& triangles) {
  Edges edges;
  for (const auto& t : triangles) {
    for (std::size_t i = 0; i < 3; ++i) pass(edges, t[i], t[(i + 1) % 3]);
  }
  return edges;
}

bool lies_between(const Point3& x, const Point3& a, const Point3& b) {
  return std::min(a.x, b.x) <= x.x && x.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= x.y &&
         x.y <= std::max(a.y, b.y) && area(a, b, x) == 0;
}

/// The edges of a face, in parts between the places that lie on them. Cost: the square of the number of places.
Edges parts_of(const FlatFace& face) {
  Edges edges;
  for (const auto& [from, to] : face.edges) {
    const auto [low, high] = std::minmax(from, to);
    std::uint32_t last = low;
    for (std::uint32_t x = low + 1; x <= high; ++x) {
      if (!lies_between(face.places[x], face.places[low], face.places[high])) continue;
      from == low ? pass(edges, last, x) : pass(edges, x, last);
      last = x;
    }
  }
  return edges;
}

Edges edges_of(const FlatFace& face) {
  Edges edges;
  for (const auto& [from, to] : face.edges) pass(edges, from, to);
  return edges;
}

/// That the triangles have area, are bounded by the face's own edges, and have together the area of its rings. No two
/// overlap then: they wind around each point as often as their common outline does, which is once or not at all.
void expect_face(const FlatFace& face, const Triangles& triangles, const Edges& edges) {
  mpq_class of_triangles = 0, of_edges = 0;
  for (const auto& t : triangles) {
    const mpq_class one = area(face.places[t[0]], face.places[t[1]], face.places[t[2]]);
    ASSERT_GT(one, 0);
    of_triangles += one;
  }
  for (const auto& [from, to] : face.edges) of_edges += area(Point3(0), face.places[from], face.places[to]);
  EXPECT_EQ(of_triangles, of_edges);
  EXPECT_EQ(outline_of(triangles), edges);
}

bool lies_inside(const Point3& x, const Point3& a, const Point3& b, const Point3& c) {
  return area(a, b, x) >= 0 && area(b, c, x) >= 0 && area(c, a, x) >= 0;
}

void expect_empty_triangles(const FlatFace& face, const Triangles& triangles) {
  for (const auto& t : triangles) {
    for (std::uint32_t x = 0; x < face.places.size(); ++x) {
      if (x == t[0] || x == t[1] || x == t[2]) continue;
      ASSERT_FALSE(lies_inside(face.places[x], face.places[t[0]], face.places[t[1]], face.places[t[2]])) << x;
    }
  }
}

TEST(SweepTriangles, TileWhatEarClippingTiles) {
  Draw draw(9, 3, 0);
  int both = 0, refused = 0, more = 0;
  for (int i = 0; i < 20'000; ++i) {
    const Face face = draw_face(draw, i % 4 == 0 ? 1 + i / 4 % 2 : 0);
    const auto by_ears = clip_ears(face.indices, face.points);
    const FlatFace flat = flattened(face.indices, face.points);
    const auto by_sweep = sweep_triangles(flat);
    // Of a ring without area ear clipping sees no crossing.
    ASSERT_TRUE(by_sweep || !by_ears || by_ears->empty()) << face.words();
    if (!by_sweep) {
      ++refused;
      continue;
    }
    (by_ears ? both : more) += 1;
    expect_face(flat, *by_sweep, parts_of(flat));
    expect_empty_triangles(flat, *by_sweep);
    Triangles named = *by_sweep;
    for (auto& t : named) t = {flat.corners[t[0]], flat.corners[t[1]], flat.corners[t[2]]};
    expect_tiles(face, named);
    if (by_ears) expect_tiles(face, *by_ears);
    if (HasFailure()) FAIL() << face.words();
  }
  EXPECT_GT(both, 2500);
  EXPECT_GT(refused, 2500);
  EXPECT_GT(more, 0);
}

/// A path there and back has no inside; an eight has one side too many.
TEST(SweepTriangles, OfARingWithoutAreaThereAreNone) {
  for (const Point3& up : {Point3(0, 0, 1), Point3(0, 1, 0), Point3(1, 0, 0)}) {
    const Point3 right(up.y, up.z, up.x);
    const std::vector<Point3> path = {Point3(0), right, right + up};
    const auto triangles = swept({{0, 1, 2, 1}}, path);
    ASSERT_TRUE(triangles);
    EXPECT_TRUE(triangles->empty());
    const std::vector<Point3> eight = {Point3(0), right, up, -right, -up};
    EXPECT_FALSE(swept({{0, 1, 2, 0, 4, 3}}, eight));
  }
}

/// Two edges cross at (4, 4), between them two others end, and yet the ring winds around each point once or not at all.
TEST(SweepTriangles, EdgesThatCrossAtACornerOfOthersAreRefused) {
  Face face;
  face.add({{0, 0}, {8, 8}, {8, 12}, {0, 12}, {0, 8}, {8, 0}, {8, 4}, {4, 4}, {0, 4}},
           {Point3(1, 0, 0), Point3(0, 1, 0)});
  EXPECT_FALSE(swept(face.indices, face.points));
  EXPECT_FALSE(clip_ears(face.indices, face.points));
}

/// Squares of a lattice: rings that touch at corners, holes, holes that touch, and edges with the face on both sides.
TEST(SweepTriangles, TileUnionsOfCells) {
  Draw draw(9, 4, 0);
  int with_holes = 0;
  for (int i = 0; i < 4000; ++i) {
    constexpr std::int64_t side = 5;
    std::array<std::array<bool, side + 2>, side + 2> cells{};
    mpq_class due = 0;
    for (std::size_t x = 1; x <= side; ++x) {
      for (std::size_t y = 1; y <= side; ++y) {
        cells[x][y] = draw.below(3) > 0;
        due += cells[x][y] ? 2 : 0;
      }
    }
    FlatFace face;
    for (int x = 0; x <= side; ++x) {
      for (int y = 0; y <= side; ++y) face.places.emplace_back(x, y, 0);
    }
    const auto at = [](std::size_t x, std::size_t y) { return static_cast<std::uint32_t>(x * (side + 1) + y); };
    for (std::size_t x = 0; x <= side; ++x) {
      for (std::size_t y = 0; y < side; ++y) {
        if (cells[x][y + 1]) face.edges.push_back({at(x, y), at(x, y + 1)});
        if (cells[x + 1][y + 1]) face.edges.push_back({at(x, y + 1), at(x, y)});
        if (cells[y + 1][x]) face.edges.push_back({at(y + 1, x), at(y, x)});
        if (cells[y + 1][x + 1]) face.edges.push_back({at(y, x), at(y + 1, x)});
      }
    }
    with_holes += !cells[3][3] && cells[2][3] && cells[4][3] && cells[3][2] && cells[3][4];
    const auto triangles = sweep_triangles(face);
    ASSERT_TRUE(triangles);
    expect_face(face, *triangles, edges_of(face));
    expect_empty_triangles(face, *triangles);
    ASSERT_FALSE(HasFailure());
    mpq_class sum = 0;
    for (const auto& t : *triangles) sum += area(face.places[t[0]], face.places[t[1]], face.places[t[2]]);
    ASSERT_EQ(sum, due);
  }
  EXPECT_GT(with_holes, 100);
}

// --- great faces -------------------------------------------------------------------------------------------------

using Outline3 = std::vector<Point3>;

Outline3 parabola(int n) {
  Outline3 ring;
  for (int i = 0; i < n; ++i) ring.emplace_back(i, static_cast<double>(i) * i, 0);
  return ring;
}

/// Teeth upwards from a base.
Outline3 comb(int n) {
  Outline3 ring;
  for (int i = 0; i < n - 2; ++i) ring.emplace_back(i, i % 2 == 0 ? 0 : 1000, 0);
  ring.emplace_back(n, -10, 0);
  ring.emplace_back(-1, -10, 0);
  return ring;
}

Outline3 turned(Outline3 ring) {
  for (Point3& p : ring) p = {-p.y, p.x, p.z};
  return ring;
}

Outline3 scaled(Outline3 ring, double x, double y) {
  for (Point3& p : ring) p = {p.x * x, p.y * y, 0};
  return ring;
}

/// A band that goes around some hundred times.
Outline3 spiral(int n) {
  Outline3 ring;
  const auto add = [&](double radius, int i) {
    const double angle = 100 * M_PI * i / n;
    ring.emplace_back((radius + angle) * std::cos(angle), (radius + angle) * std::sin(angle), 0);
  };
  for (int i = 0; i < n / 2; ++i) add(10, 4 * i);
  for (int i = n / 2; i-- > 0;) add(12, 4 * i);
  return ring;
}

/// Spikes a few ulps wide at their tips, from a circle to one that is 2³⁰ times greater.
Outline3 star(int n) {
  Outline3 ring;
  for (int i = 0; i < n / 2; ++i) {
    const double angle = 4 * M_PI * i / n;
    const Point3 foot(std::cos(angle), std::sin(angle), 0);
    ring.push_back(foot);
    ring.emplace_back(foot.x * 0x1p30 - foot.y * 0x1p-20, foot.y * 0x1p30 + foot.x * 0x1p-20, 0);
  }
  return ring;
}

/// Around the origin, at distances of all exponents.
Outline3 wild(int n) {
  Draw draw(9, 5, 0);
  Outline3 ring;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * M_PI * i / n;
    const int e = static_cast<int>(draw.below(2000)) - 1000;
    ring.emplace_back(std::ldexp(std::cos(angle), e), std::ldexp(std::sin(angle), e), 0);
  }
  return ring;
}

/// There and back along one line, to ever nearer places, and once around above it.
Outline3 zigzag(int n) {
  Outline3 ring;
  for (int i = 0; i < n / 2; ++i) {
    ring.emplace_back(i, 0, 0);
    ring.emplace_back(n - i, 0, 0);
  }
  ring.emplace_back(n, n, 0);
  return ring;
}

struct Shape {
  const char* name;
  Outline3 (*make)(int);
  bool simple = true;
};

const Shape shapes[] = {
    {"parabola", parabola},
    {"comb", comb},
    {"comb on its side", [](int n) { return turned(comb(n)); }},
    {"comb at the ends of the range", [](int n) { return scaled(comb(n), 0x1p1000, 0x1p-1070); }},
    {"spiral", spiral},
    {"subnormal spiral", [](int n) { return scaled(spiral(n), 0x1p-1040, 0x1p-1040); }},
    {"star", star},
    {"distances of all exponents", wild},
    {"zigzag", zigzag, false},
};

Rings ring_of(const Outline3& outline) {
  Rings rings(1, std::vector<std::uint32_t>(outline.size()));
  std::iota(rings[0].begin(), rings[0].end(), 0u);
  return rings;
}

TEST(SweepTriangles, GreatFacesAreTiledExactly) {
  for (const Shape& shape : shapes) {
    SCOPED_TRACE(shape.name);
    const Outline3 outline = shape.make(shape.simple ? 3000 : 600);
    const FlatFace flat = flattened(ring_of(outline), outline);
    const auto triangles = sweep_triangles(flat);
    ASSERT_TRUE(triangles);
    if (shape.simple) {
      EXPECT_EQ(triangles->size(), outline.size() - 2);
    }
    expect_face(flat, *triangles, shape.simple ? edges_of(flat) : parts_of(flat));
  }
}

/// The least of some times, in seconds of this process.
double seconds(const Outline3& outline) {
  double least = 1e9;
  for (int i = 0; i < 3; ++i) {
    const std::clock_t begin = std::clock();
    EXPECT_TRUE(swept(ring_of(outline), outline));
    least = std::min(least, static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
  }
  return least;
}

/// The time of four times as many corners would be 16 times as long by a method whose cost is the square; n log n says
/// 4.6, and caches that no longer hold all of it make that up to 8.
TEST(SweepTriangles, AHundredThousandCornersTakeTwoSecondsAndNoSquare) {
  for (const Shape& shape : shapes) {
    SCOPED_TRACE(shape.name);
    const double quarter = seconds(shape.make(25'000)), whole = seconds(shape.make(100'000));
    RecordProperty(shape.name, std::to_string(whole));
    EXPECT_LE(whole, 2);
    EXPECT_LE(whole, 9 * std::max(quarter, 0.005));
  }
}

}  // namespace
}  // namespace tribunal
