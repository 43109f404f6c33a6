// Whoever finds the closest triangle on a ray, under one interface.
#pragma once

#include <cstdint>
#include <memory>

#include "core/query.h"
#include "tracer/mesh/mesh.h"

namespace tribunal::bench {

/// A mesh made ready for rays. One thread.
class Caster {
 public:
  virtual ~Caster() = default;

  /// The index of the first triangle on the ray, −1 where it meets none.
  virtual std::int64_t first_hit(const Ray& ray) = 0;

  /// Memory for all that rays need, in bytes; 0 where unknown.
  virtual std::size_t bytes() const = 0;
};

/// sf-filtered in the tracer's tree.
std::unique_ptr<Caster> make_ours(const Mesh& mesh);

/// Embree 3 in robust mode, rtcIntersect1, its default build quality; binary32, not exact.
std::unique_ptr<Caster> make_embree(const Mesh& mesh);

/// CGAL's AABB tree on Exact_predicates_inexact_constructions_kernel, first_intersected_primitive; its precondition
/// checks compiled out. Exact predicates, but hits are ordered by rounded points.
std::unique_ptr<Caster> make_aabb(const Mesh& mesh);

}  // namespace tribunal::bench
