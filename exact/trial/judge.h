// Right or wrong: a method's answer held against the exact one.
#pragma once

#include "core/due.h"
#include "core/method.h"
#include "exact/trial/count.h"
#include "exact/trial/truth.h"

namespace tribunal {

/// What contracts can turn on in a case with this exact answer.
Facts facts_of(const Truth& truth);

/// What the contract owes to a case with this exact answer.
Due due(const Contract& contract, const Truth& truth);

/// Holds a hit or a miss against what is owed.
constexpr Outcome judge(Due owed, bool hit) {
  if (owed == Due::nothing) return Outcome::not_owed;
  if (hit == (owed == Due::hit)) return Outcome::right;
  return hit ? Outcome::false_hit : Outcome::false_miss;
}

/// Whether the contract owes an answer to every case with these operands that the method does not refuse by itself.
bool owes_all(const Contract& contract, Operands operands);

/// The answer, or `unsupported` where the contract owes none: most methods cannot tell by themselves whether the probe
/// meets a boundary, or a polygon is planar.
Answer within_contract(const Method& method, const Truth& truth, const Answer& answer);

/// Judged by the method's own contract: coplanar contacts are misses to a transversal method, faces seen from behind to
/// one that culls them; where the contract owes nothing, the answer is not judged. The contact of a hit, and the side
/// from which the triangle is crossed, are owed by methods that tell them, wherever they do. A fault is wrong
/// everywhere: to answer is promised of every query.
Outcome judge(const Method& method, const Truth& truth, const Answer& answer);

/// A binary32 method is on trial only where its operands are exact in binary32.
inline bool takes(const Method& method, Format format) {
  return method.contract.format == Format::binary64 || format == Format::binary32;
}

}  // namespace tribunal
