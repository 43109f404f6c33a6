#include "exact/base/sudden_end.h"

#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <new>
#include <system_error>

#include "exact/base/shown.h"
#include "exact/base/temporaries.h"

namespace tribunal {
namespace {

constexpr std::size_t longest_last_line = 1000;

bool is_child = false;

/// Its text may hold what others wrote.
[[noreturn]] void end_with(const Failure& failure) noexcept {
  try {
    end_at_once(failure.exit(), shown_shortly(failure.what(), longest_last_line - 10));
  } catch (const std::bad_alloc&) {
    end_without_memory();
  }
}

[[noreturn]] void on_terminate() {
  if (std::current_exception()) {
    try {
      throw;
    } catch (const std::bad_alloc&) {
      end_without_memory();
    } catch (const Failure& failure) {
      end_with(failure);
    } catch (const std::system_error& error) {
      if (error.code() == std::errc::not_enough_memory) end_without_memory();
    } catch (...) {
    }
  }
  __gnu_cxx::__verbose_terminate_handler();
  std::abort();
}

/// Only exceptions that something has unmasked trap; an integer divided by zero is a fault of ours.
extern "C" void on_trap(int signal, siginfo_t* info, void*) {
  if (info->si_code >= FPE_FLTDIV && info->si_code <= FPE_FLTSUB) {
    end_at_once(Exit::fp_environment, "floating-point environment: exceptions trap, which something has unmasked");
  }
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

}  // namespace

void end_at_once(Exit exit, std::string_view line) noexcept {
  remove_temporaries();
  constexpr std::string_view start = "tribunal: ";
  constexpr std::string_view over_progress = "\r\x1b[K";  // which may stand on a terminal's line
  char text[over_progress.size() + start.size() + longest_last_line + 1];
  char* end = text;
  if (isatty(STDERR_FILENO)) end = std::copy(over_progress.begin(), over_progress.end(), end);
  end = std::copy(start.begin(), start.end(), end);
  line = line.substr(0, longest_last_line);
  end = std::copy_n(line.begin(), whole_characters(line), end);
  *end++ = '\n';
  [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, text, static_cast<std::size_t>(end - text));
  _exit(code(exit));
}

void install_last_resort() {
  std::set_terminate(on_terminate);
  struct sigaction action {};
  action.sa_sigaction = on_trap;
  action.sa_flags = SA_SIGINFO;
  sigaction(SIGFPE, &action, nullptr);
}

void become_child() {
  is_child = true;
  std::set_terminate(__gnu_cxx::__verbose_terminate_handler);
  std::signal(SIGFPE, SIG_DFL);
}

void end_without_memory() noexcept {
  if (is_child) _exit(child_lacked_memory);
  end_at_once(Exit::resources, "out of memory");
}

}  // namespace tribunal
