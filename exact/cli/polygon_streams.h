// Polygon families by name, and methods that take polygons.
#pragma once

#include <string>
#include <vector>

#include "exact/polygon/fuzz.h"

namespace tribunal {

/// The streams of the named polygon families ("polygon-affine,polygon-ulp"), or nothing if no name begins with
/// "polygon-". Fails with Exit::usage on an unknown name, or if the names mix polygon families with others.
std::vector<PolygonStream> polygon_streams_named(const std::string& comma_separated);

/// "; or polygon families, by themselves: polygon-affine (what it stresses) …", for help.
std::string polygon_family_help();

/// Fails with Exit::usage if the method takes no polygons.
void require_polygons(const Method& method);

}  // namespace tribunal
