// Coordinates hundreds of binades apart on one axis.
#include <algorithm>

#include "exact/cases/families/ladder.h"
#include "exact/cases/families/levels.h"
#include "exact/cases/families/ulp.h"
#include "exact/cases/polygon_families/image.h"
#include "exact/cases/polygon_families/table.h"
#include "exact/cases/polygon_families/vectors.h"

namespace tribunal {
namespace {

using Ladders = std::array<Ladder, 3>;

/// How the coordinate on one axis depends on the others: it is free, it is the same number everywhere, or it equals the
/// coordinate on the next axis.
enum class Bend : std::uint8_t { free, flat, slanted };

Ladders draw_ladders(Draw& draw, Format format, int spread, int across, Bend bend) {
  Ladders ladders;
  for (Ladder& ladder : ladders) ladder = draw_ladder(draw, format, spread);
  if (bend == Bend::slanted) {
    ladders[static_cast<std::size_t>(across)] = ladders[static_cast<std::size_t>((across + 1) % 3)];
  }
  return ladders;
}

Point3 draw_point(Draw& draw, const Ladders& ladders) {
  Point3 p;
  for (int axis = 0; axis < 3; ++axis) p[axis] = ladders[static_cast<std::size_t>(axis)].draw_number(draw);
  return p;
}

PolygonData draw_polygon(Draw& draw, const Ladders& ladders, int across, Bend bend) {
  PolygonData polygon;
  const double height = ladders[static_cast<std::size_t>(across)].draw_number(draw);
  const std::uint64_t rings = 1 + draw.below(3) / 2;
  for (std::uint64_t r = 0; r < rings; ++r) {
    const std::int64_t most = draw.below(8) == 0 ? 16 : 6;
    const std::int64_t size = draw.between(3, most);
    for (std::int64_t i = 0; i < size; ++i) {
      Point3& p = polygon.vertices.emplace_back(draw_point(draw, ladders));
      if (bend == Bend::flat) p[across] = height;
      if (bend == Bend::slanted) p[across] = p[(across + 1) % 3];
    }
    polygon.ends.push_back(polygon.vertices.size());
  }
  return polygon;
}

/// A probe between two random points of the ladders; or, three times in four, along one axis.
Probe draw_ladder_probe(Draw& draw, bool is_ray, const Ladders& ladders, int across) {
  const bool along_axis = draw.below(4) != 0;
  const Point3 source = draw_point(draw, ladders);
  Point3 toward = draw_point(draw, ladders);
  for (int axis = 0; axis < 3; ++axis) {
    if (along_axis && axis != across) toward[axis] = is_ray ? 0.0 : source[axis];
  }
  if (is_ray) return Ray{source, {toward}};
  return Segment{source, toward};
}

void move_one(Draw& draw, Query& query, Format format) {
  const bool of_probe = draw.below(2) == 0;
  std::vector<Point3>& vertices = query.polygon().vertices;
  Point3& v = of_probe ? *vectors_of(query.probe)[draw.below(2)] : vertices[draw.below(vertices.size())];
  double& x = v[static_cast<int>(draw.below(3))];
  const std::int64_t by = draw.below(2) == 0 ? 1 : -1;
  x = moved_by_ulps(x, by, format);
}

Trial make(Format format, std::uint64_t seed, std::uint64_t k) {
  Draw draw(stream_of("polygon family spread"), seed, k);
  const auto [is_ray, level] = turn_of(k, coordinate_spreads(format).size());
  const auto across = static_cast<int>(draw.below(3));
  const auto bend = static_cast<Bend>(draw.below(3));
  const int spread = draw_up_to_level(draw, coordinate_spreads(format), level);
  const Ladders ladders = draw_ladders(draw, format, spread, across, bend);
  PolygonData polygon = draw_polygon(draw, ladders, across, bend);
  Trial trial{.query = {draw_ladder_probe(draw, is_ray, ladders, across), std::move(polygon)},
              .format = format,
              .level = static_cast<std::uint16_t>(level)};
  if (draw.below(2) == 0) move_one(draw, trial.query, format);
  return trial;
}

}  // namespace

/// Rings and probes whose coordinates are, on each axis, zero or of one of three magnitudes in geometric sequence:
/// products of far smaller and far larger numbers are exactly equal, and small terms decide. A third of the polygons
/// are flat across an axis, a third lie in a plane x = y, the others are not planar. Half of the cases move one
/// coordinate by a unit in the last place.
Family polygon_spread_family() {
  return {.name = "polygon-spread",
          .stresses = "numbers up to 2096 binades apart on one axis, whose products tie",
          .population =
              "coordinates drawn from 0 and three sizes an axis, with signs, the largest up to 2^level the "
              "least",
          .axis = "log2 of largest over least",
          .constructs = false,
          .levels = coordinate_spreads,
          .make = make,
          .operands = Operands::polygons};
}

}  // namespace tribunal
