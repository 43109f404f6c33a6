// The rows of the table of polygon families, each made in the file of its name.
#pragma once

#include "exact/polygon/family.h"

namespace tribunal {

PolygonFamily polygon_affine_family();
PolygonFamily polygon_scale_family();
PolygonFamily polygon_zeros_family();
PolygonFamily polygon_extreme_family();
PolygonFamily polygon_overflow_family();
PolygonFamily polygon_distance_family();
PolygonFamily polygon_direction_family();
PolygonFamily polygon_ulp_family();
PolygonFamily polygon_in_plane_family();
PolygonFamily polygon_point_family();
PolygonFamily polygon_grid_family();
PolygonFamily polygon_warped_family();
PolygonFamily polygon_spread_family();
PolygonFamily polygon_rounded_family();
PolygonFamily polygon_size_family();
PolygonFamily polygon_many_family();

}  // namespace tribunal
