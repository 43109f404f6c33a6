// From the command line to an exit code: what every command shares.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "exact/cli/command.h"

namespace tribunal {

/// Runs the command of the table that the words name, and returns its exit code. The words are those after the
/// program's name. Whatever goes wrong is thrown.
int run_command(std::span<const Command> commands, const std::vector<std::string>& words);

/// The same for the command line of the program, but nothing is thrown: whatever goes wrong becomes an exit code and
/// one line on standard error, `file:line: …` for bad input, `tribunal: …` for the rest.
int run_program(std::span<const Command> commands, int argc, char** argv);

}  // namespace tribunal
