#include "exact/base/figures.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <ctime>
#include <string>

#include "exact/base/failure.h"
#include "exact/base/files.h"
#include "exact/base/interrupt.h"

namespace tribunal {
namespace {

/// The plot script in a file, the arguments for it, and the file that takes what it prints.
class Script {
 public:
  Script(const std::string& directory, const std::string& record)
      : file_(directory + "/plot.py"),
        json_(directory + "/" + record),
        directory_(directory),
        log_(directory + "/plot.log") {
    posix_spawn_file_actions_init(&output_);
    posix_spawn_file_actions_addopen(&output_, STDOUT_FILENO, log_.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
    posix_spawn_file_actions_adddup2(&output_, STDOUT_FILENO, STDERR_FILENO);
  }
  ~Script() { posix_spawn_file_actions_destroy(&output_); }
  Script(const Script&) = delete;
  Script& operator=(const Script&) = delete;

  /// Whether this interpreter, a path or a name in PATH, exists and the script ends well.
  bool run_by(const char* interpreter) {
    char* const arguments[] = {const_cast<char*>(interpreter), file_.data(), json_.data(), directory_.data(), nullptr};
    pid_t child = 0;
    if (posix_spawnp(&child, interpreter, &output_, nullptr, arguments, environ) != 0) return false;
    const int status = status_of(child);
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
  }

  const std::string& file() const { return file_; }
  const std::string& log() const { return log_; }

 private:
  /// Waits for the child by looking from time to time, since a signal handler does not end a call of waitpid; a signal
  /// ends the child. −1 if it cannot be waited for.
  static int status_of(pid_t child) {
    constexpr timespec pause{0, 20'000'000};
    int status = 0;
    bool told = false;
    for (;;) {
      const pid_t ended = waitpid(child, &status, WNOHANG);
      if (ended == child) return status;
      if (ended < 0 && errno != EINTR) return -1;
      if (interrupted() != 0 && !told) told = kill(child, SIGTERM) == 0;
      nanosleep(&pause, nullptr);
    }
  }

  std::string file_, json_, directory_, log_;
  posix_spawn_file_actions_t output_{};
};

}  // namespace

void draw_figures(const std::string& directory, const std::string& script, const std::string& record) {
  Script plot(directory, record);
  write_file(plot.file(), script);
  const bool drawn = plot.run_by("/usr/bin/python3") || (interrupted() == 0 && plot.run_by("python3"));
  fail_if_interrupted("not all figures are drawn, " + record + " holds the numbers");
  if (!drawn) {
    throw Failure(Exit::resources, "no figures: they need python3 with matplotlib (Debian: python3-matplotlib); " +
                                       plot.log() + " says more, " + record + " holds the numbers");
  }
  std::remove(plot.log().c_str());
}

}  // namespace tribunal
