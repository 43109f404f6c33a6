// From the command line to an exit code: what every command shares.
#pragma once

#include <span>

#include "exact/cli/command.h"

namespace tribunal {

/// Parses the command line against the table, runs the command it names, and returns the exit code. Whatever goes
/// wrong is one line on standard error: `file:line: …` for bad input, `tribunal: …` for the rest.
int run_program(std::span<const Command> commands, int argc, char** argv);

}  // namespace tribunal
