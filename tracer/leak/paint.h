// Where a method erred, as colours on the mesh.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "tracer/leak/trial.h"

namespace tribunal::leak {

/// Red, green, blue.
using FaceColour = std::array<std::uint8_t, 3>;

/// Of a face with so many leaks and other errors, where the worst faces have `most_…`. Light grey where nothing went
/// wrong. Leaks go before all else: from pale apricot by orange to dark red, the more the darker. Else from pale to
/// middle blue, the more other errors the darker, but never as dark as the worst leaks, which the eye must find first.
/// By the square root of the share, so that a single face with very many does not leave all others pale.
///
/// Both ramps fall steadily in lightness, and differ as orange and blue do, so that they read the same in grey and to
/// people who do not tell red from green.
FaceColour colour_of(std::uint64_t leaks, std::uint64_t most_leaks, std::uint64_t errors, std::uint64_t most_errors);

/// The surface as a PLY file with a colour for each face, by rays that leaked at it, and by those that erred otherwise.
std::string painted(const Surface& surface, const SubjectReport& report);

}  // namespace tribunal::leak
