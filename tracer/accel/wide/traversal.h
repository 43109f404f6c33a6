// Walking down the tree with one probe, on the vector lanes that the machine has.
#pragma once

#include <cstdint>
#include <span>

#include "tracer/accel/wide/probe.h"

namespace tribunal {

/// A primitive that the walk could not rule out, with what the vector lanes know of it. If `certain`, the probe
/// certainly hits it in general position. num is orient3d(a, b, c, source), and den is how much that volume decreases
/// along the direction d: the probe reaches the plane at t = num/den. Both are known up to ±bound; bound is infinite
/// where nothing is known.
struct Candidate {
  Place place;
  bool certain;
  double num, den, bound;
};

/// Takes every candidate, in the order of the walk.
class CandidateQuery {
 public:
  /// Takes a candidate; returns whether the walk may stop.
  virtual bool found(const Candidate& f) = 0;

  float limit = WideProbe::far_away;  ///< on τ: boxes entered later are skipped; `found` may lower it

 protected:
  ~CandidateQuery() = default;
};

/// Counts of a walk: box tests, eight per node, and triangles that the filter was certain are missed.
struct WalkCounts {
  std::uint64_t boxes = 0, missed = 0;
};

/// One of many walks: a ray, its form for tests of boxes, and the query that takes its candidates.
struct RayWalk {
  const Ray* ray;
  const WideProbe* probe;
  CandidateQuery* query;
};

/// Law of all walks: every primitive that the probe exactly meets at t ≤ limit becomes a candidate. The filtering
/// walks leave out triangles that the filter of shared_volumes.h is certain are missed; `visit_all` reports all
/// primitives of every leaf that it enters.
struct TreeTarget {
  void (*filter_ray)(const WideTree&, const WideProbe&, const Ray&, CandidateQuery&, WalkCounts&);
  void (*filter_segment)(const WideTree&, const WideProbe&, const Segment&, CandidateQuery&, WalkCounts&);
  void (*visit_all)(const WideTree&, const WideProbe&, CandidateQuery&, WalkCounts&);

  /// probes[i] = WideProbe(rays[i], frame).
  void (*make_probes)(std::span<const Ray>, const Frame&, WideProbe* probes);

  /// Walks each ray as filter_ray does, many in turn. No query may stop its walk, and a query may get a candidate
  /// twice.
  void (*filter_rays)(const WideTree&, std::span<const RayWalk>, WalkCounts&);
};

extern const TreeTarget tree_avx512, tree_avx2, tree_portable;

/// The functions for the instruction set that the batch uses too (exact/filtered/batch.h).
const TreeTarget& tree_target();

}  // namespace tribunal
