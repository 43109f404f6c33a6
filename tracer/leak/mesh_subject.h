// The functions of a mesh plugin on trial, each by itself.
#pragma once

#include <vector>

#include "exact/plugin/mesh_plugin.h"
#include "tracer/leak/subject.h"

namespace tribunal::leak {

/// One subject for each function that the plugin has: NAME/closest, /any, /all, /inside. Prepares the plugin's mesh.
/// Each function gets every ray and returns faces by their numbers in the mesh; `inside` is tried on closed surfaces
/// only.
std::vector<Subject> subjects_of(const MeshPlugin& plugin, const Surface& surface);

}  // namespace tribunal::leak
