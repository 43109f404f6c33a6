#include "exact/filtered/filtered.h"

#include "core/due.h"
#include "core/segura_feito.h"
#include "exact/classes/classify.h"
#include "exact/filtered/filtered_kernel.h"
#include "exact/filtered/stages/exact_stages.h"
#include "exact/filtered/term_filter.h"
#include "exact/filtered/within_filter.h"

namespace tribunal {

using namespace detail;

namespace {

bool all_finite(const Segment& s, const Triangle& t) { return is_finite(s) && is_finite(t); }
bool all_finite(const Ray& r, const Triangle& t) { return is_finite(r) && is_finite(t); }

/// A certain answer, which says the side too.
template <class P>
Answer certain(bool hit, const P& probe, const Triangle& t) {
  Answer answer = tribunal::certain(hit);
  if (hit) answer.facing = facing(probe, t, FilteredKernel());
  return answer;
}

template <class P>
[[gnu::noinline]] Answer intersect_exactly(const P& probe, const Triangle& t) {
  if (!all_finite(probe, t)) return refusal(Status::nonfinite);
  const auto decided = decide_exactly(
      Pair<P>{probe, t}, [](const auto& o, const auto& k) { return segura_feito(o.probe, o.triangle, k); });
  Answer answer = decided.result;
  answer.stage = decided.stage;
  return answer;
}

template <class P>
[[gnu::noinline]] Answer intersect_past_filter(const P& probe, const Triangle& t) {
  const std::optional<bool> hit = filter_hits_by_terms(probe, t, volume_terms_filter);
  return hit ? certain(*hit, probe, t) : intersect_exactly(probe, t);
}

template <class P>
[[gnu::flatten]] Answer staged_intersect(const P& probe, const Triangle& t) {
  const auto c = conclude<P>(arms_of<double>(probe, t), pair_filter<P>);
  if (c.hit == c.miss) return intersect_past_filter(probe, t);
  Answer answer = tribunal::certain(c.hit);
  if (c.hit) answer.facing = c.volumes.sides.toward < 0 ? Facing::front : Facing::back;
  return answer;
}

template <class P>
Answer staged_classify(const P& probe, const Triangle& t) {
  if (!all_finite(probe, t)) return refusal(Status::nonfinite);
  Tally tally;
  Answer answer = classify(probe, t, FilteredKernel(&tally));
  answer.stage = tally.deepest();
  return answer;
}

[[gnu::noinline]] Answer intersect_within_exactly(const Ray& r, const Bounds& bounds, const Triangle& t) {
  if (!all_finite(r, t) || !is_finite(bounds)) return refusal(Status::nonfinite);
  const DefaultRounding in_this_scope;
  Answer answer = segura_feito(r, bounds, t, RationalKernel{});
  answer.stage = Stage::exact;
  return answer;
}

}  // namespace

bool hits(const Ray& r, const Bounds& bounds, const Triangle& t) { return intersect(r, bounds, t).hit; }

Answer intersect(const Ray& r, const Bounds& bounds, const Triangle& t) {
  const std::optional<bool> hit = is_finite(bounds) ? filter_hits_within(r, bounds, t) : std::nullopt;
  return hit ? certain(*hit, r, t) : intersect_within_exactly(r, bounds, t);
}

bool hits_exactly(const Segment& s, const Triangle& t) { return intersect_exactly(s, t).hit; }
bool hits_exactly(const Ray& r, const Triangle& t) { return intersect_exactly(r, t).hit; }

bool hits_past_filter(const Segment& s, const Triangle& t) { return intersect_past_filter(s, t).hit; }
bool hits_past_filter(const Ray& r, const Triangle& t) { return intersect_past_filter(r, t).hit; }

Answer intersect(const Segment& s, const Triangle& t) { return staged_intersect(s, t); }
Answer intersect(const Ray& r, const Triangle& t) { return staged_intersect(r, t); }
Answer intersect(const TrianglePair& pair) {
  return std::visit([&](const auto& probe) { return staged_intersect(probe, pair.triangle); }, pair.probe);
}

Answer classify(const Segment& s, const Triangle& t) { return staged_classify(s, t); }
Answer classify(const Ray& r, const Triangle& t) { return staged_classify(r, t); }

Sign compare_hits(const Ray& r, const Triangle& s, const Triangle& t) { return FilteredKernel().compare_hits(r, s, t); }

}  // namespace tribunal
