// The loops in which a plugin's test is timed: its functions are called as a C program would call them.
#pragma once

#include "core/native.h"
#include "exact/plugin/line.h"

namespace tribunal {

/// Of a plugin that has a test of triangles, by probes of this kind. They run in this process; what the test throws is
/// thrown.
NativeLoops native_loops_of(const tribunal_plugin& plugin, const PluginLine& line, int kind);

}  // namespace tribunal
