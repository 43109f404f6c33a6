// Exact affine images of the class representatives.
#pragma once

#include <array>

#include "exact/families/draw.h"
#include "exact/families/family.h"

namespace tribunal {

/// x ↦ S·(M·x + o) over the integers, det M ≠ 0, S a diagonal of powers of two.
struct AffineMap {
  std::array<std::array<std::int64_t, 3>, 3> m;
  std::array<std::int64_t, 3> offset{};
  std::array<int, 3> scale{};
};

/// Entries of up to `bits` bits, redrawn until the determinant is not zero.
AffineMap draw_map(Draw& draw, int bits);

/// The representative of the class under the map, in random vertex order and direction. The class is kept if no
/// coordinate of M·x + o exceeds the format's integers: |M·x| ≤ 7·2^bits, since a representative's sum to at most 7.
Trial image_of(ClassId id, const AffineMap& map, Format format, std::size_t level, Draw& draw);

/// An image of class k mod 163 with entries of `bits` bits, sometimes with an offset and scaled axes.
Trial affine_image(Format format, Draw& draw, std::uint64_t k, int bits, std::size_t level);

/// Bit lengths of the entries of M that the family sweeps.
std::span<const int> mantissa_fills(Format format);

}  // namespace tribunal
