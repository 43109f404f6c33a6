#include "exact/base/interrupt.h"

#include <csignal>

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

}  // namespace tribunal
