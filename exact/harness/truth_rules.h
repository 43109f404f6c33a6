// Where the exact answer differs by the operands.
#pragma once

#include <string>

#include "exact/harness/truth.h"

namespace tribunal {

/// The target must be a triangle.
Truth exact_truth_of_triangle(const Query& query);

/// The target must be a polygon.
Truth exact_truth_of_polygon(const Query& query);

/// Ends the run with both witnesses and the query.
[[noreturn]] void contradiction(const Query& query, const std::string& one, const std::string& other);

}  // namespace tribunal
