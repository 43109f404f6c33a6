#include "exact/cli/program.h"

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <new>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "exact/base/failure.h"
#include "exact/base/files.h"
#include "exact/base/fp_environment.h"

namespace tribunal {
namespace {

/// A command of the table with the parser and the action that it declared.
struct Declared {
  const CLI::App* parser;
  Action action;
};

std::vector<Declared> declare(CLI::App& app, std::span<const Command> commands) {
  std::vector<Declared> declared;
  for (const Command& command : commands) {
    CLI::App* const parser = app.add_subcommand(command.name, command.summary);
    parser->footer(std::string("Example:\n  ") + command.example);
    declared.push_back({parser, command.declare(*parser)});
  }
  return declared;
}

/// The full name of the command that was being parsed: "tribunal", or "tribunal fuzz".
std::string parsed_name(const CLI::App& app) {
  const auto chosen = app.get_subcommands();
  return chosen.empty() ? app.get_name() : app.get_name() + " " + chosen.front()->get_name();
}

Failure usage_failure(const CLI::App& app, std::string what) {
  std::replace(what.begin(), what.end(), '\n', ' ');
  return Failure(Exit::usage, what + " (see " + parsed_name(app) + " --help)");
}

int parse_and_run(std::span<const Command> commands, int argc, char** argv) {
  CLI::App app("Puts ray- and segment-polygon intersection tests on trial against exact arithmetic.", "tribunal");
  app.set_version_flag("--version", "tribunal " TRIBUNAL_VERSION);
  app.require_subcommand(0, 1);
  app.footer("`tribunal COMMAND --help` says more, with an example.");
  const std::vector<Declared> declared = declare(app, commands);
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    print(app.help());
    return code(Exit::ok);
  } catch (const CLI::CallForVersion&) {
    print(app.version() + "\n");
    return code(Exit::ok);
  } catch (const CLI::ParseError& error) {
    throw usage_failure(app, error.what());
  }
  const auto chosen =
      std::find_if(declared.begin(), declared.end(), [](const Declared& d) { return d.parser->parsed(); });
  if (chosen != declared.end()) return chosen->action();
  std::fputs(app.help().c_str(), stderr);
  return code(Exit::usage);
}

int fail(Exit exit, const std::string& line) {
  std::fprintf(stderr, "%s%s\n", exit == Exit::bad_input ? "" : "tribunal: ", line.c_str());
  return code(exit);
}

}  // namespace

int run_program(std::span<const Command> commands, int argc, char** argv) {
  std::signal(SIGPIPE, SIG_IGN);  // a closed pipe is then a failed write, which has its own exit code
  try {
    require_exact_rounding();
    return parse_and_run(commands, argc, argv);
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
