// The classes for people: in words, with a drawing, and the signs that make them.
#pragma once

#include <string>

#include "exact/base/json_fwd.h"
#include "exact/classes/class_table.h"

namespace tribunal {

/// How the probe meets the triangle, in one sentence, of C012: "A segment and a triangle, not in one plane, meet in one
/// point: an end of the segment lies on an edge."
std::string in_words(const ClassRow& row);

/// All 328, segments first: docs/report.md has the keys.
Json classes_json();

}  // namespace tribunal
