// Mesh files: OFF, OBJ, PLY and STL, by extension.
#pragma once

#include <string>
#include <string_view>

#include "exact/mesh/mesh.h"
#include "exact/mesh/soup.h"

namespace tribunal {

/// The mesh in this file, in its own units; faces with more than three corners as mesh_of makes them. A numeral is
/// rounded to binary64 correctly (to binary32 first where a PLY header says float), binary coordinates are taken as
/// they are. Fails with Exit::bad_input, one line `file:line: …`, or `file: byte N: …` in binary files, if it is
/// missing, a directory, empty, of an unknown extension, or refused by the reader of the format (readers.h).
Mesh read_mesh(const std::string& path);

/// Whether the name of this file ends as a mesh's does, in any case of letters.
bool is_mesh_name(const std::string& file);

/// Vertices and faces as they stand in a file of this name, whose bytes these are.
PolygonSoup read_soup(const std::string& file, std::string_view bytes);

}  // namespace tribunal
