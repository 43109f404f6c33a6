// A user's own tree over a mesh, from a shared library: what it says of itself, and its functions, asked with care.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/contract.h"
#include "core/operands.h"
#include "exact/plugin/mesh_calls.h"

namespace tribunal {

/// An answer of a tree, or the fault that there was instead.
template <class Answer>
struct Told {
  Answer answer{};
  Fault fault{};
};

struct ClosestHit {
  tribunal_mesh_hit hit{};
  tribunal_mesh_normal normal{};  ///< if the tree tells normals
};

/// A mesh that a plugin has prepared: its functions may be asked from several threads. Of a tree in this process every
/// fault ends the command in one line that names the file and the function: with Exit::bad_input when an answer is
/// none, with Exit::disagreement when a function throws, with Exit::fp_environment when it changes the floating-point
/// environment. Of an isolated tree it is told in place of the answer; a batch that fails is asked again ray by ray.
class PreparedMesh {
 public:
  PreparedMesh(std::shared_ptr<const MeshCalls> calls, std::string file, std::size_t face_count)
      : calls_(std::move(calls)), file_(std::move(file)), face_count_(face_count) {}

  std::vector<Told<ClosestHit>> closest(std::span<const Ray> rays) const;
  std::vector<Told<std::vector<tribunal_mesh_hit>>> all(std::span<const Ray> rays) const;
  std::vector<Told<int>> any(std::span<const Ray> rays) const;
  std::vector<Told<int>> inside(std::span<const Ray> rays) const;

 private:
  template <class Answer, class Ask, class Wrong>
  std::vector<Told<Answer>> told(const char* function, std::span<const Ray> rays, const Ask& ask,
                                 const Wrong& wrong) const;
  template <class Answer, class Ask>
  void tell(const char* function, std::span<const double> rays, const Ask& ask, std::span<Told<Answer>> told) const;

  std::string wrong_face(std::size_t face) const;

  std::shared_ptr<const MeshCalls> calls_;
  std::string file_;
  std::size_t face_count_;
};

/// Makes the calls on a mesh: x, y, z of each vertex, three corners a face.
using PrepareMesh =
    std::function<std::shared_ptr<const MeshCalls>(std::span<const double>, std::span<const std::size_t>)>;

/// What a library says of its tree. The contract is that of its first description. The functions in `functions` only
/// say which exist.
struct MeshPlugin {
  std::string name, file;
  Contract contract;
  tribunal_mesh_plugin functions;
  PrepareMesh prepare;

  bool has_closest() const { return functions.closest != nullptr || functions.closest_normal != nullptr; }
};

/// Fails with Exit::bad_input if the description, which must be in this version, breaks the rules of tribunal_plugin.h.
MeshPlugin mesh_plugin(const tribunal_plugin& plugin, const tribunal_mesh_plugin& meshes, const std::string& file,
                       PrepareMesh prepare);

/// Prepares a mesh. A fault ends the command in one line.
PreparedMesh prepare(const MeshPlugin& plugin, std::span<const Point3> vertices, std::span<const std::size_t> corners);

}  // namespace tribunal
