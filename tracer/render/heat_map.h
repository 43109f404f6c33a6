// What each pixel cost, as pictures.
#pragma once

#include "tracer/render/render.h"

namespace tribunal {

/// Tests a pixel on a logarithmic scale: black for none, through red and yellow to white for the greatest count.
Image tests_heat_map(const Rendering& r);

/// The deepest stage of a pixel's answers: black none, dark blue filter, orange integers, white exact.
Image stages_heat_map(const Rendering& r);

std::uint64_t greatest_tests(const Rendering& r);

}  // namespace tribunal
