// What sf-filtered is measured against: CGAL's own test without checks of its operands, and a vectorised
// Möller–Trumbore.
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/operands.h"

namespace tribunal::bench {

/// CGAL's do_intersect on EPICK, with its precondition checks compiled out. Neither operand may be degenerate.
bool epick(const Segment& s, const Triangle& t);
bool epeck(const Segment& s, const Triangle& t);

/// The uncertified test by columns (source, target, a, b, c: x, y, z each), n a multiple of 8; one byte a pair. In
/// `one`, the probe's columns are read at 0 only. In `rays` the target is a direction.
using VectorTest = void (*)(const double* const* columns, std::size_t n, std::uint8_t* hit);

struct VectorPeer {
  const char* name;  ///< as in batch_targets()
  VectorTest pairs, one, rays;
};

extern const VectorPeer moeller_trumbore_avx512, moeller_trumbore_avx2, moeller_trumbore_portable;

}  // namespace tribunal::bench
