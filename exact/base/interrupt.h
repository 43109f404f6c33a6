// SIGINT and SIGTERM ask for an orderly end; a second one ends at once.
#pragma once

namespace tribunal {

/// Installs the handlers: for work that asks interrupted() from time to time. Anything else ends at the signal, as
/// programs do.
void watch_interrupts();

/// The signal that asked for an end, or 0.
int interrupted();

}  // namespace tribunal
