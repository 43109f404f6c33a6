// What placements on axes have in common: classes in turn, and probes without a size of their own, so that the axis is
// the only thing that makes a case hard.
#pragma once

#include "core/native.h"
#include "exact/cases/families/affine.h"
#include "exact/cases/families/draw.h"
#include "exact/cases/families/family.h"

namespace tribunal {

/// The k-th class in turn: those of segments and then those of rays; or those of rays alone.
ClassTurn class_in_turn(std::uint64_t k);
ClassTurn ray_class_in_turn(std::uint64_t k);

/// The image of the class representative under the map, in random order; a ray's direction has the scale of the map.
Trial placed_image(const ClassTurn& turn, const AffineMap& map, Format format, Draw& draw);

/// The segment, one way or the other, for even k; for odd k the ray from one of its ends toward the other, with the
/// rounded difference as its direction.
Trial placed_probe(std::uint64_t k, const SegmentPair& pair, Format format, Draw& draw);

}  // namespace tribunal
