// A drawing of a segment and a triangle.
#pragma once

#include <string>

#include "core/operands.h"

namespace tribunal {

/// Inline SVG: both in an oblique projection, each axis scaled by itself. It shows rounded coordinates.
std::string sketch(const Segment& s, const Triangle& t);

}  // namespace tribunal
