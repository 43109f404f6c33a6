// Pairs of a segment and a triangle on which tests are timed, in charts and in benchmarks alike.
#pragma once

#include <cstdint>
#include <vector>

#include "core/native.h"

namespace tribunal {

/// Five points of the unit cube with 53-bit coordinates, k-th draw.
SegmentPair random_pair(std::uint64_t k);

/// Random pairs of which this percentage hits. The paper counted 7 % in its scenes.
std::vector<SegmentPair> random_pairs(std::size_t n, int percent_hits);

/// The same with rays, from the first point of a random pair towards the second.
std::vector<SegmentPair> random_rays(std::size_t n, int percent_hits);

/// One segment, repeated, with random triangles of which 7 % meet it.
std::vector<SegmentPair> one_segment_pairs(std::size_t n);

/// Affine images of the classes with five affinely dependent points among them: exactly degenerate pairs, each operand
/// regular, as CGAL asks. The map's entries have `bits` bits; 50 fills the mantissas.
std::vector<SegmentPair> degenerate_pairs(std::size_t n, int bits);

/// Degenerate pairs with one vertex moved by some units in the last place.
std::vector<SegmentPair> near_pairs(std::size_t n);

/// Random pairs (7 % hits), with a share of full-mantissa degenerate ones dealt among them.
std::vector<SegmentPair> mixed_pairs(std::size_t n, int percent_degenerate);

}  // namespace tribunal
