// `fuzz --relations`: checks that need no oracle.
#pragma once

#include <string>

#include "exact/trial/fuzz.h"

namespace tribunal {

/// Runs the plan's cases through all relations, prints a table, writes relations.json and the first witness of each
/// broken relation (its queries, as cases) to `out` unless it is empty. Returns the exit code.
int run_relations(const FuzzPlan& plan, const std::string& out);

}  // namespace tribunal
