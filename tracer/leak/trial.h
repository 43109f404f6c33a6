// Methods on trial on a mesh: many rays, each judged.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "tracer/leak/judge.h"

namespace tribunal::leak {

struct LeakPlan {
  std::uint64_t seed = 1, rays = 0;
  std::span<const AimedRay> given{};  ///< rays to take instead of aiming some; seed and rays then say nothing
  unsigned threads = 1;
  bool every_face = false;  ///< ask about every face, not only about those whose boxes the ray meets
  std::size_t keep = 4;     ///< findings to keep, a subject and outcome

  std::uint64_t count() const { return given.empty() ? rays : given.size(); }
};

/// A ray on which a subject erred.
struct LeakFinding {
  std::uint64_t k;
  AimedRay aimed;
  Outcome outcome;
  std::uint32_t face;   ///< a face that should have been reported, or should not
  std::string fault{};  ///< what the fault was, for people
};

/// How one subject did.
struct SubjectReport {
  LeakTally tally{};
  std::map<Outcome, std::vector<LeakFinding>> findings{};  ///< of errors, the first of each kind
  std::vector<std::uint32_t> leaks_at{}, errors_at{};      ///< by face; other errors than leaks in the second
  double worst_ulps = 0;                                   ///< the worst error of t of right closest hits, in ulps
  double worst_degrees = 0;                                ///< of their normals
  std::map<std::string, std::uint64_t> faults{};           ///< by what they were, for people
};

struct LeakReport {
  std::vector<SubjectReport> subjects{};  ///< in the order given
  std::uint64_t rays = 0;                 ///< judged
  std::uint64_t inside = 0;               ///< of these, from inside
  std::uint64_t exactly = 0;              ///< of these, through an edge or a vertex
  std::uint64_t skipped = 0;              ///< not judged: they would start on the surface
  bool complete = false;
  int signal = 0;  ///< the signal that ended the trial early, or 0
};

/// Runs the trial. The report does not depend on the number of threads.
LeakReport run_leak_trial(const Surface& surface, const std::vector<Subject>& subjects, const LeakPlan& plan);

}  // namespace tribunal::leak
