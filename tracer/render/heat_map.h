// What each pixel cost, as pictures.
#pragma once

#include "tracer/render/render.h"

namespace tribunal {

/// The number of face tests per pixel on a logarithmic scale: black for none, through red and yellow to white for the
/// greatest count.
Image tests_heat_map(const Rendering& r);

/// The deepest stage among the answers of each pixel: black for none, dark blue for the filter, orange for integers,
/// white for exact.
Image stages_heat_map(const Rendering& r);

std::uint64_t greatest_tests(const Rendering& r);

}  // namespace tribunal
