// A user's own tree over a mesh, from a shared library: what it says of itself, and its functions, asked with care.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/contract.h"
#include "core/operands.h"
#include "exact/plugin/tribunal_plugin.h"

namespace tribunal {

/// A mesh that a plugin has prepared: its functions may be asked from several threads. Fails with Exit::bad_input when
/// an answer is none, with Exit::disagreement when a function throws, with Exit::fp_environment when it changes the
/// floating-point environment; each in one line that names the file and the function.
class PreparedMesh {
 public:
  PreparedMesh(const tribunal_mesh_plugin& plugin, std::string file, std::span<const Point3> vertices,
               std::span<const std::size_t> corners);

  std::vector<tribunal_mesh_hit> closest(std::span<const Ray> rays) const;
  std::vector<tribunal_mesh_hit> all(const Ray& ray) const;
  std::vector<int> any(std::span<const Ray> rays) const;
  std::vector<int> inside(std::span<const Ray> rays) const;

 private:
  void require_face(const char* function, std::size_t face) const;
  void require_answers(const char* function, const std::vector<int>& answers) const;

  tribunal_mesh_plugin plugin_;
  std::string file_;
  std::size_t face_count_;
  std::shared_ptr<void> mesh_;
};

/// What a library says of its tree. The contract is that of its first description.
struct MeshPlugin {
  std::string name, file;
  Contract contract;
  tribunal_mesh_plugin functions;
};

/// Fails with Exit::bad_input if the description breaks the rules of tribunal_plugin.h.
MeshPlugin mesh_plugin(const tribunal_plugin& plugin, const tribunal_mesh_plugin& meshes, const std::string& file);

}  // namespace tribunal
