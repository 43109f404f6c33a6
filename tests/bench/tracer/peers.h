// Programs that find the closest triangle on a ray, behind one interface.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "core/operands.h"
#include "exact/mesh/mesh.h"

namespace tribunal::bench {

/// A ray caster for one mesh, for use on a single thread.
class Caster {
 public:
  virtual ~Caster() = default;

  /// The index of the first triangle on each ray, −1 where it meets none; as many as there are rays.
  virtual void first_hits(std::span<const Ray> rays, std::span<std::int64_t> hits) = 0;

  /// Memory for all that rays need, in bytes; 0 where unknown.
  virtual std::size_t bytes() const = 0;
};

/// sf-filtered in the tracer's tree: a call for each ray.
std::unique_ptr<Caster> make_ours(const Mesh& mesh);

/// The same with a call for each 1024 rays.
std::unique_ptr<Caster> make_ours_batch(const Mesh& mesh);

/// Embree 3 in robust mode, rtcIntersect1 for each ray, its default build quality; binary32, not exact.
std::unique_ptr<Caster> make_embree(const Mesh& mesh);

/// CGAL's AABB tree on Exact_predicates_inexact_constructions_kernel, first_intersected_primitive for each
/// ray, there being no call for many; its precondition checks compiled out. Exact predicates, but hits are ordered by
/// rounded points.
std::unique_ptr<Caster> make_aabb(const Mesh& mesh);

}  // namespace tribunal::bench
