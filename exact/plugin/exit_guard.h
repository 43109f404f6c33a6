// A plugin in our own process may call exit, with a code that would be taken for ours.
#pragma once

namespace tribunal {

/// While one exists, a call of exit is reported in one line and ends the process with the code Exit::disagreement.
/// There may be one at a time.
class ExitGuard {
 public:
  explicit ExitGuard(bool on);
  ~ExitGuard();
  ExitGuard(const ExitGuard&) = delete;
  ExitGuard& operator=(const ExitGuard&) = delete;
};

}  // namespace tribunal
