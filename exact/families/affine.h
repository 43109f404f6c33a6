// Exact affine images of the class representatives.
#pragma once

#include "exact/families/draw.h"
#include "exact/families/family.h"

namespace tribunal {

/// Case k is an image of class k mod 163, at level (k / 163) mod (number of levels). The level is the bit length of
/// the entries of the integer matrix M of x ↦ S·(M·x + o), det M ≠ 0, S a diagonal of powers of two: the class, and
/// with it the answer, is that of the representative. Every coordinate is an integer below 2⁵³ (2²⁴ in binary32)
/// before S is applied, so it is exact in the format; so the construction is the oracle.
Family affine_family();

/// The construction behind it, for families that start from an exactly degenerate case.
Trial affine_image(Format format, Draw& draw, std::uint64_t k);

/// Bit lengths of the entries of M that the family sweeps.
std::span<const int> mantissa_fills(Format format);

}  // namespace tribunal
