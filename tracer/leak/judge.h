// What was reported of a ray, held against what is exactly so.
#pragma once

#include <optional>

#include "tracer/leak/outcome.h"
#include "tracer/leak/subject.h"
#include "tracer/leak/truth.h"

namespace tribunal::leak {

/// How a subject did on a ray, and for each error one face that shows it: one that ought to have been hit, or that
/// ought not.
struct Verdict {
  Outcomes outcomes{};
  bool parity_judged = false;
  std::array<std::optional<std::uint32_t>, outcome_count> face{};
  double ulps = 0;  ///< of t of the closest hit, where it is right and t is given

  void add(Outcome o, std::uint32_t f) {
    outcomes.add(o);
    auto& shown = face[static_cast<std::size_t>(o)];
    if (!shown) shown = f;
  }
  std::optional<std::uint32_t> shown_by(Outcome o) const { return face[static_cast<std::size_t>(o)]; }
};

/// The ray does not start on the surface.
Verdict judge(const Surface& surface, const Subject& subject, const AimedRay& aimed, const RayTruth& truth,
              const Testimony& said);

}  // namespace tribunal::leak
