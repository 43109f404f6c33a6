// The floating-point environment is part of the input: round to nearest, no flush to zero, no denormals-are-zero, long
// double with all its digits, no exception that traps. It is the thread's own, and anything loaded into the process may
// have changed it before the thread began, or changes it while the thread works.
#pragma once

namespace tribunal {

/// Checks the calling thread's environment and repairs it where it is another: at the start of a thread, and after
/// calls into code that is not ours. Fails with Exit::fp_environment if the repair does not hold. Returns whether a
/// repair was made.
bool require_exact_rounding();

/// Whether the calling thread's control words say so; a few nanoseconds, for use after calls into code that is not
/// ours.
bool has_exact_rounding();

/// Fails with Exit::fp_environment where the environment is another than at the start, since what was computed since
/// may be wrong; the environment is repaired. Whatever leaves the program passes this: a block of work when it is done,
/// and output before it is written.
void refuse_changed_rounding();

}  // namespace tribunal
