#include "exact/cli/program.h"

#include <csignal>
#include <cstdio>
#include <locale>
#include <new>
#include <string>
#include <system_error>
#include <vector>

#include "exact/base/failure.h"
#include "exact/base/files.h"
#include "exact/base/fp_environment.h"
#include "exact/base/interrupt.h"
#include "exact/base/plain_locale.h"
#include "exact/base/shown.h"
#include "exact/base/sudden_end.h"

namespace tribunal {
namespace {

/// How long a line of an error may be. What ends with a whole case, for whoever wants to replay it, may be longer.
constexpr std::size_t longest_line(Exit e) {
  return e == Exit::disagreement || e == Exit::oracles_contradict ? std::size_t{1} << 20 : 1000;
}

/// The only way of a message to standard error.
int fail(Exit exit, const std::string& line) {
  const std::string text = shown_shortly(line, longest_line(exit));
  // Static objects may have been made in another rounding mode; CGAL's would abort as they are destroyed.
  if (exit == Exit::fp_environment) end_at_once(exit, text);
  std::fprintf(stderr, "%s%s\n", exit == Exit::bad_input ? "" : "tribunal: ", text.c_str());
  return code(exit);
}

}  // namespace

int run_command(std::span<const Command> commands, const std::vector<std::string>& words) {
  CommandLine line({.name = "tribunal",
                    .summary = "Puts ray- and segment-polygon intersection tests on trial against exact arithmetic.",
                    .footer = "`tribunal COMMAND --help` says more, with an example.",
                    .version = "tribunal " TRIBUNAL_VERSION});
  std::vector<Action> actions;
  for (const Command& command : commands) {
    Arguments arguments = line.add(command.name, command.summary, std::string("Example:\n  ") + command.example);
    actions.push_back(command.declare(arguments));
  }
  if (const auto text = line.parse(words)) {
    print(*text);
    return code(Exit::ok);
  }
  if (const auto chosen = line.chosen()) return actions[*chosen]();
  std::fputs(line.help().c_str(), stderr);
  return code(Exit::usage);
}

int run_program(std::span<const Command> commands, int argc, char** argv) {
  install_last_resort();
  use_plain_locale();
  std::signal(SIGPIPE, SIG_IGN);  // a closed pipe is then a failed write, which has its own exit code
  std::signal(SIGXFSZ, SIG_IGN);  // and so is a file that would become larger than the limit
  watch_interrupts();
  try {
    std::locale::global(std::locale::classic());
    refuse_changed_rounding();  // it was repaired before static objects were made
    const int exit = run_command(commands, std::vector<std::string>(argv + 1, argv + argc));
    require_exact_rounding();  // all is written; CGAL aborts at exit if it finds another mode
    return exit;
  } catch (const Failure& failure) {
    return fail(failure.exit(), failure.what());
  } catch (const std::bad_alloc&) {
    return fail(Exit::resources, "out of memory");
  } catch (const std::length_error& error) {
    return fail(Exit::resources, std::string("too large: ") + error.what());
  } catch (const std::system_error& error) {
    return fail(Exit::resources, error.what());
  } catch (const std::exception& error) {
    return fail(Exit::resources, std::string("unexpected: ") + error.what());
  }
}

}  // namespace tribunal
