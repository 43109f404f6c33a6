// The commands of this room.
#pragma once

#include "exact/cli/command.h"

namespace tribunal {

Action declare_render(Arguments& arguments);
Action declare_leak(Arguments& arguments);
Action declare_judge(Arguments& arguments);
Action declare_demo(Arguments& arguments);

}  // namespace tribunal
