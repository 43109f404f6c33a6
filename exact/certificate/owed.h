// Whether a log has all that its budget owes.
#pragma once

#include <string>
#include <vector>

#include "exact/certificate/certificate.h"

namespace tribunal {

/// One line for each thing that is missing, changed or not due: sets, streams, numbers of cases, calibration, budget.
/// A log that `judge` wrote owes nothing.
std::vector<std::string> debts_of(const Certificate& c, const LogRecords& log);

}  // namespace tribunal
