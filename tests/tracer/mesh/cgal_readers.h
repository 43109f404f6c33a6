// CGAL's soup readers behind one door: this header includes no CGAL.
#pragma once

#include <string>

#include "tracer/mesh/mesh.h"

namespace tribunal {

enum class MeshFormat { off, obj, ply, stl };

/// What CGAL reads from these bytes, or false where it gives up. It accepts too much (indices out of range,
/// NaN) and allocates what a header announces: call it after the scan, and check what it returns.
bool read_soup(MeshFormat format, const std::string& bytes, PolygonSoup& soup);

}  // namespace tribunal
