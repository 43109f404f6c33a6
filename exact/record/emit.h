// A case as a test to paste into another project.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "exact/cases/case_io.h"

namespace tribunal {

/// The languages: "c" (an assert a case, in functions and a main), "gtest" (a TEST a case), "python" (the five exact
/// signs computed again with fractions).
std::vector<std::string> emitted_languages();

/// Whether the text may stand for FUNCTION below: letters, digits and _, no digit first.
bool is_function_name(std::string_view text);

/// The cases, all of triangles, as one file in the language. C and GoogleTest ask the functions FUNCTION_segment and
/// FUNCTION_ray, (const double probe[6], const double triangle[9]) → int, and expect the exact answer of closed sets.
/// Of a case with numbers that are not finite a comment says that there is no test.
/// Fails with Exit::bad_input on a case of a polygon, which `file` is named for.
std::string emit(const std::vector<Case>& cases, std::string_view language, const std::string& function,
                 const std::string& file);

}  // namespace tribunal
