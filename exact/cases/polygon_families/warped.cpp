// Rings that do not lie in one plane.
#include "exact/cases/polygon_families/image.h"
#include "exact/cases/polygon_families/table.h"

namespace tribunal {
namespace {

Lattice3 draw_lattice(Draw& draw, int side) {
  Lattice3 x;
  for (std::int64_t& c : x) c = draw.between(0, side);
  return x;
}

PolygonData draw_warped(Draw& draw, const AffineMap& map) {
  PolygonData polygon;
  const std::uint64_t rings = 1 + draw.below(2);
  for (std::uint64_t r = 0; r < rings; ++r) {
    const std::int64_t size = draw.between(1, 6);
    for (std::int64_t i = 0; i < size; ++i) polygon.vertices.push_back(image(map, draw_lattice(draw, 2)));
    polygon.ends.push_back(polygon.vertices.size());
  }
  return polygon;
}

Trial make(Format format, std::uint64_t seed, std::uint64_t k) {
  Draw draw(stream_of("polygon family warped"), seed, k);
  const auto [is_ray, level] = turn_of(k, polygon_fills(format).size());
  const AffineMap map = draw_polygon_map(draw, format, polygon_fills(format)[level]);
  PolygonData polygon = draw_warped(draw, map);
  const Lattice3 from = draw_lattice(draw, 2);
  const Lattice3 to = draw_lattice(draw, 2);
  return {.query = {image(is_ray, map, {from, to}, format, draw), std::move(polygon)},
          .format = format,
          .level = static_cast<std::uint16_t>(level)};
}

}  // namespace

/// Rings whose vertices are anywhere on {0..2}³, probes between points of {0..2}³: exact degeneracies, not planar.
Family polygon_warped_family() {
  return {.name = "polygon-warped",
          .stresses = "rings that are not planar, exact degeneracies",
          .population = "exact affine images of rings in {0,1,2}^3",
          .axis = "bits of the map's entries",
          .constructs = false,
          .levels = polygon_fills,
          .make = make,
          .operands = Operands::polygons};
}

}  // namespace tribunal
