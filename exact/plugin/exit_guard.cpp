#include "exact/plugin/exit_guard.h"

#include <unistd.h>

#include <atomic>
#include <cstdio>
#include <cstdlib>

#include "exact/base/failure.h"

namespace tribunal {
namespace {

/// Whether a call of exit would be unexpected now. A variable, since a function that runs at exit takes no arguments.
std::atomic<bool> unexpected{false};

void report_exit() {
  if (!unexpected) return;
  std::fputs("tribunal: a plugin ended the program (exit); with --isolate the run goes on and says on which case\n",
             stderr);
  std::fflush(nullptr);
  _exit(code(Exit::disagreement));
}

}  // namespace

ExitGuard::ExitGuard(bool on) {
  if (!on) return;
  std::atexit(report_exit);
  unexpected = true;
}

ExitGuard::~ExitGuard() { unexpected = false; }

}  // namespace tribunal
