// Meshes and rays to time closest hits on. All coordinates are binary32 numbers, so that Embree traces the same rays
// on the same triangles.
#pragma once

#include <vector>

#include "exact/mesh/mesh.h"

namespace tribunal::bench {

/// A bumpy torus about the z axis, of 4·n² triangles; closed, and its own occluder. Fits in [−1.5, 1.5]³.
Mesh torus(std::uint32_t n);

/// Rays of a pinhole camera that sees the torus whole, row by row, side × side of them.
std::vector<Ray> coherent_rays(int side);

/// From a uniform point of [−2, 2]³ to a uniform point of the torus's box: the ends have nothing to do with each other
/// or with the next ray's.
std::vector<Ray> random_rays(std::size_t n);

}  // namespace tribunal::bench
