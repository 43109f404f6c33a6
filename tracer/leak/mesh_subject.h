// The functions of a mesh plugin on trial, each by itself.
#pragma once

#include <vector>

#include "exact/plugin/mesh_plugin.h"
#include "tracer/leak/subject.h"

namespace tribunal::leak {

/// One subject for each function that the plugin has: NAME/closest, /any, /all, /inside. The mesh is prepared here.
/// Every ray is asked of them, with the mesh's faces by their numbers; `inside` of a closed surface only.
std::vector<Subject> subjects_of(const MeshPlugin& plugin, const Surface& surface);

}  // namespace tribunal::leak
