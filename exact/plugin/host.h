// The two ends of the conversation with an isolated plugin: what is asked, and the child that answers.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "exact/base/fault.h"
#include "exact/plugin/tribunal_plugin.h"
#include "exact/plugin/wire.h"

namespace tribunal {

/// The first message of a child: what its library describes, or why it could not be loaded. The function pointers in
/// the descriptions are the child's: in this process they only say which functions exist.
struct Introduction {
  int failed_with = 0;  ///< an exit code, and `failure` says why
  std::string failure{};
  tribunal_plugin plugin{};  ///< in this version
  std::optional<std::string> name{}, contract{}, summary{}, reference{};
  bool takes_polygons = false;
  tribunal_polygon_plugin polygons{};
  bool has_tree = false;
  tribunal_mesh_plugin meshes{};  ///< in this version
};

/// The introduction, from a message; nothing if it is none.
std::optional<Introduction> introduction_in(std::vector<char> bytes);

/// Whether all that this process reads of them is the same: texts, numbers, and which functions exist.
bool describes_the_same(const Introduction& a, const Introduction& b);

/// How queries are to be asked. About triangles: one after the other; by one call of the plugin's batch function; one
/// query by the function that also describes the hit; one query after preparing its triangle; or one ray with bounds.
/// About a mesh: `mesh` prepares one, and the questions after it are about the last one that was prepared.
enum class Kind : int {
  each,
  batch,
  tell,
  prepared,
  within,
  polygon,
  mesh,
  mesh_closest,
  mesh_any,
  mesh_all,
  mesh_inside
};

Message question(Kind kind, int probe, std::size_t n, const double* queries);
Message question(int probe, const double* triangle, const double* coordinates);
Message question(int probe, const double* coordinates, const tribunal_polygon& polygon);
Message question_within(const double* query, const double* bounds);
Message question(std::span<const double> vertices, std::span<const std::size_t> corners);
Message question(Kind kind, std::span<const double> rays);

/// The reply of a child: one answer to each query, or the fault.
struct Reply {
  Fault fault{};
  std::vector<int> answers{};
  tribunal_hit hit{};  ///< of Kind::tell
  /// Of Kind::mesh_closest, one a ray; of Kind::mesh_all, those of all rays, and the answers are their numbers.
  std::vector<tribunal_mesh_hit> hits{};
  std::vector<tribunal_mesh_normal> normals{};  ///< of Kind::mesh_closest
};

/// The reply, from a message; nothing if it is none.
std::optional<Reply> reply_in(std::vector<char> bytes);

/// What a child does: loads the library, introduces it, and answers until the socket is closed.
void host_plugin(const std::string& file, int socket);

}  // namespace tribunal
