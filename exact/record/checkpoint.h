// A fuzz run that was interrupted, on disk: what it takes to go on and end with the same bytes.
#pragma once

#include <optional>
#include <string>

#include "exact/trial/fuzz.h"

namespace tribunal {

/// Where a run in this directory leaves its checkpoint.
std::string checkpoint_path(const std::string& directory);

/// Counts, the numbers of the cases found wrong, and how far the run came, as a chained log. The results of an earlier
/// run in the directory are removed: they are not of this one.
void save_checkpoint(const std::string& directory, const FuzzPlan& plan, const FuzzReport& report);

/// The saved report, or nothing if there is none. Fails with Exit::usage if it belongs to another plan.
std::optional<FuzzReport> load_checkpoint(const std::string& directory, const FuzzPlan& plan);

void remove_checkpoint(const std::string& directory);

}  // namespace tribunal
