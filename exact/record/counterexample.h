// Counterexamples: self-contained case lines, with the exact evidence beside them.
#pragma once

#include <string>
#include <vector>

#include "exact/cases/case_io.h"
#include "exact/trial/fuzz.h"

namespace tribunal {

/// The exact signs and parameter of a query, as anyone with rationals can recompute them.
/// `abcp`, `abcq` are orient3d(a,b,c,·) of source and target; `pqab`, `pqbc`, `pqca` those of the probe's line.
/// For a ray, q stands for the direction. `t` is where the probe meets the plane, as a fraction of [p,q] or in
/// multiples of d; absent if it is parallel. Of a polygon: the exact `contact` and `planar`.
Json exact_evidence(const Query& query);

/// The case with the exact answer, and with a "finding" that says what the method answered, the answer due by its
/// convention, the exact evidence, every method's answer (null where operands or contract do not fit) and what it was
/// made with.
Case with_finding(Case c, const Method& method, const Truth& truth, const Answer& answer);

/// The same, but the method is asked again, if it can be asked: a fault then replaces its answer.
Case with_steady_finding(Case c, const Method& method, const Truth& truth, const Answer& answer);

/// Where the case stands among others, by what its finding says; last if it has none. Fails with Exit::bad_input, for
/// the finding at this place, where that says it in other words than `with_finding`.
Rank rank_of(const Case& c, const Where& where);
Rank rank_of(const Case& c);

/// The worst first; cases of one rank keep their order.
void sort_by_rank(std::vector<Case>& cases);

/// Asks all findings of a report again, notes faults, causes and what naive methods answer, and sorts the findings by
/// rank.
void ask_again(const FuzzPlan& plan, FuzzReport& report);

/// The query, shrunk, with its finding; `source` says where it came from, `before` which fault was seen there, if any.
Case to_counterexample(const Method& method, const Query& query, Format format, const std::string& source,
                       Status before = Status::ok);

/// The finding, shrunk; its origin is the family, seed, case number and stress level that it came from.
Case to_counterexample(const FuzzPlan& plan, const Finding& finding);

/// The case, shrunk, with its finding made anew; its origin stays. Fails with Exit::bad_input if the method answers it
/// rightly.
Case shrunk(Case c, const Method& method);

/// One JSON line each.
std::string to_lines(const std::vector<Case>& cases);

/// What is wrong with a case's own "expect" or "class"; empty if nothing is.
std::string mistaken_claim(const Case& c, const Truth& truth);

/// What `replay` prints of a case: points, evidence, exact answer and that of each method. Sets `wrong` if one of
/// them that takes the case answers wrongly, or the case claims something false of itself.
std::string replay(const Case& c, const std::vector<Method>& methods, bool& wrong);

}  // namespace tribunal
