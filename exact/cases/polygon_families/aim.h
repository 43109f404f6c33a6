// Cases that aim at constructions: a probe through, from or to a point of a known kind of place.
#pragma once

#include "exact/cases/polygon_families/image.h"

namespace tribunal {

/// What case k of a family with `levels` levels aims at.
struct PolygonTurn {
  Construction construction;
  bool is_ray;
  std::size_t level;
};

/// Pairs of a shape and a place come in turn, half of them by segments and half by rays, and each round of all pairs
/// is at the next level. Six rounds take each pair through all three approaches by both kinds of probe; six rounds of
/// levels do so at every level. A place that the shape does not have gives way to the next that it has.
PolygonTurn polygon_turn_of(std::uint64_t k, std::size_t levels);

/// A turn, the point aimed at and the ends of the probe, before the affine map.
struct Aim {
  PolygonTurn turn;
  PlanePoint at;
  ProbeEnds ends;

  const std::vector<PlaneRing>& rings() const { return all_shapes()[turn.construction.shape].rings; }
};

Aim draw_aim(std::uint64_t k, std::size_t levels, Draw& draw);

/// A probe through, from or to the point x of the plane, along a random direction that leaves the plane.
ProbeEnds draw_piercing(Draw& draw, const PlanePoint& x, Approach approach);

/// The shape and the probe under the map. The construction is kept if no coordinate of M·x + o exceeds the format's
/// integers.
Trial image_of(const Aim& aim, const AffineMap& map, Format format, Draw& draw,
               std::optional<int> direction_scale = {});

}  // namespace tribunal
