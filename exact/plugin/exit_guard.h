// A plugin in our own process may call exit, with a code that would be taken for ours.
#pragma once

namespace tribunal {

/// While one lives, an end of the process by exit is reported in one line, with Exit::disagreement as its code. One at
/// a time.
class ExitGuard {
 public:
  explicit ExitGuard(bool on);
  ~ExitGuard();
  ExitGuard(const ExitGuard&) = delete;
  ExitGuard& operator=(const ExitGuard&) = delete;
};

}  // namespace tribunal
