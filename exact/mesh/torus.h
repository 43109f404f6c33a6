// A closed mesh that needs no file.
#pragma once

#include "exact/mesh/mesh.h"

namespace tribunal {

/// A torus of 4 `around` rings of 4 `along` vertices each: two triangles for each vertex, seen counter-clockwise from
/// outside. The rings' centres lie at a distance of 1 from the origin, and its tube has the radius 0.4. It is tilted,
/// so that the coordinates have full mantissas and no edge is parallel to an axis. Made by +, −, ×, ÷ alone: the same
/// bits everywhere.
Mesh torus(std::uint32_t around, std::uint32_t along);

}  // namespace tribunal
