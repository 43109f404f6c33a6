// Makes a counterexample simpler while it stays one.
#pragma once

#include "core/method.h"
#include "exact/harness/judge.h"

namespace tribunal {

/// Shrinks by exact translation to the origin, powers of two per axis, and per group of equal coordinates: 0, ±1,
/// fewer significand bits. Keeps the format, the method's wrong answer, the exact class (for rays: the exact contact)
/// and that the method is wrong. Each step must lower the cost (significand bits, then exponents, then signs), so it
/// ends and its result is its own fixed point. Deterministic; at most `budget` evaluations of the method.
Query shrink(const Method& method, const Query& query, Format format, int budget = 2000);

}  // namespace tribunal
