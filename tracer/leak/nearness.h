// Which vertices and edges a ray passes within rounding.
#pragma once

#include "core/format.h"
#include "core/operands.h"

namespace tribunal::leak {

/// What a test in rounded arithmetic may take a ray to pass on either side: what comes within 16 units in the last
/// place, of the largest coordinate of the source and of the vertex or edge. A test that rounds each difference of
/// coordinates, and a few times more, moves points by no more than that.
///
/// Decided exactly: squares of distances are compared, in dyadic rationals where doubles cannot tell.
class Nearness {
 public:
  Nearness(const Ray& ray, Format format) : ray_(ray), format_(format) {}

  /// Whether the point lies within that distance of the ray's line, and not behind the source.
  bool has(const Point3& p) const;

  /// The same of the edge's line, where the two lines come closest within the edge. A parallel edge is near if an end
  /// of it is.
  bool has(const Point3& a, const Point3& b) const;

  /// Whether the source lies so near the triangle that a step along a diagonal crosses it.
  bool source_is_at(const Triangle& t) const;

 private:
  double slack(std::initializer_list<Point3> points) const;

  Ray ray_;
  Format format_;
};

}  // namespace tribunal::leak
