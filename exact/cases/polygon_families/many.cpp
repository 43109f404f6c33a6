// Polygons with very many vertices and rings.
#include <algorithm>
#include <bit>

#include "exact/cases/families/shapes.h"
#include "exact/cases/polygon_families/image.h"
#include "exact/cases/polygon_families/table.h"

namespace tribunal {
namespace {

constexpr int most_teeth[] = {4, 40, 150, 400, 1000};

std::span<const int> levels(Format) { return most_teeth; }

/// Three in four cases are at the first level, three in four of the rest at the second, and so on: oracles are
/// slow on long rings. Segments and rays take turns at each level.
std::size_t level_with_tail(std::uint64_t k) {
  return std::min<std::size_t>(static_cast<std::size_t>(std::countr_one(k / 2)) / 2, std::size(most_teeth) - 1);
}

struct Wall {
  int teeth, holes;
  std::vector<PlaneRing> rings;
};

/// A wall of teeth on a strip, and holes ≤ teeth triangular holes in the strip. Tooth i stands on 4i ≤ u ≤ 4i + 2,
/// 0 ≤ v ≤ 8; the strip is −8 ≤ v ≤ 0; hole j has the corners (4j + 1, −2), (4j + 3, −2), (4j + 2, −6). So each vertex,
/// and each ring, decides some answer by itself.
Wall wall_with_holes(int teeth, int holes) {
  PlaneRing wall;
  for (int i = 0; i < teeth; ++i) wall.insert(wall.end(), {{4 * i, 0}, {4 * i, 8}, {4 * i + 2, 8}, {4 * i + 2, 0}});
  wall.insert(wall.end(), {{4 * teeth, 0}, {4 * teeth, -8}, {0, -8}});
  std::vector<PlaneRing> rings{wall};
  for (int j = 0; j < holes; ++j) rings.push_back({{4 * j + 1, -2}, {4 * j + 3, -2}, {4 * j + 2, -6}});
  return {teeth, holes, rings};
}

/// A wall with more teeth than the level before and at most as many as this level, and with usually few and sometimes
/// many holes; the rings are in random order, each with a random start.
Wall draw_wall(Draw& draw, std::size_t level) {
  const auto teeth = static_cast<int>(draw.between(level == 0 ? 1 : most_teeth[level - 1], most_teeth[level]));
  const int most_holes = draw.below(2) == 0 ? std::min(teeth, 3) : teeth;
  const auto holes = static_cast<int>(draw.between(0, most_holes));
  Wall wall = wall_with_holes(teeth, holes);
  for (PlaneRing& ring : wall.rings) {
    const auto start = static_cast<std::ptrdiff_t>(draw.below(ring.size()));
    std::rotate(ring.begin(), ring.begin() + start, ring.end());
  }
  std::swap(wall.rings[0], wall.rings[draw.below(wall.rings.size())]);
  return wall;
}

int draw_below(Draw& draw, int n) { return static_cast<int>(draw.below(static_cast<std::uint64_t>(n))); }

/// A random ring, or every other time the longest.
const PlaneRing& draw_ring(Draw& draw, const Wall& wall) {
  const bool longest = draw.below(2) == 0;
  if (!longest) return wall.rings[draw.below(wall.rings.size())];
  return *std::ranges::max_element(wall.rings, {}, &PlaneRing::size);
}

/// The middle of an edge where it is an integer point, else its end; every other time it is the edge that closes the
/// ring.
PlanePoint draw_edge_point(Draw& draw, const Wall& wall) {
  const PlaneRing& ring = draw_ring(draw, wall);
  const bool closing = draw.below(2) == 0;
  const std::size_t i = closing ? ring.size() - 1 : draw.below(ring.size());
  const PlanePoint &a = ring[i], &b = ring[(i + 1) % ring.size()];
  const int u = a.u + b.u, v = a.v + b.v;
  return u % 2 == 0 && v % 2 == 0 ? PlanePoint{u / 2, v / 2} : a;
}

/// A random point on an edge, in a tooth, in the gap after it, in a hole, between two holes, or at a corner of a tooth
/// or of a hole.
PlanePoint draw_wall_point(Draw& draw, const Wall& wall) {
  if (draw.below(4) == 0) return draw_edge_point(draw, wall);
  const int tooth = 4 * draw_below(draw, wall.teeth), hole = 4 * draw_below(draw, std::max(wall.holes, 1));
  const PlanePoint points[] = {{tooth + 1, 4}, {tooth + 3, 4}, {hole + 2, -3},
                               {hole + 4, -4}, {tooth + 2, 8}, {hole + 3, -2}};
  return points[draw.below(std::size(points))];
}

/// The ends of a probe along the third axis, up to 2¹⁴ long; 16·2^bits·2^longest and the wall stay within the format's
/// integers.
ProbeEnds draw_ends(Draw& draw, Format format, const PlanePoint& x, int bits) {
  const int longest = digits_of(format) - bits - 6;
  std::int64_t length = std::int64_t{1} << draw.between(0, std::min(longest, 14));
  const auto approach = static_cast<Approach>(draw.below(approach_count));
  if (draw.below(2) == 0) length = -length;
  const auto at = [&](std::int64_t along) { return Lattice3{x.u, x.v, along}; };
  return {at(approach == Approach::from ? 0 : -length), at(approach == Approach::to ? 0 : length)};
}

Trial make(Format format, std::uint64_t seed, std::uint64_t k) {
  Draw draw(stream_of("polygon family many"), seed, k);
  const std::size_t level = level_with_tail(k);
  const Wall wall = draw_wall(draw, level);
  const PlanePoint x = draw_wall_point(draw, wall);
  const int bits = format == Format::binary32 ? 4 : 30;
  const AffineMap map = draw_map(draw, bits);
  const ProbeEnds ends = draw_ends(draw, format, x, bits);
  return {.query = {image(turn_of(k, 1).is_ray, map, ends, format, draw), image(map, wall.rings)},
          .format = format,
          .level = static_cast<std::uint16_t>(level)};
}

}  // namespace

/// Walls with as many teeth as the level says, or fewer, under probes up to 2¹⁴ times as long as they are high.
Family polygon_many_family() {
  return {.name = "polygon-many",
          .stresses = "thousands of vertices and rings, each of which decides an answer; probes 2^14 times as long",
          .population = "exact affine images of a wall of teeth with holes",
          .axis = "teeth, at most",
          .constructs = false,
          .levels = levels,
          .make = make,
          .operands = Operands::polygons};
}

}  // namespace tribunal
