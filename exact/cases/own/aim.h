// Probes aimed at the vertices, edges and faces of a target of the user's, as they round and next to them.
#pragma once

#include "core/format.h"
#include "exact/cases/families/draw.h"
#include "exact/cases/own/parts.h"

namespace tribunal {

/// A point of the target, not yet rounded to the format: a vertex, a point of an edge, or a point in its face or
/// beside it.
Point3 draw_feature(const Parts& parts, Format format, Draw& draw);

/// A point from which probes are aimed: a vertex of the other target, or a point about as far out as `extent`.
Point3 draw_from(const Parts& other, double extent, Format format, Draw& draw);

/// A probe aimed at the target, a ray or a segment, not yet rounded to the format: from a point through a point of the
/// target, or ending there, or starting there, or along an edge; every other time some units in the last place beside
/// it. A ray's direction is as long as the way, or 1, or of another size.
Probe draw_aimed(bool is_ray, const Parts& parts, const Point3& from, Format format, Draw& draw);

/// The probe moved, without turning, to a point of the target.
Probe draw_shifted(const Parts& parts, const Probe& probe, Format format, Draw& draw);

}  // namespace tribunal
