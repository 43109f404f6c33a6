// The scan of a mesh file before CGAL sees it: every count, index and number is checked here, where the line
// number is known and before anything is allocated for what a header announces.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace tribunal {

/// What a reader must return for this file; anything else is refused.
struct ScannedMesh {
  std::optional<std::size_t> vertices;  ///< empty for STL, where CGAL merges equal corners
  std::vector<std::size_t> degrees;     ///< number of corners of each face, each ≥ 3
};

/// Each throws bad_input(file, line or 0, …) for anything it would not stake an image on: a wrong magic word, counts
/// negative or beyond the file's size, truncation, trailing garbage, an index out of range, a face with fewer than
/// three corners, a number that is not finite. Each may rewrite the bytes into the dialect that CGAL reads.
ScannedMesh scan_off(const std::string& file, std::string& bytes);
ScannedMesh scan_obj(const std::string& file, std::string& bytes);
ScannedMesh scan_ply(const std::string& file, std::string& bytes);
ScannedMesh scan_stl(const std::string& file, std::string& bytes);

/// Text formats have no NUL bytes. Also turns carriage returns and tabs into blanks, which all of them allow.
void require_text(const std::string& file, std::string& bytes);

}  // namespace tribunal
