// The parts of which the rows of the table of relations between answers about polygons are made.
#pragma once

#include "exact/relations/rows.h"

namespace tribunal {

/// Other lists of vertices for the same planar polygon.
Changed start_vertex(const Query& query, Format format, Draw& draw);
Changed ring_direction(const Query& query, Format format, Draw& draw);
Changed ring_order(const Query& query, Format format, Draw& draw);

/// Additional vertices that do not change the polygon.
Changed repeated_vertex(const Query& query, Format format, Draw& draw);
Changed flat_vertex(const Query& query, Format format, Draw& draw);

/// Moves of space, and of the probe, that keep the answer.
Changed reversed_segment(const Query& query, Format format, Draw& draw);
Changed signed_axes(const Query& query, Format format, Draw& draw);
Changed powers_of_two(const Query& query, Format format, Draw& draw);

/// What stays the same when the query is changed: hit, planar and contact; or hit and planar only.
enum class Kept { all, hit_and_plane };

std::optional<Instance> kept_by(const Query& query, const Changed& changed, Kept kept);

bool is_planar(const Query& query);

template <Move move>
std::optional<Instance> keeps_all(const Query& query, Format format, Draw& draw) {
  return kept_by(query, move(query, format, draw), Kept::all);
}

/// For planar polygons only: the covering of others, and so their surface, may change.
template <Move move>
std::optional<Instance> keeps_all_if_planar(const Query& query, Format format, Draw& draw) {
  return is_planar(query) ? keeps_all<move>(query, format, draw) : std::optional<Instance>{};
}

template <Move move>
std::optional<Instance> keeps_hit_and_plane(const Query& query, Format format, Draw& draw) {
  return kept_by(query, move(query, format, draw), Kept::hit_and_plane);
}

}  // namespace tribunal
