#include "exact/base/interrupt.h"

#include <csignal>

#include "exact/base/failure.h"

namespace tribunal {
namespace {

volatile std::sig_atomic_t pending = 0;

extern "C" void remember(int signal) {
  pending = signal;
  std::signal(signal, SIG_DFL);
}

}  // namespace

void watch_interrupts() {
  std::signal(SIGINT, remember);
  std::signal(SIGTERM, remember);
}

int interrupted() { return pending; }

void fail_if_interrupted(const std::string& missing) {
  if (pending != 0) throw Failure(static_cast<Exit>(128 + pending), "interrupted; " + missing);
}

}  // namespace tribunal
