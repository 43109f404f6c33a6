// A tree in processes of its own.
#pragma once

#include <memory>
#include <span>

#include "exact/plugin/children.h"
#include "exact/plugin/mesh_calls.h"

namespace tribunal {

/// Prepares the mesh in a child, and in each that follows: one for each thread that asks at a time, and one in place of
/// each that a fault has ended. To prepare it a child has ten times the time limit, and 10 s at least. Fails with
/// CallFailed.
std::shared_ptr<const MeshCalls> isolated_mesh_calls(const std::shared_ptr<const PluginChildren>& children,
                                                     std::span<const double> vertices,
                                                     std::span<const std::size_t> corners);

}  // namespace tribunal
