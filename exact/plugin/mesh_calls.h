// The calls of a tree's functions on one prepared mesh, in this process or in another.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "exact/plugin/calls.h"

namespace tribunal {

/// The functions of one tree on one mesh, as tribunal_plugin.h has them: six coordinates a ray. May be called from
/// several threads at once. Every call fails with CallFailed where the plugin does something else than return. What a
/// function leaves unwritten is a face that there is not, an answer of −1, a normal of NaN.
class MeshCalls {
 public:
  virtual ~MeshCalls() = default;

  /// Normals are written if the tree has `closest_normal`.
  virtual void closest(std::span<const double> rays, std::span<tribunal_mesh_hit> hits,
                       std::span<tribunal_mesh_normal> normals) const = 0;
  virtual void any(std::span<const double> rays, std::span<int> answers) const = 0;
  virtual void inside(std::span<const double> rays, std::span<int> answers) const = 0;
  /// The hits of all rays, one after the other; counts[i] are those of ray i.
  virtual std::vector<tribunal_mesh_hit> all(std::span<const double> rays, std::span<std::size_t> counts) const = 0;

  /// Whether the tree lives in a process of its own, so that a fault does not end this one.
  virtual bool isolated() const = 0;
  /// The most rays that one call should have.
  virtual std::size_t largest_batch() const = 0;
};

/// Prepares a mesh with the loaded functions: x, y, z of each vertex, three corners a face. Fails with CallFailed. The
/// description must be in this version.
std::shared_ptr<const MeshCalls> mesh_calls_here(const tribunal_mesh_plugin& plugin, std::span<const double> vertices,
                                                 std::span<const std::size_t> corners);

}  // namespace tribunal
