// A shared library, loaded, with what it says of its plugin.
#pragma once

#include <string>

#include "exact/plugin/tribunal_plugin.h"

namespace tribunal {

/// What a library describes.
struct Library {
  const tribunal_plugin* plugin;
  const tribunal_polygon_plugin* polygons;  ///< nullptr if it has none
  const tribunal_mesh_plugin* meshes;       ///< nullptr if it has none
};

/// Loads the library into this process, for good. Fails with Exit::bad_input, naming the file, if it is missing, is no
/// library, or describes no plugin; what the description says is not looked at.
///
/// A library built with -ffast-math turns flushing to zero on as it is loaded; that is undone.
Library open_library(const std::string& file);

}  // namespace tribunal
