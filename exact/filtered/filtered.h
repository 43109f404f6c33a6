// The certified test: is it a hit? Exact for every finite input, at nearly the price of an uncertified test.
// Needs the standard library and GLM, no CGAL and no GMP. A page of examples: docs/using-the-library.md.
#pragma once

#include <optional>

#include "core/answer.h"
#include "core/operands.h"
#include "core/sign.h"
#include "exact/filtered/filter_bounds.h"
#include "exact/filtered/shared_volumes.h"

namespace tribunal {

// Laws of everything below.
// (1) Operands are closed point sets with binary64 coordinates, taken as the exact numbers they are. Degenerate
//     operands, subnormals and ±DBL_MAX included: triangles may be segments or points, segments and rays points.
// (2) The answer is that of sf-rational: exact, always.
// (3) Neither the rounding mode nor flush-to-zero of the calling thread changes an answer.
// (4) All functions are pure and safe to call from any number of threads at once.
// (5) An operand with a NaN or an infinity meets nothing: `hits` is false, answers have Status::nonfinite.

/// Whether the probe certainly meets or certainly misses the triangle; nothing where rounding could matter. Without
/// branches, so that its time does not depend on the answer.
template <class N, class P>
[[gnu::flatten]] std::optional<bool> filter_hits(const P& probe, const Triangle& t, const detail::PairConstants<N>& c) {
  const auto certain = detail::conclude<P>(detail::arms_of<N>(probe, t), c);
  if (certain.hit == certain.miss) return std::nullopt;
  return certain.hit;
}

/// The same answer without any filter: integers of a fixed width where the operands allow, else GMP. Some 100 ns.
bool hits_exactly(const Segment& s, const Triangle& t);
bool hits_exactly(const Ray& r, const Triangle& t);

/// The same answer for operands on which filter_hits is not certain: by a second filter (term_filter.h), then exactly.
bool hits_past_filter(const Segment& s, const Triangle& t);
bool hits_past_filter(const Ray& r, const Triangle& t);

/// Whether the closed segment and the closed triangle have a point in common. On the order of 10 ns.
[[gnu::flatten]] inline bool hits(const Segment& s, const Triangle& t) {
  if (const std::optional<bool> certain = filter_hits(s, t, detail::pair_filter<Segment>)) return *certain;
  return hits_past_filter(s, t);
}

/// Whether the ray {o + λ·d, λ ≥ 0} and the closed triangle have a point in common.
[[gnu::flatten]] inline bool hits(const Ray& r, const Triangle& t) {
  if (const std::optional<bool> certain = filter_hits(r, t, detail::pair_filter<Ray>)) return *certain;
  return hits_past_filter(r, t);
}

/// Hit, kind of contact, end of the probe that touches, side from which it crosses, and the stage that decided.
Answer intersect(const Segment& s, const Triangle& t);
Answer intersect(const Ray& r, const Triangle& t);
Answer intersect(const TrianglePair& pair);

/// Of the part tmin ≤ t ≤ tmax of the ray {o + t·d}: whether it has a point in common with the closed triangle. Both
/// bounds are closed and taken as the exact numbers they are; tmin ≥ 0 must be finite, tmax ≥ tmin may be +∞. The
/// contact is the ray's where the ray crosses the plane, also where tmin = tmax; `at` says `source` at tmin, `target`
/// at tmax.
bool hits(const Ray& r, const Bounds& bounds, const Triangle& t);
Answer intersect(const Ray& r, const Bounds& bounds, const Triangle& t);

/// The answer of `intersect` where the filter is certain: all volumes are nonzero, so the contact is in general
/// position.
constexpr Answer certain(bool hit) {
  Answer answer = hit ? hit_at(Contact::interior, At::between) : miss();
  answer.stage = Stage::filter;
  return answer;
}

/// `intersect` with the class: one of 163 for segments, one of 165 for rays (docs/formats.md). About a microsecond.
Answer classify(const Segment& s, const Triangle& t);
Answer classify(const Ray& r, const Triangle& t);

/// Sign of λ₁ − λ₂, where the ray crosses the planes of s and t at o + λ₁·d and o + λ₂·d. Exact. Neither plane may be
/// parallel to the ray.
Sign compare_hits(const Ray& r, const Triangle& s, const Triangle& t);

}  // namespace tribunal
