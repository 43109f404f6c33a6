// Makes a counterexample simpler while it stays one.
#pragma once

#include "core/method.h"
#include "exact/trial/judge.h"

namespace tribunal {

/// Shrinks by exact translation to the origin, powers of two per axis, and, per group of equal coordinates, 0, ±1 or
/// fewer significand bits. Of a triangle also by a smaller affine frame (all points that depend on others move with
/// them) and last by the least image under the 12 vertex orders and 48 signed axis maps; of a polygon, before all, by
/// dropping rings, runs of vertices and vertices. Keeps the format, the method's wrong answer, the exact class, contact
/// and `planar`, and that the method is wrong. Each step makes the query simpler, so it ends, and it ends where no rule
/// applies: the result is its own fixed point, whatever it was made of. Deterministic, if the method is a function.
Query shrink(const Method& method, const Query& query, Format format);

/// By QueryCost (shrinker.h).
bool is_simpler(const Query& a, const Query& b);

}  // namespace tribunal
