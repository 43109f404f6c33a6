#include "exact/base/interrupt.h"

#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <utility>

#include "exact/base/failure.h"
#include "exact/base/shown.h"
#include "exact/base/temporaries.h"

namespace tribunal {
namespace {

// All that the handler touches. Lock-free atomics are safe in a handler, whatever thread it runs on.
std::atomic<int> pending{0}, signals{0}, orderly{0}, unbroken{0};
std::atomic<const char*> note{nullptr};
std::atomic<pid_t> owner{0};
static_assert(std::atomic<int>::is_always_lock_free && std::atomic<const char*>::is_always_lock_free);

/// What happens if standard error cannot take it is no concern of a program that ends.
void say(const char* text) {
  if (write(STDERR_FILENO, text, std::strlen(text)) < 0) return;
}

/// Over the line of progress, if there may be one.
void start_line() {
  if (isatty(STDERR_FILENO) == 1) say("\r\x1b[K");
  say("tribunal: ");
}

[[noreturn]] void end_now(int signal) {
  remove_temporaries();
  start_line();
  say("interrupted");
  if (const char* const more = note) {
    say("; ");
    say(more);
  }
  say("\n");
  _exit(128 + signal);
}

/// In a child between fork and exec, or a plugin's.
void end_as_by_default(int signal) {
  std::signal(signal, SIG_DFL);
  raise(signal);
}

extern "C" void on_signal(int signal) {
  const int saved = errno;
  if (getpid() != owner) {
    end_as_by_default(signal);
  } else {
    int none = 0;
    pending.compare_exchange_strong(none, signal);
    const int count = ++signals;
    const int borne = unbroken > 0 ? 2 : orderly > 0 ? 1 : 0;
    if (count > borne) end_now(signal);
    if (count == 2) {
      start_line();
      say("what was found is being saved; one more signal ends at once\n");
    }
  }
  errno = saved;
}

void handle(int signal) {
  struct sigaction action {};
  action.sa_handler = on_signal;
  action.sa_flags = SA_RESTART;
  sigemptyset(&action.sa_mask);
  sigaction(signal, &action, nullptr);
}

bool is_ignored(int signal) {
  struct sigaction action {};
  return sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

}  // namespace

void watch_interrupts() {
  owner = getpid();
  handle(SIGINT);
  handle(SIGTERM);
  if (!is_ignored(SIGHUP)) handle(SIGHUP);
}

int interrupted() { return pending; }

void fail_if_interrupted(const std::string& missing) {
  if (pending != 0) throw Failure(static_cast<Exit>(128 + pending), "interrupted; " + missing);
}

OrderlyEnd::OrderlyEnd() { ++orderly; }
OrderlyEnd::~OrderlyEnd() { --orderly; }

UnbrokenEnd::UnbrokenEnd() { ++unbroken; }
UnbrokenEnd::~UnbrokenEnd() { --unbroken; }

IfInterrupted::IfInterrupted(std::string text) : note_(shown(text)), before_(note) { note = note_.c_str(); }
IfInterrupted::~IfInterrupted() { note = before_; }

}  // namespace tribunal
