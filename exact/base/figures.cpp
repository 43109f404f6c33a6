#include "exact/base/figures.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <sstream>
#include <string>

#include "exact/base/failure.h"
#include "exact/base/files.h"
#include "exact/base/interrupt.h"
#include "exact/base/json.h"
#include "exact/base/shown.h"

namespace tribunal {
namespace {

/// How a script ended: it was not run, a module was missing, a signal ended it, it could not draw the record, or well.
enum class Ending : std::uint8_t { no_python, no_module, killed, refused, well };

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

  /// How the script ends with this interpreter, a path or a name in PATH.
  Ending run_by(const char* interpreter) {
    char* const arguments[] = {const_cast<char*>(interpreter), file_.data(), json_.data(), directory_.data(), nullptr};
    pid_t child = 0;
    if (posix_spawnp(&child, interpreter, &output_, nullptr, arguments, environ) != 0) return Ending::no_python;
    const int status = status_of(child);
    if (!WIFEXITED(status)) return Ending::killed;
    if (WEXITSTATUS(status) == 0) return Ending::well;
    return WEXITSTATUS(status) == script_lacks_module ? Ending::no_module : Ending::refused;
  }

  /// By Debian's own Python, or where that lacks anything, by the one in PATH.
  Ending run() {
    const Ending first = run_by("/usr/bin/python3");
    const bool lacks = first == Ending::no_python || first == Ending::no_module;
    return lacks && interrupted() == 0 ? run_by("python3") : first;
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

/// Pictures take texts as they are, and no record of ours holds one that would steer them.
void require_plain_texts(const Json& value, const Where& where) {
  for (const auto& item : value.items()) {
    const bool plain = shows_as_it_is(item.key()) &&
                       (!item.value().is_string() || shows_as_it_is(item.value().get_ref<const std::string&>()));
    if (!plain) where.fail("a text with a character that does not show, expected none in what this version writes");
    if (item.value().is_structured()) require_plain_texts(item.value(), where);
  }
}

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

}  // namespace

std::vector<std::string> draw_figures(const std::string& directory, const std::string& script,
                                      const std::string& record) {
  const std::string path = directory + "/" + record;
  require_plain_texts(parse_json(read_file(path), {path}), {path});
  Script plot(directory, record);
  write_file(plot.file(), script);
  const Ending ending = plot.run();
  fail_if_interrupted("not all figures are drawn, " + record + " holds the numbers");
  if (ending == Ending::no_python || ending == Ending::no_module) {
    throw Failure(Exit::resources, "no figures: they need python3 with matplotlib (Debian: python3-matplotlib); " +
                                       plot.log() + " says more, " + record + " holds the numbers");
  }
  if (ending == Ending::killed) throw Failure(Exit::resources, "no figures: a signal ended " + plot.file());
  if (ending == Ending::refused) {
    throw bad_input(path, 0, "not as this version writes it, " + plot.log() + " says where");
  }
  std::vector<std::string> lines = lines_of(read_file(plot.log()));
  std::remove(plot.log().c_str());
  return lines;
}

}  // namespace tribunal
