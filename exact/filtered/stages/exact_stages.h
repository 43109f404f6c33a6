// The stages after the filter: a decision by signs is made over integers of a fixed width, or else over GMP's.
#pragma once

#include <optional>

#include "core/answer.h"
#include "exact/filtered/stages/default_rounding.h"
#include "exact/filtered/stages/fixed_integer.h"
#include "exact/filtered/stages/grid_kernel.h"
#include "exact/filtered/stages/integer_image.h"
#include "exact/kernels/rational_kernel.h"

namespace tribunal {

/// Bits of a grid coordinate such that a signed volume fits `Words` machine words: coordinates below 2^b in magnitude
/// have differences below 2^(b+1), minors below 2^(2b+3), volumes below 2^(3b+6), and a sign.
template <std::size_t Words>
inline constexpr int grid_bits = static_cast<int>(64 * Words - 7) / 3;

static_assert(grid_bits<3> == 61 && grid_bits<6> == 125);

template <std::size_t Words>
using IntegerKernel = FormulaKernel<FixedInteger<Words>>;

template <class R>
struct Staged {
  R result;
  Stage stage;
};

/// decide(operands, kernel) over the narrowest integers that hold the operands exactly. `Operands` has a member
/// move_to_grid(bits). `Factors` is the number of volumes that are multiplied: 1, or 2 to compare hits.
template <std::size_t Factors = 1, class Operands, class Decide>
auto decide_exactly(const Operands& operands, const Decide& decide)
    -> Staged<decltype(decide(operands, RationalKernel{}))> {
  if (Operands moved = operands; moved.move_to_grid(grid_bits<3>)) {
    return {decide(moved, GridKernel{}), Stage::integers};
  }
  if (Operands moved = operands; moved.move_to_grid(grid_bits<6>)) {
    return {decide(moved, IntegerKernel<6 * Factors>{}), Stage::integers};
  }
  const DefaultRounding in_this_scope;
  return {decide(operands, RationalKernel{}), Stage::exact};
}

/// A probe and a triangle.
template <class P>
struct Pair {
  P probe;
  Triangle triangle;

  bool move_to_grid(int bits) { return tribunal::move_to_grid(probe, triangle, bits); }
};

}  // namespace tribunal
