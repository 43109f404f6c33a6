// SIGINT and SIGTERM ask for an orderly end; a second one ends at once.
#pragma once

namespace tribunal {

/// Installs the handlers, for work that calls interrupted() from time to time. Without them a signal ends the program
/// at once.
void watch_interrupts();

/// The signal that asked for an end, or 0.
int interrupted();

}  // namespace tribunal
