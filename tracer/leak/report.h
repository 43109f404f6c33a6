// A mesh trial for people, for programs, and as cases.
#pragma once

#include <string>
#include <vector>

#include "exact/base/json.h"
#include "exact/cases/case_io.h"
#include "tracer/leak/trial.h"

namespace tribunal::leak {

/// Outcomes per million rays, one row per subject; with `by_aim`, one row per subject and aim.
std::string table(const std::vector<Subject>& subjects, const LeakReport& report, Format format, bool by_aim);

/// "watertight on these 300000 rays", or the worst first: leaks, and at what they were aimed. A line for each fault
/// follows. A claim that there are none says what it rests on: whether the mesh is closed, how many of the rays were
/// judged, and how many went at vertices and edges. Of an open mesh it says nothing about watertightness.
std::string verdict(const Surface& surface, const Subject& subject, const LeakReport& trial,
                    const SubjectReport& report);

/// Whether the subject made an error on any ray.
bool has_erred(const SubjectReport& report);

/// All counts; nothing that varies from run to run.
Json summary(const Surface& surface, const std::vector<Subject>& subjects, const LeakReport& report);

/// The faces at which a subject had the most leaks or other errors, with their numbers of rays, for people; at most
/// `most` of them.
std::string worst_faces(const SubjectReport& report, std::size_t most);

/// The findings as cases: the ray, and the triangle that should, or should not, have been reported. `mesh` is the
/// file's name.
std::vector<Case> cases_of(const Surface& surface, const Subject& subject, const SubjectReport& report,
                           const std::string& mesh, std::uint64_t seed);

}  // namespace tribunal::leak
