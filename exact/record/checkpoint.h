// A fuzz run that was interrupted, on disk: all that is needed to continue it and end with the same bytes.
#pragma once

#include <optional>
#include <string>

#include "exact/trial/fuzz.h"

namespace tribunal {

/// The file in which a run with this output directory saves its checkpoint.
std::string checkpoint_path(const std::string& directory);

/// Saves the counts, the numbers of the cases found wrong, and how far the run came, as a chained log. Removes the
/// results of an earlier run from the directory.
void save_checkpoint(const std::string& directory, const FuzzPlan& plan, const FuzzReport& report);

/// The saved report, or nothing if there is none. Fails with Exit::usage if it belongs to another plan.
std::optional<FuzzReport> load_checkpoint(const std::string& directory, const FuzzPlan& plan);

}  // namespace tribunal
