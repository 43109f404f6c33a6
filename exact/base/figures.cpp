#include "exact/base/figures.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <string>

#include "exact/base/failure.h"
#include "exact/base/files.h"

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
    int status = 0;
    while (waitpid(child, &status, 0) < 0) {
      if (errno != EINTR) return false;
    }
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
  }

  const std::string& file() const { return file_; }
  const std::string& log() const { return log_; }

 private:
  std::string file_, json_, directory_, log_;
  posix_spawn_file_actions_t output_{};
};

}  // namespace

void draw_figures(const std::string& directory, const std::string& script, const std::string& record) {
  Script plot(directory, record);
  write_file(plot.file(), script);
  if (!plot.run_by("/usr/bin/python3") && !plot.run_by("python3")) {
    throw Failure(Exit::resources, "no figures: they need python3 with matplotlib (Debian: python3-matplotlib); " +
                                       plot.log() + " says more, " + record + " holds the numbers");
  }
  std::remove(plot.log().c_str());
}

}  // namespace tribunal
