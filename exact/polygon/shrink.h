// Makes a polygon counterexample simpler while it stays one.
#pragma once

#include "exact/polygon/judge.h"

namespace tribunal {

/// Drops rings, runs of vertices and vertices; then translates exactly to the origin, takes out powers of two per axis
/// and simplifies groups of equal coordinates (0, ±1, fewer significand bits). Keeps the format, the method's wrong
/// answer, the exact contact and `planar`. Each step lowers the cost (vertices, significand bits, exponents, signs), so
/// it ends, and it ends where no rule applies: the result is its own fixed point. Deterministic, if the method is a
/// function.
PolygonQuery shrink(const Method& method, const PolygonQuery& query, Format format);

/// Fewer vertices; then fewer significand bits in all; then exponents nearer to 0; then fewer minus signs.
bool is_simpler(const PolygonQuery& a, const PolygonQuery& b);

}  // namespace tribunal
