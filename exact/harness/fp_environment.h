// The floating-point environment is part of the input: round to nearest, no flush to zero, no denormals-are-zero.
#pragma once

namespace tribunal {

/// Checks the calling thread's environment and repairs it where it is not round-to-nearest with gradual underflow.
/// Fails with Exit::fp_environment if the repair does not hold. Returns whether a repair was made.
bool require_exact_rounding();

/// Whether the calling thread's control bits still say round-to-nearest with gradual underflow. A few nanoseconds:
/// cheap enough after every call of code that is on trial.
bool rounding_is_intact();

}  // namespace tribunal
