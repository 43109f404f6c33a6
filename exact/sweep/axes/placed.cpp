#include "exact/sweep/axes/placed.h"

#include <utility>

#include "exact/cases/families/probe.h"
#include "exact/classes/class_table.h"

namespace tribunal {

ClassTurn class_in_turn(std::uint64_t k) { return class_turn_of(k, 1); }

ClassTurn ray_class_in_turn(std::uint64_t k) {
  return {static_cast<ClassId>(1 + class_count + k % ray_class_count), 0};
}

Trial placed_image(const ClassTurn& turn, const AffineMap& map, Format format, Draw& draw) {
  return image_of(turn, map, format, draw, 0);
}

Trial placed_probe(std::uint64_t k, const SegmentPair& pair, Format format, Draw& draw) {
  Segment ends{in_format(pair.segment.p, format), in_format(pair.segment.q, format)};
  if (draw.below(2) == 1) std::swap(ends.p, ends.q);
  const bool is_ray = turn_of(k, 1).is_ray;
  const Probe probe = is_ray ? Probe(Ray{ends.p, {ends.q - ends.p}}) : Probe(ends);
  return unclassified(format, 0, probe, pair.triangle, draw);
}

}  // namespace tribunal
