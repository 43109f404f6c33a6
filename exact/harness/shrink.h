// Makes a counterexample simpler while it stays one.
#pragma once

#include "core/method.h"
#include "exact/harness/judge.h"

namespace tribunal {

/// Shrinks by exact translation to the origin, powers of two per axis, a smaller affine frame (all points that depend
/// on others move with them), per group of equal coordinates 0, ±1 or fewer significand bits, and last the least image
/// under the 12 vertex orders and 48 signed axis maps. Keeps the format, the method's wrong answer, the exact class
/// and that the method is wrong. Each step makes the query simpler, so it ends, and it ends where no rule applies:
/// the result is its own fixed point, whatever it was made of. Deterministic, if the method is a function.
Query shrink(const Method& method, const Query& query, Format format);

/// Fewer significand bits in all; then exponents nearer to 0; then fewer minus signs; then lexicographically less
/// (a, b, c, then the probe).
bool is_simpler(const Query& a, const Query& b);

}  // namespace tribunal
