// The families of polygon cases.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdlib>

#include "exact/families/affine.h"
#include "exact/families/probe.h"
#include "exact/families/shapes.h"
#include "exact/families/ulp.h"
#include "exact/polygon/table.h"

namespace tribunal {
namespace {

/// Coordinates before the map are at most 20 in the plane and 3 across it, so their images stay below 43·2^bits.
constexpr int fills_64[] = {4, 16, 20, 30, 40, 47};
constexpr int fills_32[] = {2, 4, 8, 12, 16, 18};
constexpr auto fills = by_format<fills_64, fills_32>;

constexpr int ulps[] = {1, 2, 8, 64, 1024};
std::span<const int> ulp_levels(Format) { return ulps; }

constexpr int vertex_counts[] = {3, 4, 6, 8, 16, 64};
std::span<const int> count_levels(Format) { return vertex_counts; }

constexpr int scales_64[] = {-1074, -1022, -537, -400, -359, 0, 338, 341, 400, 1015};
constexpr int scales_32[] = {-149, -126, -75, -50, 0, 41, 42, 100, 119};
constexpr auto scales = by_format<scales_64, scales_32>;

struct Lattice3 {
  std::int64_t x[3];
};

Point3 image(const AffineMap& map, const Lattice3& p) {
  Point3 y;
  for (int i = 0; i < 3; ++i) {
    const auto row = static_cast<std::size_t>(i);
    std::int64_t sum = map.offset[row];
    for (std::size_t j = 0; j < 3; ++j) sum += map.m[row][j] * p.x[j];
    y[i] = std::ldexp(static_cast<double>(sum), map.scale[row]);
  }
  return y;
}

/// A map with entries of `bits` bits and half of the time an offset within what 43·2^bits leaves of the format.
AffineMap draw_polygon_map(Draw& draw, Format format, int bits) {
  AffineMap map = draw_map(draw, bits);
  const bool with_offset = draw.below(2) == 0;
  const std::int64_t room = (std::int64_t{1} << digits_of(format)) - 43 * (std::int64_t{1} << bits);
  for (std::int64_t& o : map.offset) o = with_offset ? draw.between(-room, room) : 0;
  return map;
}

PolygonData image(const AffineMap& map, std::span<const PlaneRing> rings) {
  PolygonData polygon;
  for (const PlaneRing& ring : rings) {
    for (const PlanePoint& v : ring) polygon.vertices.push_back(image(map, {{v.u, v.v, 0}}));
    polygon.ends.push_back(polygon.vertices.size());
  }
  return polygon;
}

Direction difference(const Point3& from, const Point3& to) { return {to - from}; }

/// The segment, or one time in four the ray from its source through its target where that direction is exact; it then
/// has a size of its own, over the whole range of the format, which changes no contact.
Probe draw_probe(Draw& draw, Format format, const Segment& s) {
  const bool as_ray = draw.below(4) == 0;
  const Direction d = difference(s.p, s.q);
  const bool exact = is_exact_in(d.v, format) && s.p + d.v == s.q && s.q - d.v == s.p;
  if (!as_ray || !exact) return s;
  std::array<Scaled, 3> coordinates;
  for (int i = 0; i < 3; ++i) {
    coordinates[static_cast<std::size_t>(i)] = tribunal::difference(s.p[i], s.q[i], format);
  }
  const ExponentRange range = exact_exponents(coordinates, format);
  const int e =
      draw.below(2) == 0 ? static_cast<int>(draw.between(range.lo, range.hi)) : std::clamp(0, range.lo, range.hi);
  return Ray{s.p, scaled(coordinates, e)};
}

/// Through, from or to (x, 0), along a random direction that leaves the plane.
Segment draw_piercing(Draw& draw, const AffineMap& map, const PlanePoint& x, Approach approach) {
  const std::int64_t du = draw.between(-2, 2);
  const std::int64_t dv = draw.between(-2, 2);
  const std::int64_t up = draw.between(1, 3);
  const std::int64_t down = draw.between(1, 3);
  const Point3 at = image(map, {{x.u, x.v, 0}});
  const Point3 above = image(map, {{x.u + du * up, x.v + dv * up, up}});
  const Point3 below = image(map, {{x.u - du * down, x.v - dv * down, -down}});
  const bool flip = draw.below(2) == 0;
  const Point3 &near_end = flip ? below : above, &far_end = flip ? above : below;
  if (approach == Approach::through) return {near_end, far_end};
  return approach == Approach::from ? Segment{at, far_end} : Segment{near_end, at};
}

/// Cases after which shapes and places repeat, and `levels` times as many after which levels do.
constexpr std::uint64_t round_size = shape_count * place_count;

std::size_t level_of(std::uint64_t k, std::size_t levels) { return k / round_size % levels; }

/// The shapes, places and approaches in turn; each pair of the first two meets every approach at every level within
/// three rounds of levels. A place that the shape does not have gives way to the next that it has.
Construction construction_of(std::uint64_t k, std::size_t levels) {
  Construction made{k % shape_count, static_cast<PolygonPlace>(k / shape_count % place_count),
                    static_cast<Approach>((k + k / (round_size * levels)) % approach_count)};
  const Places& places = places_of(all_shapes()[made.shape]);
  auto place = static_cast<std::size_t>(made.place);
  while (places[place].empty()) place = (place + 1) % place_count;
  made.place = static_cast<PolygonPlace>(place);
  return made;
}

Trial affine_trial(Format format, Draw& draw, std::uint64_t k, const AffineMap& map, std::size_t levels) {
  const Construction made = construction_of(k, levels);
  const Shape& shape = all_shapes()[made.shape];
  const auto& candidates = places_of(shape)[static_cast<std::size_t>(made.place)];
  const PlanePoint x = candidates[draw.below(candidates.size())];
  const Segment s = draw_piercing(draw, map, x, made.approach);
  const Probe probe = draw_probe(draw, format, s);
  return {.query = {probe, image(map, shape.rings)},
          .format = format,
          .level = static_cast<std::uint16_t>(level_of(k, levels)),
          .construction = made};
}

Trial make_affine(Format format, std::uint64_t seed, std::uint64_t k) {
  Draw draw(101, seed, k);
  const std::size_t levels = fills(format).size();
  const AffineMap map = draw_polygon_map(draw, format, fills(format)[level_of(k, levels)]);
  return affine_trial(format, draw, k, map, levels);
}

Trial make_scale(Format format, std::uint64_t seed, std::uint64_t k) {
  Draw draw(102, seed, k);
  const std::size_t levels = scales(format).size();
  AffineMap map = draw_map(draw, 0);
  const bool per_axis = draw.below(2) == 0;
  for (int& s : map.scale) s = scales(format)[per_axis ? draw.below(levels) : level_of(k, levels)];
  return affine_trial(format, draw, k, map, levels);
}

Trial make_ulp(Format format, std::uint64_t seed, std::uint64_t k) {
  Draw draw(103, seed, k);
  const std::size_t levels = ulp_levels(format).size();
  const int bits = fills(format)[draw.below(fills(format).size())];
  const AffineMap map = draw_polygon_map(draw, format, bits);
  Trial trial = affine_trial(format, draw, k, map, levels);
  trial.construction.reset();
  std::vector<Point3>& vertices = trial.query.polygon().vertices;
  auto* s = std::get_if<Segment>(&trial.query.probe);
  const std::uint64_t moved = draw.below(vertices.size() + 2);
  Point3& v = moved < vertices.size()    ? vertices[moved]
              : s == nullptr             ? std::get<Ray>(trial.query.probe).o
              : moved == vertices.size() ? s->p
                                         : s->q;
  const auto axis = static_cast<int>(draw.below(3));
  const std::int64_t by = draw.below(2) == 0 ? ulps[trial.level] : -ulps[trial.level];
  v[axis] = moved_by_ulps(v[axis], by, format);
  return trial;
}

/// Both ends in the plane, at integer points around the shape.
Trial make_in_plane(Format format, std::uint64_t seed, std::uint64_t k) {
  Draw draw(104, seed, k);
  const std::size_t level = k / shape_count % fills(format).size();
  const AffineMap map = draw_polygon_map(draw, format, fills(format)[level]);
  const Shape& shape = all_shapes()[k % shape_count];
  std::int64_t end[4];
  for (std::int64_t& e : end) e = draw.between(-2, 14);
  const bool point = draw.below(8) == 0;
  const Point3 p = image(map, {{end[0], end[1], 0}});
  const Point3 q = point ? p : image(map, {{end[2], end[3], 0}});
  return {.query = {draw_probe(draw, format, {p, q}), image(map, shape.rings)},
          .format = format,
          .level = static_cast<std::uint16_t>(level)};
}

/// One to three rings of up to `count` vertices in all on a 5×5 grid.
std::vector<PlaneRing> draw_grid_rings(Draw& draw, int count) {
  std::vector<PlaneRing> rings(static_cast<std::size_t>(1 + draw.below(3)));
  for (PlaneRing& ring : rings) {
    const std::int64_t size = draw.between(1, std::max(1, count / static_cast<int>(rings.size())));
    for (std::int64_t i = 0; i < size; ++i) {
      const auto cell = static_cast<int>(draw.below(25));
      ring.push_back({3 * (cell % 5), 3 * (cell / 5)});
    }
  }
  return rings;
}

Trial make_grid(Format format, std::uint64_t seed, std::uint64_t k) {
  Draw draw(105, seed, k);
  const std::size_t level = k % count_levels(format).size();
  const int bits = fills(format)[draw.below(fills(format).size())];
  const AffineMap map = draw_polygon_map(draw, format, bits);
  const auto rings = draw_grid_rings(draw, count_levels(format)[level]);
  const PlanePoint x{static_cast<int>(draw.between(-1, 13)), static_cast<int>(draw.between(-1, 13))};
  const auto approach = static_cast<Approach>(draw.below(approach_count));
  const Segment s = draw_piercing(draw, map, x, approach);
  return {.query = {draw_probe(draw, format, s), image(map, rings)},
          .format = format,
          .level = static_cast<std::uint16_t>(level)};
}

Lattice3 draw_lattice(Draw& draw, int side) {
  Lattice3 p;
  for (std::int64_t& x : p.x) x = draw.between(0, side);
  return p;
}

/// Rings whose vertices are anywhere on {0..2}³, probes between points of {0..2}³: exact degeneracies, no plane.
Trial make_warped(Format format, std::uint64_t seed, std::uint64_t k) {
  Draw draw(106, seed, k);
  const std::size_t level = k % fills(format).size();
  const AffineMap map = draw_polygon_map(draw, format, fills(format)[level]);
  PolygonData polygon;
  const std::uint64_t rings = 1 + draw.below(2);
  for (std::uint64_t r = 0; r < rings; ++r) {
    const std::int64_t size = draw.between(1, 6);
    for (std::int64_t i = 0; i < size; ++i) polygon.vertices.push_back(image(map, draw_lattice(draw, 2)));
    polygon.ends.push_back(polygon.vertices.size());
  }
  const Point3 p = image(map, draw_lattice(draw, 2));
  const Point3 q = image(map, draw_lattice(draw, 2));
  return {.query = {draw_probe(draw, format, {p, q}), std::move(polygon)},
          .format = format,
          .level = static_cast<std::uint16_t>(level)};
}

// --- rings without number ------------------------------------------------------------------------------------------

/// A wall of `teeth` teeth on a strip, and `holes` ≤ `teeth` triangular holes in the strip. Tooth i stands on
/// 4i ≤ u ≤ 4i + 2, 0 ≤ v ≤ 8; the strip is −8 ≤ v ≤ 0; hole j has the corners (4j + 1, −2), (4j + 3, −2), (4j + 2,
/// −6). So each vertex, and each ring, decides some answer by itself.
std::vector<PlaneRing> wall_with_holes(int teeth, int holes) {
  PlaneRing wall;
  for (int i = 0; i < teeth; ++i) wall.insert(wall.end(), {{4 * i, 0}, {4 * i, 8}, {4 * i + 2, 8}, {4 * i + 2, 0}});
  wall.insert(wall.end(), {{4 * teeth, 0}, {4 * teeth, -8}, {0, -8}});
  std::vector<PlaneRing> rings{wall};
  for (int j = 0; j < holes; ++j) rings.push_back({{4 * j + 1, -2}, {4 * j + 3, -2}, {4 * j + 2, -6}});
  return rings;
}

/// In a tooth, in the gap after it, in a hole, between two holes, at a corner of a tooth or of a hole.
PlanePoint draw_wall_point(Draw& draw, int teeth, int holes) {
  const auto any = [&](int n) { return static_cast<int>(draw.below(static_cast<std::uint64_t>(n))); };
  const int tooth = 4 * any(teeth), hole = 4 * any(std::max(holes, 1));
  const PlanePoint points[] = {{tooth + 1, 4}, {tooth + 3, 4}, {hole + 2, -3},
                               {hole + 4, -4}, {tooth + 2, 8}, {hole + 3, -2}};
  return points[draw.below(std::size(points))];
}

constexpr int most_teeth[] = {4, 20, 80, 300, 1000};
std::span<const int> teeth_levels(Format) { return most_teeth; }

/// Three in four cases are at the first level, three in four of the rest at the second, and so on: oracles take their
/// time over the long ones.
std::size_t level_with_tail(std::uint64_t k) {
  return std::min<std::size_t>(static_cast<std::size_t>(std::countr_one(k)) / 2, std::size(most_teeth) - 1);
}

/// Teeth between the level before and this one, any number of holes with a tail; rings in any order, each from any
/// start. The probe is up to 2¹⁴ times as long as the polygon is high, where the format holds it.
Trial make_many(Format format, std::uint64_t seed, std::uint64_t k) {
  Draw draw(108, seed, k);
  const std::size_t level = level_with_tail(k);
  const int teeth = static_cast<int>(draw.between(level == 0 ? 1 : most_teeth[level - 1], most_teeth[level]));
  const int holes = static_cast<int>(draw.below(2) == 0 ? draw.between(0, std::min(teeth, 3)) : draw.between(0, teeth));
  const PlanePoint x = draw_wall_point(draw, teeth, holes);
  std::vector<PlaneRing> rings = wall_with_holes(teeth, holes);
  for (PlaneRing& ring : rings) {
    const auto start = static_cast<std::ptrdiff_t>(draw.below(ring.size()));
    std::rotate(ring.begin(), ring.begin() + start, ring.end());
  }
  std::swap(rings[0], rings[draw.below(rings.size())]);
  const int bits = format == Format::binary32 ? 4 : 30;
  const AffineMap map = draw_map(draw, bits);
  const int longest =
      digits_of(format) - bits - 6;  // 16·2^bits·2^longest and the wall stay within the format's integers
  const std::int64_t length = std::int64_t{1} << draw.between(0, std::min(longest, 14));
  const auto approach = static_cast<Approach>(draw.below(approach_count));
  const auto at = [&](std::int64_t along) { return image(map, {{x.u, x.v, along}}); };
  const Point3 above = at(length), below = at(-length);
  const bool up = draw.below(2) == 0;
  const Point3 &near_end = up ? below : above, &far_end = up ? above : below;
  const Segment s = approach == Approach::through ? Segment{near_end, far_end}
                    : approach == Approach::from  ? Segment{at(0), far_end}
                                                  : Segment{near_end, at(0)};
  return {.query = {draw_probe(draw, format, s), image(map, rings)},
          .format = format,
          .level = static_cast<std::uint16_t>(level)};
}

/// A star-shaped ring in a random plane, each vertex rounded: planar as it comes from a modelling program. The probe
/// aims at a vertex, a point of an edge or spoke, or anywhere near, as it rounds.
Trial make_rounded(Format format, std::uint64_t seed, std::uint64_t k) {
  Draw draw(107, seed, k);
  const std::size_t level = k % count_levels(format).size();
  const int n = count_levels(format)[level];
  const Triangle frame = draw_triangle(draw, format);
  const auto at = [&](double u, double v) {
    return in_format(frame.a + u * (frame.b - frame.a) + v * (frame.c - frame.a), format);
  };
  PolygonData polygon;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * 3.141592653589793 * i / n;
    const double radius = 0.75 + 0.25 * draw_real(draw, format);
    polygon.vertices.push_back(at(radius * std::cos(angle), radius * std::sin(angle)));
  }
  polygon.ends.push_back(polygon.vertices.size());
  const Point3& a = polygon.vertices[draw.below(polygon.vertices.size())];
  const Point3& b = polygon.vertices[draw.below(polygon.vertices.size())];
  const double along = 0.5 + 0.75 * draw_real(draw, format);
  const std::uint64_t aim = draw.below(3);
  const Point3 x = aim == 0 ? a : aim == 1 ? a + along * (b - a) : draw_in_plane(draw, format, frame);
  const Point3 v = draw_point(draw, format);
  const Segment s = through(x, v, v);
  const Segment rounded{in_format(s.p, format), in_format(s.q, format)};
  return {.query = {draw_probe(draw, format, rounded), std::move(polygon)},
          .format = format,
          .level = static_cast<std::uint16_t>(level)};
}

}  // namespace

