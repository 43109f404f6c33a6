// Star-shaped rings with rounded vertices, and segments near them.
#pragma once

#include "exact/cases/families/draw.h"
#include "exact/cases/families/family.h"

namespace tribunal {

/// A star-shaped ring of n vertices in a random plane of [−1, 1]³, each vertex rounded: as planar as the polygons of a
/// modelling program; and a segment, rounded too, aimed at a vertex, a point of an edge or spoke, or anywhere near.
struct Star {
  PolygonData polygon;
  Segment through;
};

Star draw_star(Draw& draw, Format format, int n);

}  // namespace tribunal
