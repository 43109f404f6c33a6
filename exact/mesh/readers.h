// One reader a format. Each takes the bytes of a file whole, and its name for messages.
#pragma once

#include <string>
#include <string_view>

#include "exact/mesh/soup.h"

namespace tribunal {

/// Each accepts what read_mesh.h says, or throws bad_input with the line and column, in binary files the byte: a wrong
/// magic word, counts that are negative or beyond the file's size, truncation, trailing data, an index out of
/// range, a face with fewer than three corners, a coordinate that is not finite, a file without vertices or faces.
/// Nothing is allocated for what a header announces before the file's size has been found to hold it. Files are at most
/// 2^32 bytes, so that 32 bits count everything in them.
PolygonSoup read_off(const std::string& file, std::string_view bytes);
PolygonSoup read_obj(const std::string& file, std::string_view bytes);
PolygonSoup read_ply(const std::string& file, std::string_view bytes);
PolygonSoup read_stl(const std::string& file, std::string_view bytes);

}  // namespace tribunal
