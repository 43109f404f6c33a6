// Levels of stress axes that families of triangles and of polygons share.
#pragma once

#include "exact/cases/families/shapes.h"

namespace tribunal {

/// log2 of the scale of integers of 40 to 53 bits (binary32: 11 to 24) at which they, their squares or their cubes
/// reach an end of the format's range.
inline constexpr int extreme_scales_64[] = {-1074, -1066, -1050, -1022, -586, -537, -400,
                                            -358,  230,   289,   459,   600,  970};
inline constexpr int extreme_scales_32[] = {-149, -144, -137, -126, -84, -74, -57, -50, 19, 27, 40, 60, 103};
inline constexpr auto extreme_scales = by_format<extreme_scales_64, extreme_scales_32>;

/// log2 of the largest over the least number on one axis.
inline constexpr int spreads_64[] = {8, 40, 100, 200, 310, 500, 800, 1200, 1600, 2096};
inline constexpr int spreads_32[] = {8, 30, 60, 100, 150, 200, 240, 274};
inline constexpr auto coordinate_spreads = by_format<spreads_64, spreads_32>;

/// log2 of the size of a ray's direction over that of the geometry.
inline constexpr int ratios_64[] = {-2000, -1500, -1100, -900, -800, -700, -600, -400, -200,
                                    -60,   0,     60,    200,  400,  600,  1000, 1500, 2000};
inline constexpr int ratios_32[] = {-240, -180, -140, -100, -50, -20, 0, 20, 50, 100, 180, 240};
inline constexpr auto direction_ratios = by_format<ratios_64, ratios_32>;

/// log2 of the size of the geometry.
inline constexpr int sizes_64[] = {-1000, -700, -500, -340, -200, -120, -60, -20, 0, 20, 120, 200, 340, 500, 700, 1000};
inline constexpr int sizes_32[] = {-120, -90, -70, -50, -35, -20, -10, 0, 10, 20, 35, 50, 80, 110};
inline constexpr auto geometry_sizes = by_format<sizes_64, sizes_32>;

}  // namespace tribunal
