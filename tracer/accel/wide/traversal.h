// Walking down the tree with one probe, on the vector lanes that the machine has.
#pragma once

#include <cstdint>
#include <span>

#include "tracer/accel/wide/probe.h"

namespace tribunal {

/// A primitive that the walk came upon, with what the lanes know of it. Where `certain`, the probe certainly hits it in
/// general position. num and den are orient3d(a, b, c, source) and, negated, what a point gains on the plane along d:
/// the probe reaches the plane at num/den. Each is known up to ±bound; bound is infinite where nothing is known.
struct Candidate {
  Place place;
  bool certain;
  double num, den, bound;
};

/// Takes every candidate, in the order of the walk.
class CandidateQuery {
 public:
  /// Whether the walk may stop.
  virtual bool found(const Candidate& f) = 0;

  float limit = WideProbe::far_away;  ///< on τ: boxes entered later are skipped; `found` may lower it

 protected:
  ~CandidateQuery() = default;
};

/// What a walk did: box tests, eight a node; triangles that were certainly missed.
struct WalkCounts {
  std::uint64_t boxes = 0, missed = 0;
};

/// One of many walks: a ray, its form for tests of boxes, and the query that takes its candidates.
struct RayWalk {
  const Ray* ray;
  const WideProbe* probe;
  CandidateQuery* query;
};

/// Law of all walks: every primitive that the probe exactly meets at t ≤ limit is found, but for those that are
/// certainly missed. `filtered` walks skip triangles that the filter of shared_volumes.h is certain are missed; the
/// plain walk finds all primitives of all leaves.
struct TreeTarget {
  void (*filter_ray)(const WideTree&, const WideProbe&, const Ray&, CandidateQuery&, WalkCounts&);
  void (*filter_segment)(const WideTree&, const WideProbe&, const Segment&, CandidateQuery&, WalkCounts&);
  void (*visit_all)(const WideTree&, const WideProbe&, CandidateQuery&, WalkCounts&);

  /// probes[i] = WideProbe(rays[i], frame).
  void (*make_probes)(std::span<const Ray>, const Frame&, WideProbe* probes);

  /// Each as by filter_ray, all at the same time; no `found` may stop its walk. A candidate may come twice.
  void (*filter_rays)(const WideTree&, std::span<const RayWalk>, WalkCounts&);
};

extern const TreeTarget tree_avx512, tree_avx2, tree_portable;

/// That of the batch's target in use (exact/filtered/batch.h).
const TreeTarget& tree_target();

}  // namespace tribunal
