// Probes in the plane of the polygon.
#include "exact/cases/polygon_families/aim.h"
#include "exact/cases/polygon_families/table.h"

namespace tribunal {
namespace {

/// Two random integer points in and around the shape; one time in eight the same point twice.
ProbeEnds draw_ends(Draw& draw) {
  std::int64_t end[4];
  for (std::int64_t& e : end) e = draw.between(-2, 14);
  const Lattice3 from{end[0], end[1], 0}, to{end[2], end[3], 0};
  return {from, draw.below(8) == 0 ? from : to};
}

Trial make(Format format, std::uint64_t seed, std::uint64_t k) {
  Draw draw(stream_of("polygon family in-plane"), seed, k);
  const std::span<const int> fills = polygon_fills(format);
  const PolygonTurn turn = polygon_turn_of(k, fills.size());
  const AffineMap map = draw_polygon_map(draw, format, fills[turn.level]);
  const ProbeEnds ends = draw_ends(draw);
  return {
      .query = {image(turn.is_ray, map, ends, format, draw), image(map, all_shapes()[turn.construction.shape].rings)},
      .format = format,
      .level = static_cast<std::uint16_t>(turn.level)};
}

}  // namespace

/// Affine images of the shapes in turn, with a probe between integer points of their plane.
Family polygon_in_plane_family() {
  return {.name = "polygon-in-plane",
          .stresses = "probes in the plane of the polygon",
          .population = "affine images of the shapes, probes in their plane",
          .axis = "bits of the map's entries",
          .constructs = false,
          .levels = polygon_fills,
          .make = make,
          .operands = Operands::polygons};
}

}  // namespace tribunal
