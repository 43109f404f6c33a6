// Mesh files: OFF, OBJ, PLY and STL, by extension.
#pragma once

#include <string>

#include "tracer/mesh/mesh.h"

namespace tribunal {

/// The mesh in this file, in its own units, faces with more than three corners as fans. The file is scanned by us
/// (scan.h), read by CGAL, and the two compared. Text numbers are rounded to binary64 correctly, STL and binary
/// PLY coordinates taken as they are. Fails with Exit::bad_input, one line `file:line: …` where there are lines:
/// missing, a directory, empty, unknown extension, and all that the scan refuses.
Mesh read_mesh(const std::string& path);

}  // namespace tribunal
