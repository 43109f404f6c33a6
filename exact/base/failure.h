// Exit codes, and the one exception that carries one to main.
#pragma once

#include <stdexcept>
#include <string>

namespace tribunal {

/// What the program's exit code says. The numbers are part of the command line's contract.
enum class Exit : int {
  ok = 0,
  disagreement = 1,
  usage = 2,
  bad_input = 3,
  fp_environment = 4,
  output_failed = 5,
  oracles_contradict = 6,
  resources = 7,
  incomplete = 8,
  interrupted = 130,
  terminated = 143,
};

constexpr int code(Exit e) { return static_cast<int>(e); }

/// Ends the command with this exit code and one line on standard error.
class Failure : public std::runtime_error {
 public:
  Failure(Exit exit, const std::string& line) : std::runtime_error(line), exit_(exit) {}
  Exit exit() const { return exit_; }

 private:
  Exit exit_;
};

/// `file:line: what is wrong and what was expected`. Line 0 leaves the line number out.
inline Failure bad_input(const std::string& file, std::size_t line, const std::string& what) {
  return Failure(Exit::bad_input, file + ":" + (line > 0 ? std::to_string(line) + ":" : "") + " " + what);
}

}  // namespace tribunal
