// One counterexample as a person reads it.
#pragma once

#include <string>

#include "core/method.h"
#include "exact/cases/case_io.h"

namespace tribunal {

/// Of a case with a finding: the points, the exact answer with its class, and of a triangle the signs of the five
/// volumes, exact and as the formula gives them in the method's format; what was answered, and what is due.
std::string counterexample_in_words(const Method& method, const Case& c);

}  // namespace tribunal
