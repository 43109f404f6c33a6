// Checks what a plugin says about itself, and makes the name, card and contract of a method of it. All functions fail
// with Exit::bad_input, naming the file, where the description breaks the rules of tribunal_plugin.h.
#pragma once

#include <string>

#include "core/method.h"
#include "exact/plugin/tribunal_plugin.h"

namespace tribunal {

/// Fails if the library was made for a version of the header that is not read here.
void require_version(int abi, const std::string& file);

/// The description with all fields of this version: those that a library of version 1 does not have are zero, and
/// nothing behind the ones that it has is read.
tribunal_plugin in_this_version(const tribunal_plugin& plugin, const std::string& file);

/// The same of a tree.
tribunal_mesh_plugin in_this_version(const tribunal_mesh_plugin& meshes, const std::string& file);

/// The method without its functions. The description must be in this version.
Method described(const tribunal_plugin& plugin, const std::string& file);

/// Adds to the contract what the plugin promises about polygons.
void read_restrictions(Contract& contract, const tribunal_polygon_plugin& polygons, const std::string& file);

}  // namespace tribunal
