// A drawing of a segment and a triangle.
#pragma once

#include <string>

#include "core/operands.h"

namespace tribunal {

/// Inline SVG: both seen at a slant, each axis scaled on its own. A likeness; what it shows is rounded.
std::string sketch(const Segment& s, const Triangle& t);

}  // namespace tribunal
