// The commands of this room.
#pragma once

#include "exact/cli/command.h"

namespace tribunal {

Action declare_render(CLI::App& app);
Action declare_demo(CLI::App& app);

}  // namespace tribunal
