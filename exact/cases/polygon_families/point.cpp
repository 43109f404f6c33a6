// Probes that are points.
#include "exact/cases/families/ulp.h"
#include "exact/cases/polygon_families/aim.h"
#include "exact/cases/polygon_families/table.h"
#include "exact/cases/polygon_families/vectors.h"

namespace tribunal {
namespace {

/// Moves the probe by a unit in the last place: both ends of a segment alike, so that it stays a point.
void move_by_a_unit(Draw& draw, Probe& probe, Format format) {
  const auto axis = static_cast<int>(draw.below(3));
  const std::int64_t by = draw.below(2) == 0 ? 1 : -1;
  const auto move = [&](Point3& p) { p[axis] = moved_by_ulps(p[axis], by, format); };
  const auto [source, target] = vectors_of(probe);
  move(*source);
  if (std::holds_alternative<Segment>(probe)) move(*target);
}

Trial make(Format format, std::uint64_t seed, std::uint64_t k) {
  Draw draw(stream_of("polygon family point"), seed, k);
  const std::span<const int> fills = polygon_fills(format);
  Aim aim = draw_aim(k, fills.size(), draw);
  const AffineMap map = draw_polygon_map(draw, format, fills[aim.turn.level]);
  const bool off_plane = draw.below(8) == 0;
  if (!off_plane) aim.ends.from = in_plane(aim.at);
  if (off_plane && aim.turn.construction.approach == Approach::from) std::swap(aim.ends.from, aim.ends.to);
  aim.ends.to = aim.ends.from;
  Trial trial = image_of(aim, map, format, draw);
  trial.construction.reset();
  if (draw.below(4) == 0) move_by_a_unit(draw, trial.query.probe, format);
  return trial;
}

}  // namespace

/// A segment whose ends coincide, or a ray without direction, at each kind of place of each shape; one in eight off the
/// plane, one in four a unit in the last place beside it.
Family polygon_point_family() {
  return {.name = "polygon-point",
          .stresses = "probes that are points: ends that coincide, directions that are zero",
          .population = "affine images of the shapes, probes without length at their places and near them",
          .axis = "bits of the map's entries",
          .constructs = false,
          .levels = polygon_fills,
          .make = make,
          .operands = Operands::polygons};
}

}  // namespace tribunal
