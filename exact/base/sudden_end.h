// An end without exceptions, for places where nothing may be thrown, allocated or locked: C code, signal handlers,
// std::terminate.
#pragma once

#include <string_view>

#include "exact/base/failure.h"

namespace tribunal {

/// Writes `tribunal: line` to standard error by one call of write(2) and ends the process with the exit code. No
/// destructor runs, and nothing that waits in a buffer is written. Lines are cut at 1000 bytes.
[[noreturn]] void end_at_once(Exit exit, std::string_view line) noexcept;

/// What a child process of ours ends with where this program's own memory failed in it, and says nothing.
inline constexpr int child_lacked_memory = 113;

/// From now on std::terminate ends the process by end_without_memory() where it is called for want of memory, and with
/// its line and exit code where for a Failure; a floating-point exception that traps ends it with Exit::fp_environment.
/// Any other cause aborts as before.
void install_last_resort();

/// Says that this process is a child: its parent speaks for it, and takes the faults of a plugin from how it ends.
void become_child();

/// Exit::resources, "out of memory"; in a child `child_lacked_memory`.
[[noreturn]] void end_without_memory() noexcept;

}  // namespace tribunal
