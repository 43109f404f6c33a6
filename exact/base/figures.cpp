#include "exact/base/figures.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <ctime>
#include <set>
#include <sstream>
#include <string>

#include "exact/base/failure.h"
#include "exact/base/files.h"
#include "exact/base/interrupt.h"
#include "exact/base/record.h"
#include "exact/base/shown.h"

namespace tribunal {
namespace {

/// How a script ended: it was not run, a module was missing, a signal ended it, Python itself gave up, it could not
/// write, it could not draw the record, or well.
enum class Ending : std::uint8_t { no_python, no_module, killed, gave_up, unwritten, refused, well };

Ending ending_of(int exit) {
  switch (exit) {
    case 0:
      return Ending::well;
    case script_refuses_record:
      return Ending::refused;
    case script_lacks_module:
      return Ending::no_module;
    case script_cannot_write:
      return Ending::unwritten;
    default:
      return Ending::gave_up;
  }
}

/// Signals that we ignore are no concern of a child.
class Attributes {
 public:
  Attributes() {
    posix_spawnattr_init(&value_);
    sigset_t ignored;
    sigemptyset(&ignored);
    for (const int signal : {SIGPIPE, SIGXFSZ}) sigaddset(&ignored, signal);
    posix_spawnattr_setsigdefault(&value_, &ignored);
    posix_spawnattr_setflags(&value_, POSIX_SPAWN_SETSIGDEF);
  }
  ~Attributes() { posix_spawnattr_destroy(&value_); }
  Attributes(const Attributes&) = delete;
  Attributes& operator=(const Attributes&) = delete;

  const posix_spawnattr_t* get() const { return &value_; }

 private:
  posix_spawnattr_t value_{};
};

/// The plot script in a file, the arguments for it, and the file that takes what it prints.
class Script {
 public:
  Script(const std::string& directory, const std::string& record, const std::string& drawn)
      : file_(directory + "/plot.py"), json_(directory + "/" + record), drawn_(drawn), log_(drawn + "/plot.log") {
    posix_spawn_file_actions_init(&output_);
    posix_spawn_file_actions_addopen(&output_, STDOUT_FILENO, log_.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
    posix_spawn_file_actions_adddup2(&output_, STDOUT_FILENO, STDERR_FILENO);
  }
  ~Script() { posix_spawn_file_actions_destroy(&output_); }
  Script(const Script&) = delete;
  Script& operator=(const Script&) = delete;

  /// How the script ends with this interpreter, a path or a name in PATH.
  Ending run_by(const char* interpreter) {
    char* const arguments[] = {const_cast<char*>(interpreter), file_.data(), json_.data(), drawn_.data(), nullptr};
    const Attributes attributes;
    pid_t child = 0;
    if (posix_spawnp(&child, interpreter, &output_, attributes.get(), arguments, environ) != 0)
      return Ending::no_python;
    const int status = status_of(child);
    return WIFEXITED(status) ? ending_of(WEXITSTATUS(status)) : Ending::killed;
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
  /// Waits for the child by looking from time to time, since a signal handler does not end a call of waitpid. A signal
  /// ends the child, after a second by force. −1 if it cannot be waited for.
  static int status_of(pid_t child) {
    constexpr timespec pause{0, 20'000'000};
    constexpr int pauses_of_grace = 50;
    int status = 0;
    for (int told = 0;;) {
      const pid_t ended = waitpid(child, &status, WNOHANG);
      if (ended == child) return status;
      if (ended < 0 && errno != EINTR) return -1;
      if (interrupted() != 0 && told++ % pauses_of_grace == 0) kill(child, told == 1 ? SIGTERM : SIGKILL);
      nanosleep(&pause, nullptr);
    }
  }

  std::string file_, json_, drawn_, log_;
  posix_spawn_file_actions_t output_{};
};

/// Pictures take texts as they are, and no record of ours holds one that would steer them.
void require_plain_texts(const Json& value, const Where& where) {
  for (const auto& item : value.items()) {
    const bool plain =
        shows_as_it_is(item.key()) && (!item.value().is_string() || shows_as_it_is(Record(item.value(), where).text()));
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

std::string name_of(const std::string& path) { return path.substr(path.rfind('/') + 1); }

/// Whether a file of this name is a figure of one of these names.
bool is_figure(const std::string& file, const FigureNames& names) {
  constexpr const char* endings[] = {".svg", ".pdf", ".png"};
  for (const char* const ending : endings) {
    if (!file.ends_with(ending)) continue;
    const std::string stem = file.substr(0, file.size() - std::strlen(ending));
    return std::ranges::any_of(names, [&](const std::string& name) {
      return name.ends_with('*') ? stem.starts_with(name.substr(0, name.size() - 1)) : stem == name;
    });
  }
  return false;
}

/// What the script said, where people find it.
void keep_log(const std::string& log, const std::string& directory) {
  if (exists(log)) write_file(directory + "/plot.log", shown_lines(read_file(log)));
}

/// Moves all that was drawn into the directory.
void publish(const std::string& drawn, const std::string& directory, const FigureNames& names) {
  OutputSet set;
  std::set<std::string> fresh;
  for (const std::string& file : files_in(drawn)) {
    if (name_of(file) == "plot.log") continue;
    fresh.insert(name_of(file));
    set.adopt(file, directory + "/" + name_of(file));
  }
  for (const std::string& file : files_in(directory)) {
    if (is_figure(name_of(file), names) && !fresh.contains(name_of(file))) set.drop(file);
  }
  set.drop(directory + "/plot.log");  // of an earlier script, that failed
  set.commit();
}

}  // namespace

void drop_figures(OutputSet& set, const std::string& directory, const FigureNames& names) {
  for (const std::string& file : files_in(directory)) {
    if (is_figure(name_of(file), names)) set.drop(file);
  }
}

std::vector<std::string> draw_figures(const std::string& directory, const std::string& script,
                                      const std::string& record, const FigureNames& names) {
  const std::string path = directory + "/" + record;
  require_plain_texts(parse_json(read_file(path), {path}), {path});
  const UnbrokenEnd unbroken;  // of the child and of what it writes
  const TemporaryDirectory drawn(directory);
  Script plot(directory, record, drawn.path());
  write_file(plot.file(), script);
  const Ending ending = plot.run();
  fail_if_interrupted("not all figures are drawn, " + record + " holds the numbers");
  const std::string log = directory + "/plot.log";
  if (ending != Ending::well) keep_log(plot.log(), directory);
  if (ending == Ending::no_python || ending == Ending::no_module) {
    throw Failure(Exit::resources, "no figures: they need python3 with matplotlib (Debian: python3-matplotlib); " +
                                       log + " says more, " + record + " holds the numbers");
  }
  if (ending == Ending::killed) throw Failure(Exit::resources, "no figures: a signal ended " + plot.file());
  if (ending == Ending::gave_up) throw Failure(Exit::resources, "no figures: Python gave up, " + log + " says why");
  if (ending == Ending::unwritten) throw Failure(Exit::output_failed, "cannot write the figures, " + log + " says why");
  if (ending == Ending::refused) {
    throw bad_input(path, 0, "not as this version writes it, " + log + " says where");
  }
  std::vector<std::string> lines = lines_of(read_file(plot.log()));
  publish(drawn.path(), directory, names);
  return lines;
}

}  // namespace tribunal
