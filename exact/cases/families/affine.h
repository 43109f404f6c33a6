// Exact affine images of the class representatives.
#pragma once

#include <array>
#include <optional>

#include "exact/cases/families/draw.h"
#include "exact/cases/families/family.h"

namespace tribunal {

/// x ↦ S·(M·x + o) over the integers, det M ≠ 0, S a diagonal of powers of two. A direction has no offset.
struct AffineMap {
  std::array<std::array<std::int64_t, 3>, 3> m;
  std::array<std::int64_t, 3> offset{};
  std::array<int, 3> scale{};
};

/// |M·x| ≤ 7·2^bits < 2^(bits + image_bits) for entries of M of `bits` bits: a representative's coordinates sum to at
/// most 7.
inline constexpr int image_bits = 3;

/// A random map with entries of up to `bits` bits, redrawn until the determinant is not zero.
AffineMap draw_map(Draw& draw, int bits);

/// The same, half of the time with an offset that the format's integers have room for.
AffineMap draw_placed_map(Draw& draw, Format format, int bits);

/// The rule of the families that aim at classes: case after case takes the next class, of segments and then of rays,
/// and each level of the stress axis takes all of them before the next level's turn.
struct ClassTurn {
  ClassId id;
  std::size_t level;
};

ClassTurn class_turn_of(std::uint64_t k, std::size_t levels);

/// The number of the k-th case of which the probe is a segment.
std::uint64_t segment_case(std::uint64_t k);

/// The least and the largest coordinate on one axis of M·x, without offset, for the points x of the class
/// representative.
struct Extent {
  std::int64_t lo, hi;
};

Extent extent_of(const ClassTurn& turn, const AffineMap& map, std::size_t axis);

/// Centres points with this extent of M·x on one axis about zero and scales them until the farthest is in the last
/// binade: points on both sides of zero are then farther apart than the largest number. So that the centre is an
/// integer, this axis of M is doubled.
void stretch(AffineMap& map, std::size_t axis, const Extent& extent, Format format);

/// A random signed axis permutation, each axis scaled by up to 2^±12.
AffineMap draw_axis_map(Draw& draw);

/// The representative of the class under the map, in random vertex order and direction. The class is kept if no
/// coordinate of M·x + o exceeds the format's integers.
/// A ray's direction is scaled by a further power of two, 2^direction_scale, or one that is drawn.
Trial image_of(const ClassTurn& turn, const AffineMap& map, Format format, Draw& draw,
               std::optional<int> direction_scale = {});

/// An image under a random map with entries of `bits` bits, sometimes with an offset and scaled axes.
Trial affine_image(Format format, Draw& draw, const ClassTurn& turn, int bits);

/// Bit lengths of the entries of M that the family sweeps.
std::span<const int> mantissa_fills(Format format);

}  // namespace tribunal
