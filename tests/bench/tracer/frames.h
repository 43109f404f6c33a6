// Whole Whitted frames: ours and POV-Ray's of the same exported scene.
#pragma once

#include <string>
#include <vector>

#include "tests/bench/medians.h"

namespace tribunal::bench {

/// Draws each scene (data/scenes/NAME.json, at its own size and depth) in turn with sf-filtered and with POV-Ray, each
/// on one thread, `rounds` times, and adds CPU nanoseconds a pixel as NAME/ours and NAME/povray. What is timed is the
/// drawing: no reading, building or writing. Says so and adds nothing where there is no `povray`.
void time_frames(const std::vector<std::string>& scenes, int rounds, Medians& medians);

}  // namespace tribunal::bench
