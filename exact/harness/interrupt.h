// SIGINT and SIGTERM ask for an orderly end; a second one ends at once.
#pragma once

namespace tribunal {

/// Installs the handlers. Call once, early.
void watch_interrupts();

/// The signal that asked for an end, or 0.
int interrupted();

}  // namespace tribunal
