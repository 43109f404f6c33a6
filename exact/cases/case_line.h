// A query as one line of text, for messages.
#pragma once

#include <string>

#include "core/query.h"

namespace tribunal {

/// A binary64 case with this id, as a case file holds it.
std::string case_line(const std::string& id, const Query& query);

}  // namespace tribunal
