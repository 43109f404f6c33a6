// The commands of this room.
#pragma once

#include "exact/cli/command.h"

namespace tribunal {

Action declare_certify(CLI::App& app);
Action declare_verify(CLI::App& app);
Action declare_render(CLI::App& app);
Action declare_chart(CLI::App& app);
Action declare_demo(CLI::App& app);

}  // namespace tribunal
