// The floating-point environment is part of the input: round to nearest, no flush to zero, no denormals-are-zero.
#pragma once

namespace tribunal {

/// Checks the calling thread's environment and repairs it where it is not round-to-nearest with gradual underflow.
/// Fails with Exit::fp_environment if the repair does not hold. Returns whether a repair was made.
bool require_exact_rounding();

/// Whether the calling thread's control word says round-to-nearest without flushing to zero; a few nanoseconds, for
/// use after calls into code that is not ours.
bool has_exact_rounding();

}  // namespace tribunal
