// The parts of which the rows of the table of relations are made.
#pragma once

#include "exact/relations/relation.h"

namespace tribunal {

/// One query from another; nothing where it does not exist exactly in the format.
using Changed = std::optional<Query>;
using Move = Changed (*)(const Query& query, Format format, Draw& draw);

/// Moves of space and other orders of the points, which keep the answer.
Changed vertex_order(const Query& query, Format format, Draw& draw);
Changed reversal(const Query& query, Format format, Draw& draw);
Changed axis_map(const Query& query, Format format, Draw& draw);
Changed uniform_scale(const Query& query, Format format, Draw& draw);
Changed axis_scale(const Query& query, Format format, Draw& draw);
Changed translation(const Query& query, Format format, Draw& draw);
Changed shear(const Query& query, Format format, Draw& draw);
Changed zero_signs(const Query& query, Format format, Draw& draw);
Changed direction_scale(const Query& query, Format format, Draw& draw);
Changed read_as_binary64(const Query& query, Format format, Draw& draw);

/// Larger operands, which keep a hit.
Changed longer_segment(const Query& query, Format format, Draw& draw);
Changed larger_triangle(const Query& query, Format format, Draw& draw);
Changed ray_of_segment(const Query& query, Format format, Draw& draw);

/// Parts of the operands, and degenerate operands that stand for each other.
std::optional<Instance> bounds_in_two(const Query& query, Format format, Draw& draw);
std::optional<Instance> probe_in_two(const Query& query, Format format, Draw& draw);
std::optional<Instance> triangle_in_two(const Query& query, Format format, Draw& draw);
std::optional<Instance> end_as_segment(const Query& query, Format format, Draw& draw);
std::optional<Instance> edge_as_triangle(const Query& query, Format format, Draw& draw);
std::optional<Instance> point_as_triangle(const Query& query, Format format, Draw& draw);
std::optional<Instance> segment_as_triangle(const Query& query, Format format, Draw& draw);

/// Evidence that can be checked: a hit has a common point, a miss a separating plane.
std::optional<Instance> hit_has_point(const Query& query, Format format, Draw& draw);
std::optional<Instance> miss_has_plane(const Query& query, Format format, Draw& draw);

/// Some query of `one` is a hit iff some of `other` is; the second: only if.
Instance equal(std::vector<Query> one, const std::vector<Query>& other);
Instance implies(std::vector<Query> one, const std::vector<Query>& other);

/// The move of a query; it leaves the bounds of a ray as they are, as all of these do.
template <Move move>
Changed moved_with_bounds(const Query& query, Format format, Draw& draw) {
  Changed changed = move(query, format, draw);
  if (changed) changed->bounds = query.bounds;
  return changed;
}

template <Move move>
std::optional<Instance> keeps_answer(const Query& query, Format format, Draw& draw) {
  const Changed changed = moved_with_bounds<move>(query, format, draw);
  return changed ? equal({query}, {*changed}) : std::optional<Instance>{};
}

template <Move move>
std::optional<Instance> keeps_hit(const Query& query, Format format, Draw& draw) {
  const Changed changed = moved_with_bounds<move>(query, format, draw);
  return changed ? implies({query}, {*changed}) : std::optional<Instance>{};
}

/// The sum, or x·2^e, if it is exact; else infinity.
double exact_sum(double x, double y);
double exact_scale(double x, int e);

/// Each coordinate is exact, or else infinite.
Point3 exact_sum(const Point3& x, const Point3& y);
Point3 exact_midpoint(const Point3& x, const Point3& y);

/// Whether p is finite and exact in the format.
bool fits(const Point3& p, Format format);

}  // namespace tribunal
