// The commands of this room.
#pragma once

#include "exact/cli/command.h"

namespace tribunal {

/// fuzz, with scenes.
Action declare_fuzz(Arguments& arguments);
/// sweep, with the axis of a mesh.
Action declare_sweep(Arguments& arguments);
Action declare_render(Arguments& arguments);
Action declare_leak(Arguments& arguments);
Action declare_judge(Arguments& arguments);
Action declare_chart(Arguments& arguments);
Action declare_demo(Arguments& arguments);

}  // namespace tribunal