std::span<const Family> polygon_families() {
  static const Family table[] = {
      {"polygon-affine", "22 ring configurations, 26 kinds of place, with growing mantissa fill",
       "exact affine images of the shapes", "bits of the map's entries", true, fills, make_affine, Operands::polygons},
      {"polygon-scale", "underflow and overflow: the same from subnormals to the largest numbers",
       "small images of the shapes, axes scaled by powers of two", "log2 of the scale", true, scales, make_scale,
       Operands::polygons},
      {"polygon-ulp", "near-degeneracy: one coordinate some ulps off, so planar only up to rounding",
       "affine images of the shapes, one coordinate moved", "units in the last place", false, ulp_levels, make_ulp,
       Operands::polygons},
      {"polygon-in-plane", "probes in the plane of the polygon", "affine images of the shapes, probes in their plane",
       "bits of the map's entries", false, fills, make_in_plane, Operands::polygons},
      {"polygon-grid", "random rings on a grid, degenerate in every way", "exact affine images of rings on a 5x5 grid",
       "vertices, at most", false, count_levels, make_grid, Operands::polygons},
      {"polygon-warped", "rings that are not planar, exact degeneracies", "exact affine images of rings in {0,1,2}^3",
       "bits of the map's entries", false, fills, make_warped, Operands::polygons},
      {"polygon-rounded", "star-shaped rings planar up to rounding, aimed at vertices, edges and spokes",
       "random rings in [-1,1]^3 as they round", "vertices", false, count_levels, make_rounded, Operands::polygons},
      {"polygon-many", "thousands of vertices and rings, each of which decides an answer; probes 2^14 times as long",
       "exact affine images of a wall of teeth with holes", "teeth, at most", false, teeth_levels, make_many,
       Operands::polygons},
  };
  return table;
}

}  // namespace tribunal
