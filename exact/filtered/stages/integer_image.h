// A query moved onto an integer grid by powers of two, one an axis: exact, and no sign changes.
#pragma once

#include <initializer_list>

#include "core/operands.h"

namespace tribunal {

/// Multiplies each axis by its own power of two so that the largest coordinate of the points fills `bits` bits, and
/// the direction, if any, by another one on top, which moves no point at infinity. Works on the bits of the numbers,
/// so that neither subnormals nor the rounding mode matter.
/// Returns false where some coordinate is then no integer: the operands span too many binades. They are then
/// unusable. Coordinates must be finite; bits ≤ 1000.
bool move_to_grid(std::initializer_list<Point3*> points, Direction* direction, int bits);

/// The same for the operands of a test. Afterwards all coordinates are integers of magnitude below 2^bits.
inline bool move_to_grid(Segment& s, Triangle& t, int bits) {
  return move_to_grid({&s.p, &s.q, &t.a, &t.b, &t.c}, nullptr, bits);
}

inline bool move_to_grid(Ray& r, Triangle& t, int bits) { return move_to_grid({&r.o, &t.a, &t.b, &t.c}, &r.d, bits); }

}  // namespace tribunal
