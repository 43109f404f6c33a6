// The user's own data: what cases are made from, as it was read.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/format.h"
#include "core/query.h"

namespace tribunal {

/// A question of the user's.
struct OwnQuery {
  Query query;
  Format format = Format::binary64;
};

/// Where data came from. A scene's rays are of format binary64, and so are the triangles of a mesh.
enum class OwnKind : std::uint8_t { cases, mesh, scene };

/// What was read: whole questions, and triangles at which probes are still to be aimed. All with the same operands, and
/// all finite.
struct OwnData {
  OwnKind kind = OwnKind::cases;
  std::string file;
  std::string sha256{};  ///< of the file's bytes
  std::vector<OwnQuery> queries{};
  std::vector<Triangle> triangles{};
  std::size_t nonfinite = 0;       ///< questions left out because a number of theirs is not finite
  std::size_t other_operands = 0;  ///< questions left out because they are about polygons, or about triangles
};

/// The questions of a case file about the wanted operands; if none are wanted, those about triangles if there are any.
/// Fails with Exit::bad_input, also if no question is left.
OwnData read_own_cases(const std::string& file, std::optional<Operands> wanted);

/// The faces of a mesh file, triangulated. Fails with Exit::bad_input as read_mesh does.
OwnData read_own_mesh(const std::string& file);

}  // namespace tribunal
