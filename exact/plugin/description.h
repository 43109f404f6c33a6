// What a plugin says of itself, checked: name, card and contract of a method. All fail with Exit::bad_input, naming the
// file, where the description breaks the rules of tribunal_plugin.h.
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

/// The method without its functions. The description is in this version.
Method described(const tribunal_plugin& plugin, const std::string& file);

/// Adds what the method promises of polygons.
void read_restrictions(Contract& contract, const tribunal_polygon_plugin& polygons, const std::string& file);

}  // namespace tribunal
