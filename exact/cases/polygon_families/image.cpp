#include "exact/cases/polygon_families/image.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "exact/cases/families/shapes.h"

namespace tribunal {
namespace {

constexpr int fills_64[] = {4, 16, 20, 30, 40, 47};
constexpr int fills_32[] = {2, 4, 8, 12, 16, 18};

/// M·x: one coordinate, without offset and scale.
std::int64_t coordinate(const AffineMap& map, std::size_t axis, const Lattice3& x) {
  std::int64_t sum = 0;
  for (std::size_t j = 0; j < 3; ++j) sum += map.m[axis][j] * x[j];
  return sum;
}

/// The image of the direction between the ends. It has no offset, and may exceed the range of doubles until it is
/// scaled.
std::array<Scaled, 3> direction_between(const AffineMap& map, const ProbeEnds& ends) {
  std::array<Scaled, 3> d;
  for (std::size_t i = 0; i < 3; ++i) {
    d[i] = {coordinate(map, i, ends.to) - coordinate(map, i, ends.from), map.scale[i]};
  }
  return d;
}

}  // namespace

std::span<const int> polygon_fills(Format format) { return by_format<fills_64, fills_32>(format); }

int draw_fill(Draw& draw, Format format) {
  const std::span<const int> fills = polygon_fills(format);
  return fills[draw.below(fills.size())];
}

AffineMap draw_polygon_map(Draw& draw, Format format, int bits) {
  AffineMap map = draw_map(draw, bits);
  const bool with_offset = draw.below(2) == 0;
  const std::int64_t room = (std::int64_t{1} << digits_of(format)) - 43 * (std::int64_t{1} << bits);
  for (std::int64_t& o : map.offset) o = with_offset ? draw.between(-room, room) : 0;
  return map;
}

Point3 image(const AffineMap& map, const Lattice3& x) {
  Point3 y;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::int64_t sum = coordinate(map, i, x) + map.offset[i];
    y[static_cast<int>(i)] = std::ldexp(static_cast<double>(sum), map.scale[i]);
  }
  return y;
}

PolygonData image(const AffineMap& map, std::span<const PlaneRing> rings) {
  PolygonData polygon;
  for (const PlaneRing& ring : rings) {
    for (const PlanePoint& v : ring) polygon.vertices.push_back(image(map, in_plane(v)));
    polygon.ends.push_back(polygon.vertices.size());
  }
  return polygon;
}

Extent extent_of(const AffineMap& map, std::size_t axis, std::span<const PlaneRing> rings, const ProbeEnds& ends) {
  Extent extent{std::numeric_limits<std::int64_t>::max(), std::numeric_limits<std::int64_t>::min()};
  const auto include = [&](const Lattice3& x) {
    const std::int64_t y = coordinate(map, axis, x);
    extent = {std::min(extent.lo, y), std::max(extent.hi, y)};
  };
  for (const PlaneRing& ring : rings) {
    for (const PlanePoint& v : ring) include(in_plane(v));
  }
  include(ends.from);
  include(ends.to);
  return extent;
}

Probe image(bool is_ray, const AffineMap& map, const ProbeEnds& ends, Format format, Draw& draw,
            std::optional<int> direction_scale) {
  if (!is_ray) return Segment{image(map, ends.from), image(map, ends.to)};
  const std::array<Scaled, 3> d = direction_between(map, ends);
  return Ray{image(map, ends.from), direction_scale ? scaled(d, *direction_scale) : draw_direction(d, format, draw)};
}

int draw_up_to_level(Draw& draw, std::span<const int> levels, std::size_t level) {
  const int before = level == 0 ? levels[0] - 1 : levels[level - 1];
  return static_cast<int>(draw.between(before + 1, levels[level]));
}

}  // namespace tribunal
