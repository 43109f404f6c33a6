// SIGINT and SIGTERM ask for an orderly end; a second one ends at once.
#pragma once

#include <string>

namespace tribunal {

/// Installs the handlers, for work that calls interrupted() from time to time. Without them a signal ends the program
/// at once.
void watch_interrupts();

/// The signal that asked for an end, or 0.
int interrupted();

/// Fails with 128 + the signal that asked for an end, if one did, and says what is missing now: "no chart written".
void fail_if_interrupted(const std::string& missing);

}  // namespace tribunal
