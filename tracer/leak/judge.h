// The judgement of what a subject reported of a ray, by the exact truth.
#pragma once

#include <optional>
#include <string>

#include "tracer/leak/outcome.h"
#include "tracer/leak/subject.h"
#include "tracer/leak/truth.h"

namespace tribunal::leak {

/// The outcomes of a subject on one ray, and for each error one face that shows it: a face that should have been
/// reported, or one that should not.
struct Verdict {
  Outcomes outcomes{};
  bool parity_judged = false;
  std::array<std::optional<std::uint32_t>, outcome_count> face{};
  double ulps = 0;      ///< error of t in ulps, if the closest hit is right and t is given
  double degrees = 0;   ///< error of its normal, if one is given that points to the right side
  std::string fault{};  ///< what the fault was, for people

  void add(Outcome o, std::uint32_t f) {
    outcomes.add(o);
    auto& shown = face[static_cast<std::size_t>(o)];
    if (!shown) shown = f;
  }
  std::optional<std::uint32_t> shown_by(Outcome o) const { return face[static_cast<std::size_t>(o)]; }
};

/// Judges what a subject reported of a ray, which must not start on the surface.
Verdict judge(const Surface& surface, const Subject& subject, const AimedRay& aimed, const RayTruth& truth,
              const Testimony& said);

}  // namespace tribunal::leak
