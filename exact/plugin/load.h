// A user's own intersection test, in a shared library, as a method.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/method.h"
#include "exact/plugin/calls.h"
#include "exact/plugin/mesh_plugin.h"
#include "exact/plugin/tribunal_plugin.h"

namespace tribunal {

/// Seconds within which an isolated plugin must answer; nothing for a plugin in our own process.
using Isolation = std::optional<double>;

/// Loads the library, adds its method to the table (exact/methods/methods.h) and returns the method's name. The library
/// stays loaded until the program ends; with isolation it is loaded in child processes only (isolated.h). Before any
/// thread starts. Fails with Exit::bad_input, naming the file, if it is missing, is no library, or describes no method
/// (below); with Exit::usage if the method's name is taken.
std::string load_plugin(const std::string& file, const Isolation& isolation = {});

/// The methods that were loaded so far, by name, and the trees over meshes. A library that has a tree and no test of
/// its own adds no method.
const std::vector<std::string>& loaded_methods();
const std::vector<MeshPlugin>& loaded_meshes();

/// The method described. Fails with Exit::bad_input if the description breaks the rules of tribunal_plugin.h; only
/// `abi` is read of one for another version. `file` stands for the plugin in messages.
///
/// The method fails with Exit::bad_input when the plugin gives an answer that is none, with Exit::fp_environment
/// when it changes the floating-point environment: the judges run on the same thread; and with Exit::disagreement, one
/// line and the case when it throws. Coordinates beyond binary32 that would round to infinity are outside a binary32
/// plugin's contract.
///
/// `polygons` is the description of its polygon test, or nullptr if it has none.
Method plugin_method(const tribunal_plugin& plugin, const std::string& file,
                     const tribunal_polygon_plugin* polygons = nullptr);

/// The same, asked by these calls; the functions in the description only say which exist. If the plugin is isolated,
/// its faults, and numbers that stand for no answer, become answers with that status.
Method plugin_method(const tribunal_plugin& plugin, const std::string& file, const tribunal_polygon_plugin* polygons,
                     const std::shared_ptr<const PluginCalls>& calls);

}  // namespace tribunal
