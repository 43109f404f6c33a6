// The rows of the table of polygon families, each made in the file of its name.
#pragma once

#include "exact/cases/families/family.h"

namespace tribunal {

/// All families of polygons.
std::span<const Family> polygon_families();

Family polygon_affine_family();
Family polygon_scale_family();
Family polygon_zeros_family();
Family polygon_extreme_family();
Family polygon_overflow_family();
Family polygon_distance_family();
Family polygon_direction_family();
Family polygon_ulp_family();
Family polygon_in_plane_family();
Family polygon_point_family();
Family polygon_grid_family();
Family polygon_warped_family();
Family polygon_spread_family();
Family polygon_rounded_family();
Family polygon_size_family();
Family polygon_many_family();

}  // namespace tribunal
