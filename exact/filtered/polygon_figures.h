// The numbers from which the filter of a polygon computes, for scalar code and for vector lanes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/vec3.h"

namespace tribunal::detail {

/// Up to 64 vertices of a polygon's rings in a row, projected and seen from the base; bit i of `edges` is set if a ring
/// edge leads from vertex i to the next. Views the polygon's figures.
struct RingRun {
  const double *u = nullptr, *v = nullptr;
  std::size_t size = 0;  ///< even
  std::uint64_t edges = 0;
};

/// A vertex as the base; the plane's normal, scaled, or zero where the filter abstains; the axes of the projection, and
/// the projected rings, of which `extent` is the largest coordinate in magnitude.
struct PolygonFigures {
  Vec3<double> base, normal;
  double extent;
  int u, v;
  std::vector<RingRun> runs;
};

}  // namespace tribunal::detail
